#include "platform/program/arguments.h"

namespace platform {

Arguments::Arguments(int count, char* const* arguments, const option* known)
    : count_(count), arguments_(arguments), known_(known)
{
    opterr = 0; // what is wrong is said here
}

std::optional<Argument> Arguments::next()
{
    // '-' has what is no option given in its place, ':' has a missing value told from an unknown option.
    const int found = options_ended_ ? -1 : getopt_long(count_, arguments_, "-:", known_, nullptr);
    if (found == ':') {
        return Argument{optopt, ""};
    }
    if (found == '?') {
        // One letter may stand among others; of a long option getopt_long knows no more than where it was.
        const std::string name = optopt > 0 && optopt < FIRST_OPTION
                                     ? std::string("-") + static_cast<char>(optopt)
                                     : std::string(arguments_[optind - 1]);
        fault_ = optopt >= FIRST_OPTION ? name.substr(0, name.find('=')) + " takes no value."
                                        : "The option " + name + " is unknown.";
        return std::nullopt;
    }
    if (found != -1) {
        return Argument{found, optarg != nullptr ? optarg : ""};
    }
    options_ended_ = true; // by "--", perhaps: what follows that is no option, whatever it begins with
    return optind < count_ ? std::optional(Argument{NO_OPTION, arguments_[optind++]}) : std::nullopt;
}

std::string take_link(const std::string& given, std::optional<std::string>& link)
{
    if (link) {
        return "There are two links, '" + *link + "' and '" + given +
               "': give one (quote it, '&' ends a shell command).";
    }
    link = given;
    return "";
}

} // namespace platform
