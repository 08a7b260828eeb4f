#pragma once

#include "legacygl/state/internal_format.h"
#include "legacygl/state/state.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace legacygl {

/// Light properties that affect the generated shader.
struct LightKey
{
    bool positional = false;
    bool spot = false;
    bool attenuated = false;
    bool operator==(const LightKey&) const = default;
};

/// Properties of a texture unit that affect the generated shader.
struct TextureKey
{
    BaseFormat format = BaseFormat::none; ///< none: the unit draws without a texture.
    GLenum environment = 0;
    Combine combine_rgb; ///< Only of GL_COMBINE.
    Combine combine_alpha;
    bool matrix = false;
    std::array<GLenum, 4> generation{}; ///< Mode of each coordinate; 0: taken from the vertex.
    bool one_dimensional = false;
    bool lod_bias = false; ///< Something is added to the level of detail.
    bool constant = false; ///< All fragments of a primitive have the same coordinates.
    /// The wrap modes of s and t where they let the border's colour show; else 0.
    std::array<GLenum, 2> border_wrap{};
    GLenum minify = 0; ///< Only where the border shows.
    GLenum magnify = 0;
    bool operator==(const TextureKey&) const = default;
    /// Whether the shader clamps the coordinates before it looks a texel up, see Es3Textures::sampling.
    bool clamps() const { return has_border() && minify == GL_LINEAR && magnify == GL_LINEAR; }
    bool has_border() const { return border_wrap[0] != 0 || border_wrap[1] != 0; }
    bool generates(GLenum mode) const
    {
        for (GLenum g : generation) {
            if (g == mode) {
                return true;
            }
        }
        return false;
    }
    /// Returns whether all fragments of a primitive have the same coordinates of this unit. varying: the
    /// attributes that a primitive's vertices may have got one by one, as bits. Interpolating equal values
    /// may end a rounding beside them, in the texel next to the one meant; Mesa does not, unless it computes
    /// them.
    bool takes_one_coordinate(int unit, std::uint32_t varying) const
    {
        return format != BaseFormat::none && !matrix && generation == std::array<GLenum, 4>{} &&
               !(varying & bit_of(texture_coordinate(unit)));
    }
};

/// What makes a fragment of a line or point transparent at its edge (OpenGL 1.5, 3.3 and 3.4.4).
enum class Coverage : std::uint8_t
{
    whole, ///< Nothing: aliased primitives, and polygons.
    line,  ///< x, z: place across and along the line in pixels; y, w: half its width and length.
    point, ///< x, y: place in a circle of radius 1; z: the square within which it is opaque.
};

/// The greatest a line or point of shaded vertices reaches beyond its own coordinates, in pixels.
constexpr int VIEWPORT_MARGIN = 256;

/// The attribute that shaded vertices carry their point size (x) or coverage values in.
constexpr Attribute SHADED_EXTRA = Attribute::normal;

/// The state that affects the generated fixed-function shader; everything else is a uniform.
struct ShaderKey
{
    bool lighting = false;
    bool eye_space = false; ///< Light in eye coordinates; otherwise in object coordinates, as Mesa does
                            ///< when no light needs a vertex's place and the modelview keeps lengths.
    bool normalize = false;
    bool rescale = false;
    bool local_viewer = false;
    bool two_side = false;
    bool separate_specular = false;
    bool specular = false; ///< Some shininess is not 0.
    /// Bit face * 4 + property: the material property follows the colour.
    std::uint8_t follows_color = 0;
    std::uint8_t light_count = 0;
    std::array<LightKey, LIGHT_COUNT> lights{};
    std::array<TextureKey, TEXTURE_UNIT_COUNT> textures;
    bool color_sum = false;      ///< The vertex's own secondary colour is added.
    GLenum fog_mode = 0;         ///< 0: no fog.
    bool fog_coordinate = false; ///< Fog by the vertex's fog coordinate, not its distance.
    GLenum alpha_func = GL_ALWAYS;
    bool blend_weight = false; ///< The colour is multiplied by its weight in blending.
    bool both_buffers = false; ///< The colour goes to the front and to the back.
    bool flat = false;         ///< See takes_one_color().
    bool points = false;
    bool polygon_stipple = false;
    bool shaded = false; ///< Vertices come transformed and lit, see PrimitivePipeline.
    Coverage coverage = Coverage::whole;
    GLenum logic_op = GL_COPY; ///< Combines fragments with the target's copy; only of shaded vertices.

    bool operator==(const ShaderKey&) const = default;
    bool follows(int face, MaterialProperty property) const
    {
        return follows_color & (1u << (face * MATERIAL_PROPERTY_COUNT + static_cast<int>(property)));
    }
    /// Whether the fragments read the uniform array `fragments`.
    bool reads_fragments() const
    {
        return fog_mode || alpha_func != GL_ALWAYS || blend_weight || polygon_stipple || logic_op != GL_COPY;
    }
    bool secondary() const { return (lighting && separate_specular) || color_sum; }
    bool textured() const;
    bool generates(GLenum mode) const;
    /// Whether the vertex's place in eye coordinates is needed.
    bool needs_eye_position() const;
    /// Whether the normal in eye coordinates is needed.
    bool needs_normal() const;
    bool needs_normal_scale() const { return needs_normal() && !normalize && eye_space == rescale; }
};

struct ShaderKeyHash
{
    std::size_t operator()(const ShaderKey& key) const;
};

/// Returns whether all fragments of a primitive take the colour of one vertex. Besides flat shading that is
/// so where the vertices of each primitive have one colour: interpolating equal values may end a rounding
/// beside them, and Mesa does not.
bool takes_one_color(const State& state, std::uint32_t varying);

/// Returns the key of the state, for primitives of one class. varying: which attributes a primitive's
/// vertices may have got one by one, as bits of Attribute.
ShaderKey make_shader_key(const State& state, PrimitiveClass primitive, std::uint32_t varying);

/// Returns the key for drawing what vertices shaded by a key became.
ShaderKey make_shaded_key(const ShaderKey& shading, PrimitiveClass primitive, Coverage coverage,
                          bool polygon_stipple, GLenum logic_op);

/// Returns what the modelview gives to the key of the state: while this and all else stays, so does the key.
bool keeps_length(const State& state);

/// Which attributes the shader of the key reads, as bits of Attribute.
std::uint32_t attributes_read(const ShaderKey& key);

/// Where the values that depend on the matrices lie in the uniform array `transform`, in vec4s; -1: absent.
/// The array holds as many of them, each in a slot, as fit beside what else a vertex shader may read: ES 3
/// promises 256 vec4s, and a vertex says which slot is its own.
struct TransformLayout
{
    static constexpr int CAPACITY = 128;

    explicit TransformLayout(const ShaderKey& key);
    int projection_modelview = 0; ///< 4 columns
    int modelview = -1;           ///< 4 columns
    int normal = -1;              ///< 3 rows of the inverse transpose
    int normal_scale = -1;        ///< x
    int object_lights = -1;       ///< direction and half vector for each light, in object coordinates
    int point = -1;               ///< viewport x, y, width, height; then x: size
    int size = 4;                 ///< Of one slot.
    /// A power of two, so that a vertex's number of its slot is quickly cut to it.
    int slots() const { return static_cast<int>(std::bit_floor(static_cast<unsigned>(CAPACITY / size))); }
};

/// Where things lie in the uniform array `lighting`, in vec4s.
namespace lighting_layout {
/// For each face, from FACE + face * FACE_SIZE.
constexpr int FACE = 0, SCENE_COLOR = 0, FACE_AMBIENT = 1, FACE_DIFFUSE = 2, FACE_SPECULAR = 3,
              FACE_EMISSION = 4, FACE_SHININESS = 5, FACE_SIZE = 6;
constexpr int MODEL_AMBIENT = 2 * FACE_SIZE;
/// For each enabled light, from LIGHT + i * LIGHT_SIZE. PRODUCT + face * 3 + (0 ambient, 1 diffuse,
/// 2 specular) is light × material, or the light alone where the material follows the colour.
constexpr int LIGHT = MODEL_AMBIENT + 1, POSITION = 0, HALF_VECTOR = 1, SPOT = 2, ATTENUATION = 3,
              PRODUCT = 4, LIGHT_SIZE = 10;
constexpr int MAX_SIZE = LIGHT + LIGHT_COUNT * LIGHT_SIZE;
constexpr int size(int light_count)
{
    return LIGHT + light_count * LIGHT_SIZE;
}
} // namespace lighting_layout

/// Where things lie in the uniform array `texturing`, in vec4s, from unit * UNIT_SIZE.
namespace texturing_layout {
constexpr int ENVIRONMENT_COLOR = 0, MATRIX = 1, OBJECT_PLANES = 5, EYE_PLANES = 9, BORDER_COLOR = 13,
              LOD_BIAS = 14, UNIT_SIZE = 15;
constexpr int SIZE = TEXTURE_UNIT_COUNT * UNIT_SIZE;
} // namespace texturing_layout

/// Where things lie in the uniform array `fragments`, in vec4s.
namespace fragments_layout {
constexpr int FOG_COLOR = 0, FOG_FACTORS = 1, ALPHA_REFERENCE = 2, TARGET_COPY_ORIGIN = 3, BLEND_WEIGHT = 4;
/// Each row in two halves of 16 bits as numbers, the left one first; two rows in a vec4.
constexpr int STIPPLE = 5, STIPPLE_SIZE = 16;
constexpr int size(bool polygon_stipple)
{
    return polygon_stipple ? STIPPLE + STIPPLE_SIZE : STIPPLE;
}
} // namespace fragments_layout

} // namespace legacygl
