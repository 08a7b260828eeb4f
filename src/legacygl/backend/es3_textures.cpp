#include "legacygl/backend/es3_textures.h"

namespace legacygl {

TextureId Es3Textures::create()
{
    GLuint name = 0;
    gl_.GenTextures(1, &name);
    return name;
}

void Es3Textures::destroy(TextureId id)
{
    gl_.DeleteTextures(1, &id);
    for (TextureId& bound : bound_) {
        if (bound == id) {
            bound = 0;
        }
    }
}

void Es3Textures::image(TextureId id, int level, int width, int height, std::span<const std::uint8_t> rgba)
{
    bind(id);
    gl_.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    ++counters_.uploads;
    counters_.upload_bytes += rgba.size();
}

void Es3Textures::generate_mipmap(TextureId id)
{
    bind(id);
    gl_.GenerateMipmap(GL_TEXTURE_2D);
}

void Es3Textures::sampling(TextureId id, const Sampling& sampling)
{
    bind(id);
    const auto set = [this](GLenum name, GLenum value) {
        gl_.TexParameteri(GL_TEXTURE_2D, name, static_cast<GLint>(value));
    };
    // ES has no borders: the shader mixes their colour in (shader_border_text.cpp). Where it also clamps the
    // coordinates, mirroring is clamping to the edge, but Mesa then filters with floats as for a border.
    const auto wrap = [&](GLenum mode) {
        if (mode != GL_CLAMP && mode != GL_CLAMP_TO_BORDER) {
            return mode;
        }
        return sampling.is_linear() ? GLenum{GL_MIRRORED_REPEAT} : GLenum{GL_CLAMP_TO_EDGE};
    };
    set(GL_TEXTURE_MIN_FILTER, sampling.minify);
    set(GL_TEXTURE_MAG_FILTER, sampling.magnify);
    set(GL_TEXTURE_WRAP_S, wrap(sampling.wrap_s));
    set(GL_TEXTURE_WRAP_T, wrap(sampling.wrap_t));
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, sampling.base_level);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, sampling.max_level);
    gl_.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, sampling.min_lod);
    gl_.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, sampling.max_lod);
}

void Es3Textures::bind(TextureId id, int unit)
{
    if (bound_[unit] == id && (active_unit_ == unit)) {
        return;
    }
    if (active_unit_ != unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    }
    active_unit_ = unit;
    if (bound_[unit] != id) {
        gl_.BindTexture(GL_TEXTURE_2D, id);
    }
    bound_[unit] = id;
}

void Es3Textures::forget_binding()
{
    bound_ = {};
    active_unit_ = -1;
}

} // namespace legacygl
