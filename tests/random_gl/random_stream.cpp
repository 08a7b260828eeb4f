#include "random_gl/random_stream.h"

#include "random_gl/pieces.h"

#include <algorithm>

namespace random_gl {
namespace {

constexpr std::array DRAWN = {Feature::quads,         Feature::rectangles, Feature::homogeneous,
                              Feature::arrays,        Feature::quadrics,   Feature::meshes,
                              Feature::display_lists, Feature::edge_flags, Feature::attribute_stack,
                              Feature::ragged,        Feature::quad_strips};

bool is_state(Feature feature)
{
    return std::find(DRAWN.begin(), DRAWN.end(), feature) == DRAWN.end();
}

} // namespace

RandomStream::RandomStream(unsigned seed, std::initializer_list<Feature> without) : random_(seed)
{
    used_.fill(true);
    for (const Feature feature : without) {
        used_[static_cast<std::size_t>(feature)] = false;
    }
    for (std::size_t i = 0; i < used_.size(); ++i) {
        if (used_[i] && is_state(static_cast<Feature>(i))) {
            states_.push_back(static_cast<Feature>(i));
        }
    }
}

RandomStream::RandomStream(unsigned seed) : random_(seed)
{
    for (int count = 3 + pick(8); count > 0; --count) {
        used_[static_cast<std::size_t>(pick(static_cast<int>(Feature::quad_strips)))] = true;
    }
    for (std::size_t i = 0; i < used_.size(); ++i) {
        if (used_[i] && is_state(static_cast<Feature>(i))) {
            states_.push_back(static_cast<Feature>(i));
        }
    }
    used_[static_cast<std::size_t>(Feature::ragged)] = false;
    used_[static_cast<std::size_t>(Feature::quad_strips)] = true;
    if (states_.empty()) {
        states_.push_back(Feature::attributes);
    }
    if (uses(Feature::second_texture_unit) || uses(Feature::texture_parameters) ||
        uses(Feature::texture_environment) || uses(Feature::texture_combiners) ||
        uses(Feature::texture_generation) || uses(Feature::texture_matrix)) {
        used_[static_cast<std::size_t>(Feature::textures)] = true;
    }
    fine_ = pick(2) != 0;
    has_alpha_ = pick(2) != 0;
}

Name RandomStream::any(const char* texts, std::initializer_list<GLenum> values)
{
    const int chosen = pick(static_cast<int>(values.size()));
    const char* begin = texts;
    for (int i = 0; i < chosen; ++i) {
        begin = std::find(begin, texts + std::char_traits<char>::length(texts), ',') + 1;
    }
    while (*begin == ' ') {
        ++begin;
    }
    const char* end = std::find(begin, texts + std::char_traits<char>::length(texts), ',');
    return {values.begin()[chosen], std::string(begin, end)};
}

void RandomStream::enable(Name name)
{
    if (pick(3)) {
        RANDOM_GL_CALL(glEnable, name);
    } else {
        RANDOM_GL_CALL(glDisable, name);
    }
}

void RandomStream::make(int count)
{
    for (int i = 0; i < count; ++i) {
        pick(3) == 0 ? primitive() : state();
    }
}

void RandomStream::state()
{
    const Feature feature = states_[static_cast<std::size_t>(pick(static_cast<int>(states_.size())))];
    vertex_state(feature) || raster_state(feature) || fragment_state(feature) || texture_state(feature);
}

void RandomStream::set_up()
{
    in_three_dimensions_ = pick(2) != 0;
    const Values<float, 4> background = four();
    RANDOM_GL_CALL(glClearColor, background.values[0], background.values[1], background.values[2], 1.0f);
    RANDOM_GL_CALL(glClear,
                   RANDOM_GL_NAME(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT));
    if (in_three_dimensions_) {
        RANDOM_GL_CALL(perspective_view, 30.0 + pick(60), part() * 2 - 1, part() * 3, 1.5f + part() * 3);
        if (pick(3)) {
            RANDOM_GL_CALL(glEnable, RANDOM_GL_NAME(GL_DEPTH_TEST));
        }
    } else if (pick(2)) {
        RANDOM_GL_CALL(plane_view, 0.5 + pick(8) / 8.0);
    }
    if (uses(Feature::lighting) || uses(Feature::materials)) {
        RANDOM_GL_CALL(glEnable, RANDOM_GL_NAME(GL_LIGHTING));
        RANDOM_GL_CALL(glEnable, RANDOM_GL_NAME(GL_LIGHT0));
        if (pick(2)) {
            RANDOM_GL_CALL(glEnable, RANDOM_GL_NAME(GL_COLOR_MATERIAL));
        }
        // Without an exponent, Mesa raises the highlights of attenuated lights to another power.
        RANDOM_GL_CALL(glMaterialf, RANDOM_GL_NAME(GL_FRONT_AND_BACK), RANDOM_GL_NAME(GL_SHININESS),
                       1 + part() * 63);
        light_state();
    }
    if (uses(Feature::textures) && pick(4)) {
        RANDOM_GL_CALL(glEnable, RANDOM_GL_NAME(GL_TEXTURE_2D));
    }
    for (const Feature feature : states_) {
        if (pick(2)) {
            vertex_state(feature) || raster_state(feature) || fragment_state(feature) ||
                texture_state(feature);
        }
    }
}

} // namespace random_gl
