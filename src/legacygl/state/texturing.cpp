#include "legacygl/state/texturing.h"

#include <algorithm>

namespace legacygl {

TextureUnit::TextureUnit()
{
    combine_rgb.operands = {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA};
    combine_alpha.operands = {GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA};
    generation[0].object_plane = generation[0].eye_plane = {1, 0, 0, 0};
    generation[1].object_plane = generation[1].eye_plane = {0, 1, 0, 0};
}

TexturingState::TexturingState()
{
    for (std::shared_ptr<Texture>& texture : defaults) {
        texture = std::make_shared<Texture>();
    }
    defaults[static_cast<int>(TextureTarget::one_dimensional)]->target = GL_TEXTURE_1D;
}

Texture& TexturingState::bound(const TextureUnit& of, TextureTarget target) const
{
    const int index = static_cast<int>(target);
    return *named(index, of.bound[index]); // Bound textures exist: deleting one unbinds it.
}

std::shared_ptr<Texture> TexturingState::named(int target, GLuint name) const
{
    if (name == 0) {
        return defaults[target];
    }
    const auto found = textures.find(name);
    const bool there = found != textures.end() && found->second &&
                       found->second->target == static_cast<GLenum>(GL_TEXTURE_1D + target);
    return there ? found->second : nullptr;
}

GLfloat TexturingState::lod_bias(const TextureUnit& unit, const Texture& texture)
{
    return std::clamp(unit.lod_bias + texture.parameters.lod_bias, -MAX_LOD_BIAS, MAX_LOD_BIAS);
}

Texture* TexturingState::used(const TextureUnit& of) const
{
    for (int target = TEXTURE_TARGET_COUNT; target-- > 0;) {
        if (!of.enabled[target]) {
            continue;
        }
        Texture& texture = bound(of, static_cast<TextureTarget>(target));
        return texture.complete() ? &texture : nullptr;
    }
    return nullptr;
}

const TextureImage* Texture::base() const
{
    const auto level = static_cast<std::size_t>(parameters.sampling.base_level);
    const bool there = level < levels.size() && levels[level].width > 0 && levels[level].height > 0;
    return there ? &levels[level] : nullptr;
}

bool Texture::complete() const
{
    const TextureImage* first = base();
    const Sampling& sampling = parameters.sampling;
    if (!first || sampling.base_level > sampling.max_level) {
        return false;
    }
    if (sampling.minify == GL_NEAREST || sampling.minify == GL_LINEAR) {
        return true;
    }
    int width = first->width, height = first->height;
    for (int level = sampling.base_level + 1; (width > 1 || height > 1) && level <= sampling.max_level;
         ++level) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        if (level >= static_cast<int>(levels.size()) || levels[level].width != width ||
            levels[level].height != height || levels[level].internal_format != first->internal_format) {
            return false;
        }
    }
    return true;
}

} // namespace legacygl
