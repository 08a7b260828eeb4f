#include "legacygl/backend/es3_functions.h"

namespace legacygl {

std::string Es3Functions::load([[maybe_unused]] LegacyGLLoader loader)
{
#ifndef __EMSCRIPTEN__
    if (!loader) {
        return "any: there is no loader";
    }
#define LEGACYGL_LOAD(result, name, parameters)                                                              \
    name = reinterpret_cast<result(*) parameters>(loader("gl" #name));                                       \
    if (!name)                                                                                               \
        return "gl" #name;
    LEGACYGL_ES3_FUNCTIONS(LEGACYGL_LOAD)
#undef LEGACYGL_LOAD
#endif
    return {};
}

} // namespace legacygl
