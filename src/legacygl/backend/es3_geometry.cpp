#include "legacygl/backend/es3_geometry.h"

#include <algorithm>

namespace legacygl {
namespace {

/// What a shared page holds: of the smallest geometries' vertices hundreds.
constexpr std::size_t PAGE_FLOATS = 1 << 15, PAGE_INDICES = 1 << 14, SMALL_INDICES = 1 << 10;

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
    Place place;
    place.page = page_for(format, vertices.size(), indices.size());
    Page& page = pages_[place.page];
    place.first_vertex = page.used_vertices;
    place.first_index = page.used_indices;
    place.slot = page.made++;
    place.small = page.shared;
    ++page.geometries;
    bind(page.array.name);
    page.shared ? append(page, vertices, indices) : fill_own(page, vertices, indices);
    if (free_.empty()) {
        geometries_.push_back(place);
        return static_cast<GeometryId>(geometries_.size() - 1);
    }
    const GeometryId id = free_.back();
    free_.pop_back();
    geometries_[id] = place;
    return id;
}

void Es3Geometries::fill_own(const Page& page, std::span<const float> vertices,
                             std::span<const std::uint32_t> indices)
{
    upload(GL_ARRAY_BUFFER, page.array.vertices, vertices.size_bytes(), vertices.data(), GL_STATIC_DRAW);
    if (!indices.empty()) {
        upload(GL_ELEMENT_ARRAY_BUFFER, page.array.indices, indices.size_bytes(), indices.data(),
               GL_STATIC_DRAW);
    }
}

/// Adds a geometry behind those that the shared page has; its vertices name the next slot.
void Es3Geometries::append(Page& page, std::span<const float> vertices,
                           std::span<const std::uint32_t> indices)
{
    const auto floats = static_cast<std::size_t>(page.array.format.floats());
    const std::size_t count = vertices.size() / floats;
    slots_.assign(count, static_cast<float>(page.made - 1));
    upload_part(GL_ARRAY_BUFFER, page.array.slots, page.used_vertices * sizeof(float), count * sizeof(float),
                slots_.data());
    upload_part(GL_ARRAY_BUFFER, page.array.vertices, page.used_vertices * floats * sizeof(float),
                vertices.size_bytes(), vertices.data());
    if (!indices.empty()) {
        if (page.used_indices == 0) {
            allocate(GL_ELEMENT_ARRAY_BUFFER, page.array.indices, PAGE_INDICES * sizeof(std::uint32_t));
        }
        rebased_.assign(indices.begin(), indices.end());
        for (std::uint32_t& index : rebased_) {
            index += page.used_vertices;
        }
        upload_part(GL_ELEMENT_ARRAY_BUFFER, page.array.indices, page.used_indices * sizeof(std::uint32_t),
                    indices.size_bytes(), rebased_.data());
    }
    page.used_vertices += static_cast<std::uint32_t>(count);
    page.used_indices += static_cast<std::uint32_t>(indices.size());
}

void Es3Geometries::destroy(GeometryId id)
{
    Page& page = pages_[geometries_[id].page];
    if (--page.geometries == 0) {
        destroy(page.array);
        page = Page{};
    }
    free_.push_back(id);
}

void Es3Geometries::bind_stream(const VertexFormat& format, std::span<const float> vertices,
                                std::span<const float> slots, std::span<const std::uint32_t> indices)
{
    const bool with_slots = !slots.empty();
    auto stream = std::find_if(streams_.begin(), streams_.end(), [&](const Es3VertexArray& array) {
        return array.format == format && (array.slots != 0) == with_slots;
    });
    if (stream == streams_.end()) {
        stream = streams_.insert(stream, make_array(format, with_slots));
    }
    bind(stream->name);
    upload(GL_ARRAY_BUFFER, stream->vertices, vertices.size_bytes(), vertices.data(), GL_STREAM_DRAW);
    if (with_slots) {
        upload(GL_ARRAY_BUFFER, stream->slots, slots.size_bytes(), slots.data(), GL_STREAM_DRAW);
    }
    if (!indices.empty()) {
        upload(GL_ELEMENT_ARRAY_BUFFER, stream->indices, indices.size_bytes(), indices.data(),
               GL_STREAM_DRAW);
    }
}

void Es3Geometries::draw_runs(std::span<const DrawRun> runs)
{
    for (const DrawRun& run : runs) {
        const auto count = static_cast<GLsizei>(run.count);
        if (run.indexed) {
            gl_.DrawElements(draw_mode(run.primitive), count, GL_UNSIGNED_INT,
                             reinterpret_cast<const void*>(run.first * sizeof(std::uint32_t)));
        } else {
            gl_.DrawArrays(draw_mode(run.primitive), static_cast<GLint>(run.first), count);
        }
        ++counters_.draw_calls;
        counters_.vertices += run.count;
    }
}

void Es3Geometries::clear()
{
    for (Page& page : pages_) {
        destroy(page.array);
    }
    for (Es3VertexArray& stream : streams_) {
        destroy(stream);
    }
    forget();
}

void Es3Geometries::forget()
{
    pages_.resize(1);
    geometries_.resize(1);
    free_.clear();
    streams_.clear();
    bound_ = 0;
}

/// Returns the shared page that has room for a geometry, or a page of its own for a large one.
std::uint32_t Es3Geometries::page_for(const VertexFormat& format, std::size_t floats, std::size_t indices)
{
    const bool small = floats <= SMALL_FLOATS && indices <= SMALL_INDICES && floats != 0;
    for (std::size_t i = pages_.size(); small && --i > 0;) {
        const Page& page = pages_[i];
        const std::size_t used = page.used_vertices * static_cast<std::size_t>(format.floats());
        if (page.shared && page.array.format == format && used + floats <= PAGE_FLOATS &&
            page.used_indices + indices <= PAGE_INDICES) {
            return static_cast<std::uint32_t>(i);
        }
    }
    return make_page(format, small);
}

/// Makes a page in a free place.
std::uint32_t Es3Geometries::make_page(const VertexFormat& format, bool shared)
{
    auto place =
        std::find_if(pages_.begin() + 1, pages_.end(), [](const Page& page) { return page.geometries == 0; });
    if (place == pages_.end()) {
        place = pages_.insert(place, Page{});
    }
    place->array = make_array(format, shared);
    place->shared = shared;
    if (shared) {
        allocate(GL_ARRAY_BUFFER, place->array.vertices, PAGE_FLOATS * sizeof(float));
        allocate(GL_ARRAY_BUFFER, place->array.slots, PAGE_FLOATS / format.floats() * sizeof(float));
    }
    return static_cast<std::uint32_t>(place - pages_.begin());
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
        if (format.components[i] == 0) {
            continue;
        }
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
    if (array.name == 0) {
        return;
    }
    if (bound_ == array.name) {
        bound_ = 0;
    }
    gl_.DeleteVertexArrays(1, &array.name);
    gl_.DeleteBuffers(1, &array.vertices);
    gl_.DeleteBuffers(1, &array.indices);
    if (array.slots != 0) {
        gl_.DeleteBuffers(1, &array.slots);
    }
    array = Es3VertexArray{};
}

void Es3Geometries::bind(GLuint vertex_array)
{
    if (bound_ != vertex_array) {
        gl_.BindVertexArray(vertex_array);
    }
    bound_ = vertex_array;
}

/// Buffers of indices belong to the vertex array, which is bound.
void Es3Geometries::bind_buffer(GLenum target, GLuint buffer)
{
    if (target == GL_ARRAY_BUFFER) {
        gl_.BindBuffer(target, buffer);
    }
}

void Es3Geometries::allocate(GLenum target, GLuint buffer, std::size_t bytes)
{
    bind_buffer(target, buffer);
    gl_.BufferData(target, static_cast<GLsizeiptr>(bytes), nullptr, GL_STATIC_DRAW);
}

void Es3Geometries::upload(GLenum target, GLuint buffer, std::size_t bytes, const void* data, GLenum usage)
{
    bind_buffer(target, buffer);
    gl_.BufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
    ++counters_.uploads;
    counters_.upload_bytes += bytes;
}

void Es3Geometries::upload_part(GLenum target, GLuint buffer, std::size_t offset, std::size_t bytes,
                                const void* data)
{
    bind_buffer(target, buffer);
    gl_.BufferSubData(target, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
    ++counters_.uploads;
    counters_.upload_bytes += bytes;
}

} // namespace legacygl
