#pragma once

#include "legacygl/context/context.h"

namespace legacygl {

/// Refuses what is not implemented yet with GL_INVALID_OPERATION, and says so on stderr, once for each value
/// of said. what: a function's name, or a part of what it can do.
void report_unimplemented(bool& said, const char* what);

} // namespace legacygl

/// In an entry point: refuses it, and says so the first time.
#define LEGACYGL_REFUSE(what)                                                                                \
    do {                                                                                                     \
        static bool said = false;                                                                            \
        legacygl::report_unimplemented(said, what);                                                          \
    } while (false)
