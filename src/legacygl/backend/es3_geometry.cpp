#include "legacygl/backend/es3_geometry.h"

#include <algorithm>

namespace legacygl {
namespace {

/// What a shared page holds, and how much of it one geometry may take: a few dozen fit.
constexpr std::uint32_t PAGE_FLOATS = 32768, PAGE_INDICES = 16384, SHARE = 16;

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
    Geometry geometry;
    geometry.page = page_for(format, vertices.size(), indices.size());
    Page& page = pages_[geometry.page];
    ++page.geometries;
    bind(page.array.name);
    gl_.BindBuffer(GL_ARRAY_BUFFER, page.array.vertices);
    if (!page.shared) {
        allocate(GL_ARRAY_BUFFER, vertices.size_bytes(), vertices.data(), GL_STATIC_DRAW);
        if (!indices.empty())
            allocate(GL_ELEMENT_ARRAY_BUFFER, indices.size_bytes(), indices.data(), GL_STATIC_DRAW);
    } else {
        geometry.first_vertex = page.used_floats / static_cast<std::uint32_t>(format.floats());
        geometry.first_index = page.used_indices;
        upload(GL_ARRAY_BUFFER, page.used_floats * sizeof(float), vertices.size_bytes(), vertices.data());
        if (!indices.empty()) {
            if (page.used_indices == 0)
                allocate(GL_ELEMENT_ARRAY_BUFFER, PAGE_INDICES * sizeof(std::uint32_t), nullptr,
                         GL_STATIC_DRAW);
            rebased_.assign(indices.begin(), indices.end());
            for (std::uint32_t& index : rebased_)
                index += geometry.first_vertex;
            upload(GL_ELEMENT_ARRAY_BUFFER, page.used_indices * sizeof(std::uint32_t), indices.size_bytes(),
                   rebased_.data());
        }
        page.used_floats += static_cast<std::uint32_t>(vertices.size());
        page.used_indices += static_cast<std::uint32_t>(indices.size());
    }
    if (free_.empty()) {
        geometries_.push_back(geometry);
        return static_cast<GeometryId>(geometries_.size() - 1);
    }
    const GeometryId id = free_.back();
    free_.pop_back();
    geometries_[id] = geometry;
    return id;
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

void Es3Geometries::draw(GeometryId id, std::span<const DrawRun> runs)
{
    const Geometry& geometry = geometries_[id];
    bind(pages_[geometry.page].array.name);
    draw_runs(runs, geometry.first_vertex, geometry.first_index);
}

void Es3Geometries::bind_stream(const VertexFormat& format, std::span<const float> vertices,
                                std::span<const std::uint32_t> indices)
{
    auto stream = std::find_if(streams_.begin(), streams_.end(),
                               [&](const Es3VertexArray& array) { return array.format == format; });
    if (stream == streams_.end())
        stream = streams_.insert(stream, make_array(format));
    bind(stream->name);
    gl_.BindBuffer(GL_ARRAY_BUFFER, stream->vertices);
    allocate(GL_ARRAY_BUFFER, vertices.size_bytes(), vertices.data(), GL_STREAM_DRAW);
    if (!indices.empty())
        allocate(GL_ELEMENT_ARRAY_BUFFER, indices.size_bytes(), indices.data(), GL_STREAM_DRAW);
}

void Es3Geometries::draw_runs(std::span<const DrawRun> runs, std::uint32_t first_vertex,
                              std::uint32_t first_index)
{
    for (const DrawRun& run : runs) {
        const auto count = static_cast<GLsizei>(run.count);
        if (run.indexed) {
            const std::size_t offset = (first_index + std::size_t{run.first}) * sizeof(std::uint32_t);
            gl_.DrawElements(draw_mode(run.primitive), count, GL_UNSIGNED_INT,
                             reinterpret_cast<const void*>(offset));
        } else {
            gl_.DrawArrays(draw_mode(run.primitive), static_cast<GLint>(first_vertex + run.first), count);
        }
        ++counters_.draw_calls;
        counters_.vertices += run.count;
    }
}

void Es3Geometries::clear()
{
    for (Page& page : pages_)
        destroy(page.array);
    for (Es3VertexArray& stream : streams_)
        destroy(stream);
    forget();
}

void Es3Geometries::forget()
{
    pages_.clear();
    geometries_.resize(1);
    free_.clear();
    streams_.clear();
    bound_ = 0;
}

/// Returns the shared page that has room for a geometry, or a page of its own for a large one.
std::uint32_t Es3Geometries::page_for(const VertexFormat& format, std::size_t floats, std::size_t indices)
{
    const bool shares = floats <= PAGE_FLOATS / SHARE && indices <= PAGE_INDICES / SHARE && floats != 0;
    for (std::size_t i = pages_.size(); shares && i-- > 0;) {
        const Page& page = pages_[i];
        if (page.shared && page.array.format == format && page.used_floats + floats <= PAGE_FLOATS &&
            page.used_indices + indices <= PAGE_INDICES)
            return static_cast<std::uint32_t>(i);
    }
    const std::uint32_t made = make_page(format);
    if (shares) {
        pages_[made].shared = true;
        allocate(GL_ARRAY_BUFFER, PAGE_FLOATS * sizeof(float), nullptr, GL_STATIC_DRAW);
    }
    return made;
}

/// Makes a page in a free place and binds its vertex array and its buffers.
std::uint32_t Es3Geometries::make_page(const VertexFormat& format)
{
    auto place =
        std::find_if(pages_.begin(), pages_.end(), [](const Page& page) { return page.geometries == 0; });
    if (place == pages_.end())
        place = pages_.insert(place, Page{});
    place->array = make_array(format);
    return static_cast<std::uint32_t>(place - pages_.begin());
}

Es3VertexArray Es3Geometries::make_array(const VertexFormat& format)
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
    array = Es3VertexArray{};
}

void Es3Geometries::bind(GLuint vertex_array)
{
    if (bound_ != vertex_array)
        gl_.BindVertexArray(vertex_array);
    bound_ = vertex_array;
}

void Es3Geometries::allocate(GLenum target, std::size_t bytes, const void* data, GLenum usage)
{
    gl_.BufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
    if (data != nullptr)
        count_upload(bytes);
}

void Es3Geometries::upload(GLenum target, std::size_t offset, std::size_t bytes, const void* data)
{
    gl_.BufferSubData(target, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
    count_upload(bytes);
}

void Es3Geometries::count_upload(std::size_t bytes)
{
    ++counters_.uploads;
    counters_.upload_bytes += bytes;
}

} // namespace legacygl
