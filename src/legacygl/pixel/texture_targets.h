#pragma once

#include "legacygl/context/context.h"

namespace legacygl {

/// A target of glTexImage: the index of its TextureTarget, and whether it is only asked what would fit.
struct ImageTarget
{
    int index;
    bool proxy;
};

inline bool is_texture_target(GLenum target)
{
    return target == GL_TEXTURE_1D || target == GL_TEXTURE_2D;
}

/// Returns the target of an image of so many dimensions, or nothing when it is not one.
inline std::optional<ImageTarget> find_image_target(GLenum target, int dimensions)
{
    if (target == (dimensions == 1 ? GL_TEXTURE_1D : GL_TEXTURE_2D)) {
        return ImageTarget{dimensions - 1, false};
    }
    if (target == (dimensions == 1 ? GL_PROXY_TEXTURE_1D : GL_PROXY_TEXTURE_2D)) {
        return ImageTarget{dimensions - 1, true};
    }
    return {};
}

/// Returns the texture that is bound to a target of the active unit. is_texture_target(target).
inline Texture& bound_texture(Context& gl, GLenum target)
{
    return gl.state.texturing.bound(static_cast<TextureTarget>(target - GL_TEXTURE_1D));
}

/// Returns whether there may be a level of that number.
inline bool is_level(const Context& gl, GLint level)
{
    return level >= 0 && level < 31 && gl.backend->maximum_texture_size >> level != 0;
}

} // namespace legacygl
