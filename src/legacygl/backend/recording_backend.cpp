#include "legacygl/backend/recording_backend.h"

#include <algorithm>

namespace legacygl {

BackendRecord& RecordingBackend::add(BackendRecord::Kind kind)
{
    records.emplace_back();
    records.back().kind = kind;
    return records.back();
}

BackendRecord& RecordingBackend::add_draw(BackendRecord::Kind kind, const DrawState& state,
                                          std::span<const DrawRun> runs)
{
    BackendRecord& record = add(kind);
    record.program = state.program;
    record.pipeline = state.pipeline;
    for (int i = 0; i < UNIFORM_GROUP_COUNT; ++i) {
        record.uniforms[i].assign(state.uniforms[i].values.begin(), state.uniforms[i].values.end());
    }
    record.constants = *state.constants;
    record.runs.assign(runs.begin(), runs.end());
    counters.draw_calls += runs.size();
    for (const DrawRun& run : runs) {
        counters.vertices += run.count;
    }
    return record;
}

std::vector<BackendRecord> RecordingBackend::draws() const
{
    std::vector<BackendRecord> out;
    std::copy_if(records.begin(), records.end(), std::back_inserter(out), [](const BackendRecord& r) {
        return r.kind == BackendRecord::Kind::draw || r.kind == BackendRecord::Kind::draw_stream;
    });
    return out;
}

ProgramId RecordingBackend::create_program(const ProgramText& text)
{
    programs.push_back(text);
    ++counters.programs;
    const auto id = static_cast<ProgramId>(programs.size());
    add(BackendRecord::Kind::program).program = id;
    return id;
}

GeometryId RecordingBackend::create_geometry(const VertexFormat& format, std::span<const float> vertices,
                                             std::span<const std::uint32_t> indices)
{
    BackendRecord& record = add(BackendRecord::Kind::geometry);
    record.format = format;
    record.vertices.assign(vertices.begin(), vertices.end());
    record.indices.assign(indices.begin(), indices.end());
    geometries_.push_back(record);
    ++counters.uploads;
    ++live_geometries;
    record.geometry = static_cast<GeometryId>(geometries_.size());
    return record.geometry;
}

void RecordingBackend::destroy_geometry(GeometryId)
{
    --live_geometries;
}

TextureId RecordingBackend::create_texture()
{
    ++live_textures;
    return next_texture_++;
}

void RecordingBackend::destroy_texture(TextureId)
{
    --live_textures;
}

void RecordingBackend::texture_image(TextureId, int, int, int, std::span<const std::uint8_t>)
{
    ++counters.uploads;
    add(BackendRecord::Kind::texture_image);
}

void RecordingBackend::generate_mipmap(TextureId)
{
    add(BackendRecord::Kind::mipmap);
}

void RecordingBackend::sampling(TextureId, const Sampling&) {}

bool RecordingBackend::draw(const DrawState& state, GeometryId geometry, std::span<const DrawRun> runs)
{
    BackendRecord& record = add_draw(BackendRecord::Kind::draw, state, runs);
    const BackendRecord& made = geometries_[geometry - 1];
    record.geometry = geometry;
    record.format = made.format;
    record.vertices = made.vertices;
    record.indices = made.indices;
    return true;
}

void RecordingBackend::draw_stream(const DrawState& state, const VertexFormat& format,
                                   std::span<const float> vertices, std::span<const std::uint32_t> indices,
                                   std::span<const DrawRun> runs)
{
    BackendRecord& record = add_draw(BackendRecord::Kind::draw_stream, state, runs);
    record.format = format;
    record.vertices.assign(vertices.begin(), vertices.end());
    record.indices.assign(indices.begin(), indices.end());
    ++counters.uploads;
}

void RecordingBackend::clear(const Pipeline& pipeline, const Clear& clear)
{
    BackendRecord& record = add(BackendRecord::Kind::clear);
    record.pipeline = pipeline;
    record.clear = clear;
}

void RecordingBackend::read_pixels(bool, int, int, int, int, std::span<std::uint8_t> rgba)
{
    std::fill(rgba.begin(), rgba.end(), std::uint8_t{0});
}

bool RecordingBackend::read_depths(int, int, int, int, std::span<std::uint32_t> depths)
{
    std::fill(depths.begin(), depths.end(), 0u);
    return true;
}

bool RecordingBackend::read_stencils(int, int, int, int, std::span<std::uint8_t> values)
{
    std::fill(values.begin(), values.end(), std::uint8_t{0});
    return true;
}

void RecordingBackend::flush(bool) {}

void RecordingBackend::resize(int, int) {}

void RecordingBackend::present()
{
    add(BackendRecord::Kind::present);
}

void RecordingBackend::show_front() {}

void RecordingBackend::context_lost()
{
    ++generation;
    live_geometries = live_textures = 0;
}

void RecordingBackend::context_restored() {}

} // namespace legacygl
