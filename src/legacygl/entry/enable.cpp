// glEnable, glDisable, glIsEnabled.

#include "legacygl/capabilities.h"
#include "legacygl/dispatch.h"

using namespace legacygl;

namespace {

void set_capability(Context& gl, GLenum capability, bool enabled)
{
    const Capability found = find_capability(gl.state, capability);
    if (!found.flag)
        return gl.set_error(GL_INVALID_ENUM);
    if (capability == GL_COLOR_MATERIAL)
        gl.store_followed_color(); // Before it ends: the material keeps the last colour.
    *found.flag = enabled;
    if (capability == GL_COLOR_MATERIAL)
        gl.store_followed_color(); // From its begin on.
    gl.renderer.changed(found.change);
}

} // namespace

extern "C" {

void glEnable(GLenum cap)
{
    dispatch(
        __func__, [](Context& gl, GLenum c) { set_capability(gl, c, true); }, cap);
}

void glDisable(GLenum cap)
{
    dispatch(
        __func__, [](Context& gl, GLenum c) { set_capability(gl, c, false); }, cap);
}

/// Nothing here is quicker for being worse: a hint is checked and has no effect.
void glHint(GLenum target, GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum t, GLenum m) {
            const bool is_target = (t >= GL_PERSPECTIVE_CORRECTION_HINT && t <= GL_FOG_HINT) ||
                                   t == GL_GENERATE_MIPMAP_HINT || t == GL_TEXTURE_COMPRESSION_HINT;
            if (!is_target || m < GL_DONT_CARE || m > GL_NICEST)
                gl.set_error(GL_INVALID_ENUM);
        },
        target, mode);
}

GLboolean glIsEnabled(GLenum cap)
{
    bool enabled = false;
    dispatch_now(
        __func__,
        [&enabled](Context& gl, GLenum c) {
            const Capability found = find_capability(gl.state, c);
            if (!found.flag)
                return gl.set_error(GL_INVALID_ENUM);
            enabled = *found.flag;
        },
        cap);
    return enabled;
}

} // extern "C"
