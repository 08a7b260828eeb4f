// glEnable, glDisable, glIsEnabled.

#include "legacygl/context/dispatch.h"
#include "legacygl/state/capabilities.h"

using namespace legacygl;

namespace {

void set_capability(Context& gl, GLenum capability, bool enabled)
{
    const Capability found = find_capability(gl.state, capability);
    if (!found.flag) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    if (capability == GL_COLOR_MATERIAL) {
        gl.store_followed_color(); // Before it ends: the material keeps the last colour.
    }
    *found.flag = enabled;
    if (capability == GL_COLOR_MATERIAL) {
        gl.store_followed_color(); // From its begin on.
    }
    gl.renderer.changed(found.change);
}

GLenum* find_hint(HintState& hints, GLenum target)
{
    switch (target) {
    case GL_PERSPECTIVE_CORRECTION_HINT:
        return &hints.perspective_correction;
    case GL_POINT_SMOOTH_HINT:
        return &hints.point_smooth;
    case GL_LINE_SMOOTH_HINT:
        return &hints.line_smooth;
    case GL_POLYGON_SMOOTH_HINT:
        return &hints.polygon_smooth;
    case GL_FOG_HINT:
        return &hints.fog;
    case GL_GENERATE_MIPMAP_HINT:
        return &hints.generate_mipmap;
    case GL_TEXTURE_COMPRESSION_HINT:
        return &hints.texture_compression;
    default:
        return nullptr;
    }
}

} // namespace

extern "C" {

void glEnable(GLenum cap)
{
    dispatch(__func__, [](Context& gl, GLenum c) { set_capability(gl, c, true); }, cap);
}

void glDisable(GLenum cap)
{
    dispatch(__func__, [](Context& gl, GLenum c) { set_capability(gl, c, false); }, cap);
}

void glHint(GLenum target, GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum t, GLenum m) {
            GLenum* hint = find_hint(gl.state.hints, t);
            if (!hint || m < GL_DONT_CARE || m > GL_NICEST) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            *hint = m;
        },
        target, mode);
}

GLboolean glIsEnabled(GLenum cap)
{
    bool enabled = false;
    dispatch_now(
        __func__,
        [&enabled](Context& gl, GLenum c) {
            const ClientArray* array = gl.client_arrays.find(c, gl.state.texturing.client_active);
            const bool* flag = array ? &array->enabled : find_capability(gl.state, c).flag;
            if (!flag) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            enabled = *flag;
        },
        cap);
    return enabled;
}

} // extern "C"
