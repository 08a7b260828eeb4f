#pragma once

#include "legacygl/backend/backend.h"

#include <GL/gl.h>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace legacygl {

/// The greatest sum of a texture's and its unit's bias of the level of detail; Mesa's is the same.
constexpr GLfloat MAX_LOD_BIAS = 16;

/// One mipmap level, its texels as RGBA bytes as they are sampled; kept so that a lost context can be
/// rebuilt.
struct TextureImage
{
    GLint internal_format = 1;
    int width = 0; ///< Without a border, which is dropped.
    int height = 0;
    std::vector<std::uint8_t> rgba{}; ///< Empty in a derived level.
    bool derived = false;             ///< Made from the levels above by GL_GENERATE_MIPMAP.
    bool changed = true;              ///< The backend's image is another.
};

/// What glTexParameter sets (OpenGL 1.5, table 6.16).
struct TextureParameters
{
    Sampling sampling;
    GLenum wrap_r = GL_REPEAT;
    GLfloat lod_bias = 0;
    glm::vec4 border_color{0, 0, 0, 0};
    GLfloat priority = 1;
    bool generate_mipmap = false;
};

/// A 1D or 2D texture (OpenGL 1.5, tables 6.15 and 6.16); a 1D texture is one texel high.
struct Texture
{
    GLenum target = GL_TEXTURE_2D;
    std::vector<TextureImage> levels;
    TextureParameters parameters;

    TextureObject object;          ///< The backend's texture, made at the first use.
    bool sampling_changed = true;  ///< The backend's sampling is not the parameters'.
    bool levels_to_derive = false; ///< The backend's derived levels are not those of the base level.

    /// Returns the level that is drawn with first, or null when there is none.
    const TextureImage* base() const;
    /// Returns whether the levels that the sampling needs exist and fit together (OpenGL 1.5, 3.8.10).
    bool complete() const;
};

/// The targets of textures, in rising precedence (OpenGL 1.5, 3.8.16).
enum class TextureTarget : std::uint8_t
{
    one_dimensional,
    two_dimensional,
    count
};
constexpr int TEXTURE_TARGET_COUNT = static_cast<int>(TextureTarget::count);

/// How one texture coordinate is generated (OpenGL 1.5, 2.11.4).
struct TextureGeneration
{
    bool enabled = false;
    GLenum mode = GL_EYE_LINEAR;
    glm::vec4 object_plane{0, 0, 0, 0};
    glm::vec4 eye_plane{0, 0, 0, 0};
};

/// One half (colours or alpha) of the combine environment (OpenGL 1.5, table 3.24).
struct Combine
{
    GLenum function = GL_MODULATE;
    std::array<GLenum, 3> sources{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT};
    std::array<GLenum, 3> operands{};
    GLfloat scale = 1;
    bool operator==(const Combine&) const = default;
};

/// What each texture unit has of its own (OpenGL 1.5, table 6.17).
struct TextureUnit
{
    TextureUnit();

    std::array<bool, TEXTURE_TARGET_COUNT> enabled{};
    std::array<GLuint, TEXTURE_TARGET_COUNT> bound{};
    GLenum environment_mode = GL_MODULATE;
    glm::vec4 environment_color{0, 0, 0, 0};
    GLfloat lod_bias = 0; ///< Besides that of the texture.
    Combine combine_rgb;
    Combine combine_alpha;
    std::array<TextureGeneration, 4> generation; ///< s, t, r, q
};

/// OpenGL 1.5, tables 6.14 to 6.17.
struct TexturingState
{
    TexturingState();

    std::array<TextureUnit, TEXTURE_UNIT_COUNT> units;
    int active = 0;
    int client_active = 0;
    std::map<GLuint, std::shared_ptr<Texture>> textures; ///< A name without a texture is only reserved.
    std::array<std::shared_ptr<Texture>, TEXTURE_TARGET_COUNT> defaults; ///< Of the name 0.
    /// What proxy targets answer of each level; without texels.
    std::array<std::vector<TextureImage>, TEXTURE_TARGET_COUNT> proxies;

    TextureUnit& unit() { return units[active]; }
    const TextureUnit& unit() const { return units[active]; }
    /// Returns the texture of that name, or the target's default one for 0; null: there is none for the
    /// target (an index of TextureTarget).
    std::shared_ptr<Texture> named(int target, GLuint name) const;
    /// Returns the texture bound to a target of a unit.
    Texture& bound(const TextureUnit& unit, TextureTarget target) const;
    Texture& bound(TextureTarget target) const { return bound(unit(), target); }
    /// Returns what is added to the level of detail of a unit's texture (OpenGL 1.5, 3.8.8).
    static GLfloat lod_bias(const TextureUnit& unit, const Texture& texture);
    /// Returns the texture that the unit draws with: the enabled target of the highest precedence, if its
    /// texture is complete; else null.
    Texture* used(const TextureUnit& unit) const;
};

} // namespace legacygl
