#include "legacygl/state/internal_format.h"

#include <algorithm>

namespace legacygl {

BaseFormat base_format(GLint internal_format)
{
    switch (internal_format) {
    case GL_ALPHA:
    case GL_ALPHA4:
    case GL_ALPHA8:
    case GL_ALPHA12:
    case GL_ALPHA16:
        return BaseFormat::alpha;
    case 1:
    case GL_LUMINANCE:
    case GL_LUMINANCE4:
    case GL_LUMINANCE8:
    case GL_LUMINANCE12:
    case GL_LUMINANCE16:
        return BaseFormat::luminance;
    case 2:
    case GL_LUMINANCE_ALPHA:
    case GL_LUMINANCE4_ALPHA4:
    case GL_LUMINANCE6_ALPHA2:
    case GL_LUMINANCE8_ALPHA8:
    case GL_LUMINANCE12_ALPHA4:
    case GL_LUMINANCE12_ALPHA12:
    case GL_LUMINANCE16_ALPHA16:
        return BaseFormat::luminance_alpha;
    case GL_INTENSITY:
    case GL_INTENSITY4:
    case GL_INTENSITY8:
    case GL_INTENSITY12:
    case GL_INTENSITY16:
        return BaseFormat::intensity;
    case 3:
    case GL_RGB:
    case GL_R3_G3_B2:
    case GL_RGB4:
    case GL_RGB5:
    case GL_RGB8:
    case GL_RGB10:
    case GL_RGB12:
    case GL_RGB16:
        return BaseFormat::rgb;
    case 4:
    case GL_RGBA:
    case GL_RGBA2:
    case GL_RGBA4:
    case GL_RGB5_A1:
    case GL_RGBA8:
    case GL_RGB10_A2:
    case GL_RGBA12:
    case GL_RGBA16:
        return BaseFormat::rgba;
    default:
        return BaseFormat::none;
    }
}

std::array<int, 4> texel_bits(GLint internal_format)
{
    // What a small format is stored with is free (OpenGL 1.5, 3.8.1); these are Mesa's choices.
    switch (internal_format) {
    case GL_R3_G3_B2:
        return {3, 3, 2, 0};
    case GL_RGB4:
        return {4, 4, 4, 0};
    case GL_RGB5:
        return {5, 5, 5, 0};
    case GL_RGBA2:
    case GL_RGBA4:
        return {4, 4, 4, 4};
    case GL_RGB5_A1:
        return {5, 5, 5, 1};
    case GL_RGB10_A2:
        return {8, 8, 8, 2};
    case GL_LUMINANCE4_ALPHA4:
        return {4, 0, 0, 4};
    default:
        break;
    }
    switch (base_format(internal_format)) {
    case BaseFormat::alpha:
        return {0, 0, 0, 8};
    case BaseFormat::luminance:
    case BaseFormat::intensity:
        return {8, 0, 0, 0};
    case BaseFormat::luminance_alpha:
        return {8, 0, 0, 8};
    case BaseFormat::rgb:
        return {8, 8, 8, 0};
    default:
        return {8, 8, 8, 8};
    }
}

glm::vec4 as_sampled(BaseFormat base, const glm::vec4& color)
{
    glm::vec4 out;
    for (int i = 0; i < 4; ++i) {
        out[i] = std::clamp(color[i], 0.0f, 1.0f);
    }
    keep_components(base, &out.x, 1.0f);
    return out;
}

} // namespace legacygl
