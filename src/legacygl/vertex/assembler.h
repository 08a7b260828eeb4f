#pragma once

#include "legacygl/vertex/format.h"
#include "legacygl/vertex/material.h"

#include <GL/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace legacygl {

/// What stood between a glBegin and its glEnd, or a part of it.
struct Primitive
{
    GLenum mode;
    std::uint32_t first; ///< Its first vertex in the batch.
    std::uint32_t count;
    bool begins;          ///< The glBegin is in this batch.
    bool ends;            ///< The glEnd is in this batch.
    bool indexed = false; ///< It came by index, from glDrawElements.
};

/// A glMaterial between glBegin and glEnd: it holds from a vertex on.
struct MaterialChange
{
    std::uint32_t vertex;
    GLenum face, name;
    std::array<float, 4> values;
};

/// What a batch of vertices is like, without the vertices.
struct BatchTraits
{
    VertexFormat format;
    /// Which attributes were set at all, as bits of Attribute; `last` has the values they were left with.
    std::uint32_t attributes_set = 0;
    /// Which attributes a primitive's vertices may have got one by one. An attribute that is not among them
    /// is the same for all vertices of a primitive.
    std::uint32_t attributes_varying = 0;
    std::uint32_t colors_vary_from = 0; ///< Where colours vary, the first primitive they were given in.
    std::uint32_t modes = 0;            ///< Of the primitives, as bits: 1 << GL_TRIANGLES …
    std::uint32_t vertex_count = 0;
    bool changes_materials = false; ///< Some vertices have a material of their own.
    CurrentAttributes last{};

    bool varies(Attribute attribute) const { return attributes_varying & bit_of(attribute); }
    /// Returns which attributes vary in the primitives of one colour, or in the others.
    std::uint32_t varying(bool of_one_color) const
    {
        return of_one_color ? attributes_varying & ~bit_of(Attribute::color) : attributes_varying;
    }
    bool was_set(int attribute) const { return attributes_set & (1u << attribute); }
};

/// Vertices of one format and the primitives made of them.
struct VertexBatch : BatchTraits
{
    std::vector<float> vertices; ///< vertex_count × format.floats(), perhaps with room behind.
    std::vector<Primitive> primitives;
    /// Changes of the material, in order, and the materials before the first of them.
    std::vector<MaterialChange> material_changes;
    /// The first so many vertices came before the attribute was first set: what they hold is a filler.
    std::array<std::uint32_t, ATTRIBUTE_COUNT> unset_before{};
    std::array<Material, 2> materials_before;

    /// Returns how many primitives at the beginning have one colour each.
    std::size_t primitives_of_one_color() const
    {
        return varies(Attribute::color) ? colors_vary_from : primitives.size();
    }
    std::span<const float> used_vertices() const
    {
        return {vertices.data(), static_cast<std::size_t>(vertex_count) * format.floats()};
    }
    bool empty() const { return primitives.empty() && attributes_set == 0; }
};

/// Collects glBegin, attributes, glVertex and glEnd into a batch.
///
/// Follows Mesa's model: glVertex appends a copy of those current attributes that the format has. An
/// attribute that first differs in the middle of a batch widens the format and fills in what came before. One
/// object serves immediate mode, where the values before are known, and one each list being compiled, where
/// they are those of the moment the list is called.
class VertexAssembler
{
public:
    enum class Use : bool
    {
        immediate,
        list
    };
    /// A mode that stands for the unknown one of a primitive that a list goes on with.
    static constexpr GLenum UNKNOWN_MODE = 0xffff;

    /// current: the values the batch starts from; also updated by attribute(). In a list they count only
    /// once they were set in the list.
    VertexAssembler(CurrentAttributes& current, Use use) : current_(&current), use_(use) {}

    /// Limits the format to the attributes in mask (bits of Attribute); others only become current. Only
    /// while there are no vertices.
    void set_wanted(std::uint32_t mask);
    void begin(GLenum mode);
    void end();
    /// Returns which attributes were set outside of glBegin and glEnd since the batch got its first vertices
    /// and do not vary yet, as bits of Attribute.
    std::uint32_t set_between() const
    {
        return has_vertices() ? set_between_ & ~batch_.attributes_varying : 0;
    }
    /// Takes an attribute for one that vertices get one by one.
    void set_varying(Attribute attribute)
    {
        if (attribute == Attribute::color && !batch_.varies(attribute)) {
            batch_.colors_vary_from = static_cast<std::uint32_t>(batch_.primitives.size());
        }
        batch_.attributes_varying |= 1u << index_of(attribute);
    }
    /// Says that the primitive's vertices come by index.
    void set_indexed() { indexed_ = true; }
    /// Goes on with a primitive that a previous batch began.
    void resume(GLenum mode);
    const CurrentAttributes& current() const { return *current_; }
    bool inside() const { return inside_; }
    GLenum mode() const { return mode_; }

    /// Sets a current value; `components` of it were given, the others are the defaults.
    void attribute(Attribute attribute, int components, glm::vec4 value)
    {
        const int i = index_of(attribute);
        if (components > fits_[i]) [[unlikely]] {
            return set(attribute, components, value.x, value.y, value.z, value.w);
        }
        store(glm::value_ptr((*current_)[i]), four_floats(value));
    }

    /// Adds a vertex; `components` of its position were given, the others are the defaults.
    void vertex(int components, glm::vec4 position)
    {
        if (room_ == 0 || components > batch_.format.components[0]) [[unlikely]] {
            return other_vertex(components, position.x, position.y, position.z, position.w);
        }
        append(position);
    }

    /// Notes that the material changes before the next vertex. now: the materials without the change.
    void change_material(MaterialChange change, const std::array<Material, 2>& now)
    {
        if (batch_.material_changes.empty()) {
            batch_.materials_before = now;
        }
        change.vertex = batch_.vertex_count;
        batch_.material_changes.push_back(change);
        batch_.changes_materials = true;
    }

    bool has_vertices() const { return batch_.vertex_count != 0; }
    const VertexBatch& batch() const { return batch_; }
    /// Closes what is open (it goes on in the next batch, see resume) and hands the batch out.
    VertexBatch take();
    /// Drops the batch but keeps its memory. Not inside a primitive.
    void clear();

private:
    /// Attributes are written and copied by four floats at once: what a copy reads soon after a write of
    /// another size has to wait until that write is done.
    static constexpr int BLOCK = 4;
    using FourFloats [[gnu::vector_size(BLOCK * sizeof(float))]] = float;
    static FourFloats four_floats(const glm::vec4& v) { return FourFloats{v.x, v.y, v.z, v.w}; }
    static void store(float* to, FourFloats four) { std::memcpy(to, &four, sizeof four); }

    bool known(int i) const { return use_ == Use::immediate || (batch_.attributes_set & (1u << i)); }
    /// Whether the format can hold the value: an attribute outside the format is one constant for all.
    bool fits(int i, int components, const glm::vec4& value) const
    {
        const int present = batch_.format.components[i];
        return present ? components <= present : known(i) && (*current_)[i] == value;
    }
    // By numbers, which need no memory: what calls these should have no stack of its own.
    void set(Attribute attribute, int components, float x, float y, float z, float w);
    void other_vertex(int components, float x, float y, float z, float w);
    /// Adds a vertex, for which there is room. Each attribute overwrites what the one before wrote beyond its
    /// own components, and the next vertex what the last one did.
    void append(glm::vec4 position)
    {
        float* out = next_;
        const glm::vec4* current = current_->data();
        store(out, four_floats(position));
        for (const Copied *copied = copied_.data(), *end = copied + copied_count_; copied != end; ++copied) {
            std::memcpy(out + copied->offset, current + copied->attribute, BLOCK * sizeof(float));
        }
        next_ = out + floats_;
        --room_;
        ++batch_.vertex_count;
    }
    void widen(Attribute attribute, int components, glm::vec4 value);
    void close_primitive(bool ends);
    void make_room();
    void lay_out();
    void fit_format();

    CurrentAttributes* current_;
    Use use_;
    VertexBatch batch_;
    /// Of an attribute that was set in this primitive: how many components can be given to change nothing but
    /// the current value.
    std::array<int, ATTRIBUTE_COUNT> fits_{};
    /// What glVertex copies: the format's attributes, and where they are in a vertex, in floats.
    struct Copied
    {
        int attribute, offset;
    };
    std::array<Copied, ATTRIBUTE_COUNT> copied_{};
    int copied_count_ = 0;
    int floats_ = 0;
    float* next_ = nullptr;  ///< Where the next vertex goes, if there is room.
    std::uint32_t room_ = 0; ///< How many vertices fit there; 0 outside of a primitive.
    std::uint32_t wanted_ = ~0u;
    std::uint32_t set_between_ = 0; ///< Attributes set outside of primitives since the last glBegin.
    bool inside_ = false;
    bool began_here_ = false;
    bool indexed_ = false;
    GLenum mode_ = GL_POINTS;
    std::uint32_t first_ = 0;
};

} // namespace legacygl
