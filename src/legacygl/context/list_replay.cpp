#include "legacygl/context/list_replay.h"

#include "legacygl/context/context.h"
#include "legacygl/context/dispatch.h"

#include <optional>

namespace legacygl {
namespace {

/// What an attribute is noted as for a capture.
struct NotedCall
{
    const char* name;
    int arguments;
};
constexpr std::array<NotedCall, ATTRIBUTE_COUNT> NOTED_CALLS = {{{"glVertex4f", 4},
                                                                 {"glNormal3f", 3},
                                                                 {"glColor4f", 4},
                                                                 {"glSecondaryColor3f", 3},
                                                                 {"glFogCoordf", 1},
                                                                 {"glTexCoord4f", 4},
                                                                 {"glMultiTexCoord4f", 4},
                                                                 {"glEdgeFlag", 1}}};

/// Returns what a vertex has of an attribute: its own value, or the one that is the same for all.
glm::vec4 value_of(const VertexBatch& batch, std::uint32_t vertex, int attribute)
{
    const int components = batch.format.components[attribute];
    if (components == 0) {
        return batch.last[attribute];
    }
    const float* v = batch.vertices.data() + static_cast<std::size_t>(vertex) * batch.format.floats() +
                     batch.format.offset(static_cast<Attribute>(attribute));
    glm::vec4 value = {0, 0, 0, 1};
    for (int c = 0; c < components; ++c) {
        value[c] = v[c];
    }
    return value;
}

/// Sets the attributes of the mask to what the list left them with.
void set_attributes(Context& gl, const BatchTraits& traits, std::uint32_t mask)
{
    for (int i = 1; mask >> i != 0; ++i) {
        if (mask & (1u << i)) {
            gl.immediate.attribute(static_cast<Attribute>(i), i == index_of(Attribute::normal) ? 3 : 4,
                                   traits.last[i]);
        }
    }
}

/// Gives each vertex with all attributes that the list had set by then, however often it set them. Those that
/// are the same for every vertex come with 0 components.
template <class Begin, class End, class SetAttribute, class Vertex>
void visit(const VertexBatch& batch, Begin begin, End end, SetAttribute set, Vertex vertex)
{
    for (const Primitive& primitive : batch.primitives) {
        if (primitive.begins) {
            begin(primitive.mode);
        }
        for (std::uint32_t v = primitive.first; v < primitive.first + primitive.count; ++v) {
            for (int i = 1; i < ATTRIBUTE_COUNT; ++i) {
                if (batch.was_set(i) && v >= batch.unset_before[i]) {
                    set(static_cast<Attribute>(i), batch.format.components[i], value_of(batch, v, i));
                }
            }
            vertex(batch.format.components[0], value_of(batch, v, 0));
        }
        if (primitive.ends) {
            end();
        }
    }
}

void note_call(Context& gl, Attribute attribute, const glm::vec4& v)
{
    const NotedCall& call = NOTED_CALLS[index_of(attribute)];
    if (attribute == Attribute::texture_coordinate_1) {
        return gl.note(call.name, static_cast<GLenum>(GL_TEXTURE1), v.x, v.y, v.z, v.w);
    }
    if (call.arguments == 1) {
        return gl.note(call.name, v.x);
    }
    if (call.arguments == 3) {
        return gl.note(call.name, v.x, v.y, v.z);
    }
    gl.note(call.name, v.x, v.y, v.z, v.w);
}

void note_calls(Context& gl, const VertexBatch& batch)
{
    std::array<std::optional<glm::vec4>, ATTRIBUTE_COUNT> noted;
    visit(
        batch, [&](GLenum mode) { gl.note("glBegin", mode); }, [&] { gl.note("glEnd"); },
        [&](Attribute a, int, const glm::vec4& v) {
            note_call(gl, a, v);
            noted[index_of(a)] = v;
        },
        [&](int, const glm::vec4& v) { note_call(gl, Attribute::position, v); });
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i) { // What was set after the last vertex.
        if (batch.was_set(i) && noted[i] != batch.last[i]) {
            note_call(gl, static_cast<Attribute>(i), batch.last[i]);
        }
    }
}

/// Begins a primitive whose vertices count as having got attributes one by one if they had in the list, also
/// those that are the same for all: Mesa interpolates such a colour, which may end a rounding beside it.
void begin_varying(Context& gl, GLenum mode, const VertexBatch& batch, std::size_t primitive)
{
    gl.begin(mode);
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i) {
        const auto attribute = static_cast<Attribute>(i);
        if (batch.varies(attribute) &&
            (attribute != Attribute::color || primitive >= batch.primitives_of_one_color())) {
            gl.immediate.set_varying(attribute);
        }
    }
}

void replay_vertices(Context& gl, const VertexBatch& batch)
{
    std::size_t primitive = 0;
    visit(
        batch, [&](GLenum mode) { begin_varying(gl, mode, batch, primitive); },
        [&] {
            gl.end();
            ++primitive;
        },
        [&](Attribute a, int n, const glm::vec4& v) {
            if (n != 0) {
                gl.immediate.attribute(a, n, v);
            }
        },
        [&](int n, const glm::vec4& v) { gl.immediate.vertex(n, v); });
}

} // namespace

void replay(Context& gl, ListGeometry& geometry)
{
    if (gl.capture.active()) {
        note_calls(gl, geometry.vertices->batch);
    }
    const bool drawable = geometry.drawable && !gl.immediate.inside();
    if (drawable) {
        gl.flush_vertices();
    }
    set_attributes(gl, geometry.traits, geometry.constants);
    if (!drawable) {
        replay_vertices(gl, geometry.vertices->batch);
    } else if (geometry.run_count != 0) {
        gl.renderer.draw(gl.state, geometry);
    }
    set_attributes(gl, geometry.traits, geometry.traits.attributes_set);
}

} // namespace legacygl
