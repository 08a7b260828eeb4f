#pragma once

#include "legacygl/backend/backend.h"

#include <GL/gl.h>
#include <glm/vec4.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace legacygl {

/// One mipmap level as it was given, converted to RGBA bytes; kept so that a lost context can be rebuilt.
struct TextureImage
{
    GLint internal_format = 1;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// A 2D texture (OpenGL 1.5, tables 6.15 and 6.16).
struct Texture
{
    std::vector<TextureImage> levels;
    Sampling sampling;
    glm::vec4 border_color{0, 0, 0, 0};
    bool generate_mipmap = false;

    TextureObject object;         ///< The backend's texture, made at the first use.
    bool images_changed = true;   ///< The backend's images are not those of levels.
    bool sampling_changed = true; ///< The backend's sampling is not sampling.

    /// Returns whether the levels that the sampling needs exist and fit together (OpenGL 1.5, 3.8.10).
    bool complete() const;
};

/// OpenGL 1.5, tables 6.14 to 6.17.
struct TexturingState
{
    bool enabled_2d = false;
    GLuint bound_2d = 0;
    std::map<GLuint, std::shared_ptr<Texture>> textures{{0u, std::make_shared<Texture>()}};
    GLenum environment_mode = GL_MODULATE;
    glm::vec4 environment_color{0, 0, 0, 0};

    Texture& bound() { return *textures.at(bound_2d); }
    const Texture& bound() const { return *textures.at(bound_2d); }
};

/// OpenGL 1.5, table 6.21: how client memory is read and written.
struct PixelStore
{
    GLint alignment = 4;
    GLint row_length = 0;
    GLint skip_rows = 0;
    GLint skip_pixels = 0;
};

} // namespace legacygl
