#pragma once

#include "random_gl/program.h"

#include <array>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

/// Adds a call to the program being made.
#define RANDOM_GL_CALL(function, ...)                                                                        \
    program_.add(::random_gl::Call{#function, function __VA_OPT__(, ) __VA_ARGS__})
/// One of several OpenGL names.
#define RANDOM_GL_ANY(...) any(#__VA_ARGS__, {__VA_ARGS__})
/// An OpenGL name.
#define RANDOM_GL_NAME(name)                                                                                 \
    ::random_gl::Name                                                                                        \
    {                                                                                                        \
        static_cast<GLenum>(name), #name                                                                     \
    }

namespace random_gl {

/// What a stream makes use of.
enum class Feature
{
    attributes, ///< Between primitives, too.
    matrices,
    lighting,
    materials, ///< Between glBegin and glEnd, too.
    shade_model,
    faces, ///< Culling and the front face.
    polygon_mode,
    polygon_offset,
    polygon_stipple,
    line_stipple,
    line_width,
    point_size,
    point_parameters,
    smooth_lines_and_points,
    clip_planes,
    viewport,
    depth_range,
    depth_test,
    stencil_test,
    alpha_test,
    scissor,
    blend,
    logic_op,
    color_mask,
    fog,
    textures,
    texture_parameters,
    texture_environment,
    texture_combiners,
    texture_generation,
    texture_matrix,
    second_texture_unit,
    edge_flags,
    fog_coordinates,
    secondary_colors,
    quads, ///< GL_QUADS; all other primitives are always there.
    rectangles,
    homogeneous, ///< Vertices whose w is not 1.
    clears,
    attribute_stack,
    provoking_vertex,
    flushes,
    arrays,
    quadrics,
    meshes, ///< Regular ones, of many vertices.
    display_lists,
    copied_textures,
    ragged, ///< Attributes first appear in the middle of a primitive; colours come with and without alpha.
    COUNT
};

/// Makes programs at random, but the same for the same seed: everything that decides what a primitive looks
/// like, and primitives.
class RandomStream
{
public:
    /// Uses all features but those.
    RandomStream(unsigned seed, std::initializer_list<Feature> without);
    /// Uses some features, other ones for each seed: what few meet is seen better, and failures get shorter.
    explicit RandomStream(unsigned seed);

    /// Makes the textures that streams bind: not to be compiled.
    static void make_textures();

    /// Sets a projection and a camera, lights and what else a program begins with.
    void set_up();
    /// Changes states and draws, so many times.
    void make(int count);
    /// Changes a state.
    void state();
    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

    const Program& program() const { return program_; }
    Program& program() { return program_; }

private:
    bool uses(Feature feature) const { return used_[static_cast<std::size_t>(feature)]; }
    float number()
    {
        return fine_ ? static_cast<float>(pick(65537)) / 32768.0f - 1.0f
                     : static_cast<float>(pick(33)) / 16.0f - 1.0f;
    }
    float part() { return static_cast<float>(pick(17)) / 16.0f; }
    Values<float, 4> four()
    {
        const float a = part(), b = part(), c = part(), d = part();
        return {{a, b, c, d}};
    }
    Name any(const char* texts, std::initializer_list<GLenum> values);
    void enable(Name name);

    void primitive();
    void vertex(int components);
    static constexpr int ATTRIBUTES = 10, TEXTURE_COORDINATE = 4; ///< What attribute() can set.
    void attribute(int which);
    void loose_primitive();
    void mesh();
    void rectangle();
    void quadric();
    void array();
    void list();
    void pushed();
    Name mode();
    int vertex_count(GLenum mode);
    void begin(Name mode);
    void end();

    bool vertex_state(Feature feature);
    bool raster_state(Feature feature);
    bool fragment_state(Feature feature);
    bool texture_state(Feature feature);
    void light_state();
    void combiner_state();

    std::mt19937 random_;
    Program program_;
    std::array<bool, static_cast<std::size_t>(Feature::COUNT)> used_{};
    std::vector<Feature> states_; ///< The used features that are states.
    bool fine_ = false;           ///< Coordinates are not on a coarse grid.
    bool has_alpha_ = false;      ///< Colours are given with alpha.
    bool in_three_dimensions_ = false;
    std::size_t begun_ = 0;
    int depth_ = 0; ///< Of lists and pushes.
    int lists_ = 0;
    bool in_list_ = false;
};

} // namespace random_gl
