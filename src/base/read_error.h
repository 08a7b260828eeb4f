#pragma once

#include <string>

namespace base {

/// Says why a file could not be read, in words for the person who brought it.
struct ReadError
{
    std::string file;  ///< the name the file was read under
    int line = 0;      ///< 1-based; 0: the whole file
    std::string cause; ///< what is wrong and, where there is a remedy, what to do; no final full stop

    /// Returns "tankbody.obj:17: a face needs ..." or, for the whole file, "tankbody.obj: ...".
    std::string message() const
    {
        return line > 0 ? file + ":" + std::to_string(line) + ": " + cause : file + ": " + cause;
    }
};

} // namespace base
