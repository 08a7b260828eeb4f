#pragma once

#include <string>

namespace platform {

/// Returns the part of a link behind its '#'; of text without '#' the whole, of an address without '#' "".
std::string fragment_of(const std::string& link);

} // namespace platform
