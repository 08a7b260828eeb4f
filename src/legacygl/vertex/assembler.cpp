#include "legacygl/vertex/assembler.h"

#include <algorithm>
#include <utility>

namespace legacygl {
namespace {

constexpr glm::vec4 DEFAULT_COMPONENTS = {0, 0, 0, 1};

/// Returns how many leading components say all of the value; the others are (0, 0, 0, 1)'s.
int significant_components(const glm::vec4& value, int at_least)
{
    int n = 4;
    while (n > at_least && value[n - 1] == DEFAULT_COMPONENTS[n - 1]) {
        --n;
    }
    return n;
}

} // namespace

void VertexAssembler::set_wanted(std::uint32_t mask)
{
    wanted_ = mask;
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i) {
        if (!(mask & (1u << i))) {
            batch_.format.components[i] = 0;
        }
    }
    lay_out();
}

void VertexAssembler::begin(GLenum mode)
{
    if (!has_vertices()) {
        fit_format();
    }
    inside_ = true;
    began_here_ = true;
    set_between_ = 0;
    indexed_ = false;
    mode_ = mode;
    first_ = batch_.vertex_count;
}

void VertexAssembler::resume(GLenum mode)
{
    begin(mode);
    began_here_ = false;
}

void VertexAssembler::end()
{
    if (!inside_) {
        resume(UNKNOWN_MODE);
    }
    close_primitive(true);
    fits_ = {};
    inside_ = false;
    room_ = 0;
}

void VertexAssembler::close_primitive(bool ends)
{
    if (mode_ <= GL_POLYGON) {
        batch_.modes |= 1u << mode_;
    }
    batch_.primitives.push_back({mode_, first_, batch_.vertex_count - first_, began_here_, ends, indexed_});
}

VertexBatch VertexAssembler::take()
{
    if (inside_) {
        close_primitive(false);
    }
    batch_.last = current();
    VertexBatch out = std::move(batch_);
    out.vertices.resize(out.used_vertices().size());
    out.vertices.shrink_to_fit();
    batch_ = VertexBatch{};
    clear();
    return out;
}

/// The next batch begins with the attributes that this one's vertices had of their own: most likely it wants
/// the same. In a list it must not, where an attribute means that the list has set it.
void VertexAssembler::clear()
{
    fits_ = {};
    for (int i = 0; i < ATTRIBUTE_COUNT; ++i) {
        if (use_ == Use::list || (i != 0 && !batch_.varies(static_cast<Attribute>(i)))) {
            batch_.format.components[i] = 0;
        }
    }
    lay_out();
    batch_.primitives.clear();
    batch_.unset_before = {};
    batch_.material_changes.clear();
    batch_.changes_materials = false;
    batch_.attributes_set = batch_.attributes_varying = batch_.modes = 0;
    batch_.vertex_count = 0;
    first_ = 0;
    began_here_ = false;
    room_ = 0;
}

void VertexAssembler::lay_out()
{
    const VertexFormat& format = batch_.format;
    floats_ = format.components[0];
    copied_count_ = 0;
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i) {
        if (format.components[i] != 0) {
            copied_[copied_count_++] = {i, floats_};
        }
        floats_ += format.components[i];
    }
}

/// Gives attributes the components that their current values need. The batch has no vertices yet.
void VertexAssembler::fit_format()
{
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i) {
        if (std::uint8_t& present = batch_.format.components[i]) {
            present = static_cast<std::uint8_t>(significant_components((*current_)[i], present));
        }
    }
    lay_out();
}

/// Finds room for one more vertex at least.
void VertexAssembler::make_room()
{
    const std::size_t used = static_cast<std::size_t>(batch_.vertex_count) * floats_;
    if (used + floats_ + BLOCK > batch_.vertices.size()) {
        batch_.vertices.resize(std::max<std::size_t>(1024, batch_.vertices.size() * 2) + floats_ + BLOCK);
    }
    next_ = batch_.vertices.data() + used;
    room_ = static_cast<std::uint32_t>((batch_.vertices.size() - BLOCK - used) / floats_);
}

/// Adds a vertex where there is no room yet, the position has other components, or no primitive was begun.
void VertexAssembler::other_vertex(int components, float x, float y, float z, float w)
{
    const glm::vec4 position(x, y, z, w);
    if (!inside_) {
        if (use_ == Use::immediate) {
            return; // Undefined by the specification; nothing is drawn.
        }
        resume(UNKNOWN_MODE);
    }
    if (batch_.format.components[0] < components) {
        widen(Attribute::position, components, position);
    }
    if (room_ == 0) {
        make_room();
    }
    append(position);
}

/// Sets an attribute for the first time in a primitive, or outside of one, or with other components. One that
/// the format has no room for widens the format, or is the same for all vertices.
void VertexAssembler::set(Attribute attribute, int components, float x, float y, float z, float w)
{
    const glm::vec4 value(x, y, z, w);
    const int i = index_of(attribute);
    const bool wanted = wanted_ & (1u << i);
    fits_[i] = 0;
    if ((has_vertices() || batch_.format.components[i] != 0) && wanted && !fits(i, components, value)) {
        widen(attribute, components, value);
    }
    batch_.attributes_set |= 1u << i;
    if (inside_) {
        set_varying(attribute);
    } else {
        set_between_ |= 1u << i;
    }
    (*current_)[i] = value;
    if (inside_) {
        fits_[i] = wanted ? batch_.format.components[i] : 4;
    }
}

void VertexAssembler::widen(Attribute attribute, int components, glm::vec4 value)
{
    const int i = index_of(attribute);
    const VertexFormat old = batch_.format;
    const bool is_new = !old.has(attribute);
    const glm::vec4 before = (*current_)[i]; // A position is not a current value.

    int wanted = components;
    if (attribute == Attribute::normal) {
        wanted = 3;
    } else if (is_new && attribute != Attribute::position) {
        wanted =
            std::max(significant_components(before, components), significant_components(value, components));
    }
    batch_.format.components[i] = static_cast<std::uint8_t>(wanted);

    // What earlier vertices hold in the new floats: the value before, or the components' defaults.
    const bool has_value_before = is_new && attribute != Attribute::position && known(i);
    if (is_new && attribute != Attribute::position && !known(i)) {
        batch_.unset_before[i] = batch_.vertex_count;
    }
    const glm::vec4 filler = has_value_before ? before : DEFAULT_COMPONENTS;

    const int old_floats = floats_;
    const int old_components = old.components[i];
    const int offset = old.offset(attribute);
    floats_ = batch_.format.floats();
    const auto convert = [&](const float* from, float* to) {
        const int head = offset + old_components;
        std::copy(from, from + head, to);
        for (int c = old_components; c < wanted; ++c) {
            to[offset + c] = filler[c];
        }
        std::copy(from + head, from + old_floats, to + offset + wanted);
    };

    std::array<float, MAX_VERTEX_FLOATS> widened{};
    // In place, from the last vertex to the first: each moves behind where it was.
    if (batch_.vertices.size() < static_cast<std::size_t>(batch_.vertex_count) * floats_) {
        batch_.vertices.resize(static_cast<std::size_t>(batch_.vertex_count + 1) * floats_ * 2);
    }
    for (std::size_t v = batch_.vertex_count; v-- > 0;) {
        convert(batch_.vertices.data() + v * old_floats, widened.data());
        std::copy_n(widened.data(), floats_, batch_.vertices.data() + v * floats_);
    }
    lay_out();
    room_ = 0; // Vertices lie elsewhere now.
}

} // namespace legacygl
