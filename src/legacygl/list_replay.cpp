#include "legacygl/list_replay.h"

#include "legacygl/context.h"
#include "legacygl/dispatch.h"

namespace legacygl {
namespace {

constexpr std::array<const char*, ATTRIBUTE_COUNT> ATTRIBUTE_CALLS = {
    "glVertex4f",  "glNormal3f",   "glColor4f",        "glSecondaryColor3f",
    "glFogCoordf", "glTexCoord4f", "glMultiTexCoord4f", "glEdgeFlag"};

bool was_set(const VertexBatch& batch, int i)
{
    return batch.attributes_set & (1u << i);
}

glm::vec4 value_of(const VertexBatch& batch, std::uint32_t vertex, int attribute)
{
    const int components = batch.format.components[attribute];
    const float* v = batch.vertices.data() + static_cast<std::size_t>(vertex) * batch.format.floats() +
                     batch.format.offset(static_cast<Attribute>(attribute));
    glm::vec4 value = {0, 0, 0, 1};
    for (int c = 0; c < components; ++c)
        value[c] = v[c];
    return value;
}

/// Attributes that were set but are the same for every vertex hold for the whole batch.
void set_constants(Context& gl, const VertexBatch& batch)
{
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i)
        if (was_set(batch, i) && batch.format.components[i] == 0)
            gl.immediate.attribute(static_cast<Attribute>(i), 4, batch.last[i]);
}

void set_last(Context& gl, const VertexBatch& batch)
{
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i)
        if (was_set(batch, i))
            gl.immediate.attribute(static_cast<Attribute>(i), i == index_of(Attribute::normal) ? 3 : 4,
                                   batch.last[i]);
}

template <class Begin, class End, class SetAttribute, class Vertex>
void visit(const VertexBatch& batch, Begin begin, End end, SetAttribute set, Vertex vertex)
{
    for (const Primitive& primitive : batch.primitives) {
        if (primitive.begins)
            begin(primitive.mode);
        for (std::uint32_t v = primitive.first; v < primitive.first + primitive.count; ++v) {
            for (int i = 1; i < ATTRIBUTE_COUNT; ++i)
                if (batch.format.components[i] != 0 && v >= batch.unset_before[i])
                    set(static_cast<Attribute>(i), batch.format.components[i], value_of(batch, v, i));
            vertex(batch.format.components[0], value_of(batch, v, 0));
        }
        if (primitive.ends)
            end();
    }
}

void note_calls(Context& gl, const VertexBatch& batch)
{
    const auto note_vector = [&gl](const char* name, const glm::vec4& v, int n) {
        std::array<float, 4> values = {v.x, v.y, v.z, v.w};
        n == 3 ? gl.note(name, values[0], values[1], values[2]) : gl.note(name, values);
    };
    visit(
        batch, [&](GLenum mode) { gl.note("glBegin", mode); }, [&] { gl.note("glEnd"); },
        [&](Attribute a, int n, const glm::vec4& v) {
            note_vector(ATTRIBUTE_CALLS[index_of(a)], v, n == 3 ? 3 : 4);
        },
        [&](int, const glm::vec4& v) { note_vector(ATTRIBUTE_CALLS[0], v, 4); });
}

void replay_vertices(Context& gl, const VertexBatch& batch)
{
    visit(
        batch, [&](GLenum mode) { gl.begin(mode); }, [&] { gl.end(); },
        [&](Attribute a, int n, const glm::vec4& v) { gl.immediate.attribute(a, n, v); },
        [&](int n, const glm::vec4& v) { gl.immediate.vertex(n, v); });
}

} // namespace

void replay(Context& gl, ListGeometry& geometry)
{
    const VertexBatch& batch = geometry.batch;
    if (gl.capture.active())
        note_calls(gl, batch);
    const bool drawable = geometry.drawable && !gl.immediate.inside();
    if (drawable)
        gl.flush_vertices();
    set_constants(gl, batch);
    if (!drawable)
        replay_vertices(gl, batch);
    else if (!geometry.runs.empty())
        gl.renderer.draw(gl.state, geometry);
    set_last(gl, batch);
}

} // namespace legacygl
