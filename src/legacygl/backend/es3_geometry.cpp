#include "legacygl/backend/es3_geometry.h"

#include <algorithm>

namespace legacygl {
namespace {

GLenum draw_mode(PrimitiveClass primitive)
{
    switch (primitive) {
    case PrimitiveClass::points:
        return GL_POINTS;
    case PrimitiveClass::lines:
        return GL_LINES;
    default:
        return GL_TRIANGLES;
    }
}

} // namespace

GeometryId Es3Geometries::create(const VertexFormat& format, std::span<const float> vertices,
                                 std::span<const std::uint32_t> indices)
{
    Es3VertexArray array = make_array(format, false);
    upload(GL_ARRAY_BUFFER, array.vertices, vertices.size_bytes(), vertices.data(), GL_STATIC_DRAW);
    if (!indices.empty())
        upload(GL_ELEMENT_ARRAY_BUFFER, array.indices, indices.size_bytes(), indices.data(), GL_STATIC_DRAW);
    if (free_.empty()) {
        geometries_.push_back(array);
        return static_cast<GeometryId>(geometries_.size() - 1);
    }
    const GeometryId id = free_.back();
    free_.pop_back();
    geometries_[id] = array;
    return id;
}

void Es3Geometries::destroy(GeometryId id)
{
    destroy(geometries_[id]);
    free_.push_back(id);
}

void Es3Geometries::draw(GeometryId id, std::span<const DrawRun> runs)
{
    bind(geometries_[id].name);
    draw_runs(runs);
}

void Es3Geometries::bind_stream(const VertexFormat& format, std::span<const float> vertices,
                                std::span<const float> slots, std::span<const std::uint32_t> indices)
{
    const bool with_slots = !slots.empty();
    auto stream = std::find_if(streams_.begin(), streams_.end(), [&](const Es3VertexArray& array) {
        return array.format == format && (array.slots != 0) == with_slots;
    });
    if (stream == streams_.end())
        stream = streams_.insert(stream, make_array(format, with_slots));
    bind(stream->name);
    upload(GL_ARRAY_BUFFER, stream->vertices, vertices.size_bytes(), vertices.data(), GL_STREAM_DRAW);
    if (with_slots)
        upload(GL_ARRAY_BUFFER, stream->slots, slots.size_bytes(), slots.data(), GL_STREAM_DRAW);
    if (!indices.empty())
        upload(GL_ELEMENT_ARRAY_BUFFER, stream->indices, indices.size_bytes(), indices.data(), GL_STREAM_DRAW);
}

void Es3Geometries::draw_runs(std::span<const DrawRun> runs)
{
    for (const DrawRun& run : runs) {
        const auto count = static_cast<GLsizei>(run.count);
        if (run.indexed)
            gl_.DrawElements(draw_mode(run.primitive), count, GL_UNSIGNED_INT,
                             reinterpret_cast<const void*>(run.first * sizeof(std::uint32_t)));
        else
            gl_.DrawArrays(draw_mode(run.primitive), static_cast<GLint>(run.first), count);
        ++counters_.draw_calls;
        counters_.vertices += run.count;
    }
}

void Es3Geometries::clear()
{
    for (Es3VertexArray& array : geometries_)
        destroy(array);
    for (Es3VertexArray& stream : streams_)
        destroy(stream);
    forget();
}

void Es3Geometries::forget()
{
    geometries_.resize(1);
    free_.clear();
    streams_.clear();
    bound_ = 0;
}

Es3VertexArray Es3Geometries::make_array(const VertexFormat& format, bool with_slots)
{
    Es3VertexArray array;
    array.format = format;
    gl_.GenVertexArrays(1, &array.name);
    bind(array.name);
    gl_.GenBuffers(1, &array.vertices);
    gl_.BindBuffer(GL_ARRAY_BUFFER, array.vertices);
    std::size_t offset = 0;
    for (int i = 0; i < ATTRIBUTE_COUNT; ++i) {
        if (format.components[i] == 0)
            continue;
        gl_.EnableVertexAttribArray(i);
        gl_.VertexAttribPointer(i, format.components[i], GL_FLOAT, GL_FALSE,
                                static_cast<GLsizei>(format.floats() * sizeof(float)),
                                reinterpret_cast<const void*>(offset));
        offset += format.components[i] * sizeof(float);
    }
    if (with_slots) {
        gl_.GenBuffers(1, &array.slots);
        gl_.BindBuffer(GL_ARRAY_BUFFER, array.slots);
        gl_.EnableVertexAttribArray(TRANSFORM_SLOT_LOCATION);
        gl_.VertexAttribPointer(TRANSFORM_SLOT_LOCATION, 1, GL_FLOAT, GL_FALSE, sizeof(float), nullptr);
    }
    gl_.GenBuffers(1, &array.indices);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, array.indices);
    return array;
}

void Es3Geometries::destroy(Es3VertexArray& array)
{
    if (array.name == 0)
        return;
    if (bound_ == array.name)
        bound_ = 0;
    gl_.DeleteVertexArrays(1, &array.name);
    gl_.DeleteBuffers(1, &array.vertices);
    gl_.DeleteBuffers(1, &array.indices);
    if (array.slots != 0)
        gl_.DeleteBuffers(1, &array.slots);
    array = Es3VertexArray{};
}

void Es3Geometries::bind(GLuint vertex_array)
{
    if (bound_ != vertex_array)
        gl_.BindVertexArray(vertex_array);
    bound_ = vertex_array;
}

/// Replaces what the buffer holds. The vertex array that indices belong to is bound.
void Es3Geometries::upload(GLenum target, GLuint buffer, std::size_t bytes, const void* data, GLenum usage)
{
    if (target == GL_ARRAY_BUFFER)
        gl_.BindBuffer(target, buffer);
    gl_.BufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
    ++counters_.uploads;
    counters_.upload_bytes += bytes;
}

} // namespace legacygl
