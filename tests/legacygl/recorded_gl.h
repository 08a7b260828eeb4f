#pragma once

#include "legacygl/backend/recording_backend.h"
#include "legacygl/context/context.h"

#include <GL/gl.h>
#include <GL/glu.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

/// A corner of a drawn point, line or triangle: where it is in clip coordinates, and its attributes.
struct Corner
{
    glm::vec4 position, normal, color, texture_coordinate;
    bool operator==(const Corner&) const = default;
};

/// A test with an OpenGL whose backend records.
class RecordedGl : public testing::Test
{
protected:
    RecordedGl()
    {
        auto made = std::make_unique<legacygl::RecordingBackend>();
        backend = made.get();
        context = std::make_unique<legacygl::Context>(std::move(made), 64, 48);
        legacygl::current_context = context.get();
    }
    ~RecordedGl() override { legacygl::current_context = nullptr; }

    /// Returns every corner drawn so far, in order, whatever draw calls they came in.
    std::vector<Corner> corners()
    {
        context->flush_vertices();
        std::vector<Corner> out;
        for (const legacygl::BackendRecord& draw : backend->draws()) {
            for (const legacygl::DrawRun& run : draw.runs) {
                for (std::uint32_t i = 0; i < run.count; ++i) {
                    out.push_back(corner(draw, run.indexed ? draw.indices[run.first + i] : run.first + i));
                }
            }
        }
        return out;
    }

    std::unique_ptr<legacygl::Context> context;
    legacygl::RecordingBackend* backend;

private:
    static Corner corner(const legacygl::BackendRecord& draw, std::uint32_t vertex)
    {
        using namespace legacygl;
        std::array<glm::vec4, ATTRIBUTE_COUNT> values = draw.constants;
        for (int a = 0; a < ATTRIBUTE_COUNT; ++a) {
            const int components = draw.format.components[a];
            if (components == 0) {
                continue;
            }
            values[a] = {0, 0, 0, 1};
            const std::size_t at = static_cast<std::size_t>(vertex) * draw.format.floats() +
                                   draw.format.offset(static_cast<Attribute>(a));
            for (int c = 0; c < components; ++c) {
                values[a][c] = draw.vertices[at + c];
            }
        }
        const std::vector<glm::vec4>& m = draw.uniforms[0];
        const glm::vec4 p = values[0];
        return {p.x * m[0] + p.y * m[1] + p.z * m[2] + p.w * m[3], glm::vec4(glm::vec3(values[1]), 0),
                values[2], values[index_of(Attribute::texture_coordinate_0)]};
    }
};

/// Gives the three vertices of a triangle at x.
inline void triangle(float x = 0)
{
    glBegin(GL_TRIANGLES);
    glVertex3f(x, 0, 0);
    glVertex3f(x + 1, 0, 0);
    glVertex3f(x, 1, 0);
    glEnd();
}
