#pragma once

#include "legacygl/backend/backend.h"

#include <vector>

namespace legacygl {

/// One thing that a RecordingBackend was asked to do.
struct BackendRecord
{
    enum class Kind
    {
        program,
        geometry,
        texture_image,
        mipmap,
        draw,
        draw_stream,
        clear,
        present
    };
    Kind kind;
    ProgramId program = 0;
    GeometryId geometry = 0;
    Pipeline pipeline;
    std::array<std::vector<glm::vec4>, UNIFORM_GROUP_COUNT> uniforms;
    CurrentAttributes constants{};
    VertexFormat format;
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<DrawRun> runs;
    Clear clear;
};

/// A backend that draws nothing and remembers what it was asked, for tests that need no GPU.
class RecordingBackend final : public Backend
{
public:
    std::vector<BackendRecord> records;
    std::vector<ProgramText> programs; ///< programs[id - 1]

    /// Returns the records of draws, in order.
    std::vector<BackendRecord> draws() const;

    ProgramId create_program(const ProgramText& text) override;
    GeometryId create_geometry(const VertexFormat& format, std::span<const float> vertices,
                               std::span<const std::uint32_t> indices) override;
    void destroy_geometry(GeometryId id) override;
    TextureId create_texture() override;
    void destroy_texture(TextureId id) override;
    void texture_image(TextureId id, int level, int width, int height,
                       std::span<const std::uint8_t> rgba) override;
    void generate_mipmap(TextureId id) override;
    void sampling(TextureId id, const Sampling& sampling) override;
    bool draw(const DrawState& state, GeometryId geometry, std::span<const DrawRun> runs) override;
    void draw_stream(const DrawState& state, const VertexFormat& format, std::span<const float> vertices,
                     std::span<const std::uint32_t> indices, std::span<const DrawRun> runs) override;
    void clear(const Pipeline& pipeline, const Clear& clear) override;
    void read_pixels(bool front, int x, int y, int width, int height, std::span<std::uint8_t> rgba) override;
    bool read_depths(int x, int y, int width, int height, std::span<std::uint32_t> depths) override;
    bool read_stencils(int x, int y, int width, int height, std::span<std::uint8_t> values) override;
    bool clips_lines() override { return lines_are_clipped; }
    void flush(bool wait) override;
    void resize(int width, int height) override;
    void present() override;
    void show_front() override;
    void context_lost() override;
    void context_restored() override;

    bool lines_are_clipped = true;
    int live_geometries = 0; ///< Made and not destroyed.
    int live_textures = 0;

private:
    BackendRecord& add(BackendRecord::Kind kind);
    BackendRecord& add_draw(BackendRecord::Kind kind, const DrawState& state, std::span<const DrawRun> runs);

    std::vector<BackendRecord> geometries_{};
    TextureId next_texture_ = 1;
};

} // namespace legacygl
