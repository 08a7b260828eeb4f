#include "platform/program/link_argument.h"

namespace platform {

std::string fragment_of(const std::string& link)
{
    const std::size_t hash = link.find('#');
    if (hash != std::string::npos) {
        return link.substr(hash + 1);
    }
    return link.find("://") == std::string::npos ? link : "";
}

} // namespace platform
