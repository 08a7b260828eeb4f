#include "checks/drawn_vertices.h"

#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <string_view>

namespace checks {
namespace {

// <GL/gl.h> is scene's alone.
constexpr double BLEND = 0x0BE2;
constexpr double LIGHTING = 0x0B50;
constexpr double TEXTURE_2D = 0x0DE1;
constexpr double LINES = 1;
constexpr double LINE_STRIP = 3;

struct Settings
{
    Drawn drawn = Drawn::points;
    bool blended = false;
    bool lit = false;
    bool textured = false;
    bool writes_depth = true;
    double opacity = 1.0;
};

Drawn drawn_by(double mode)
{
    return mode < LINES ? Drawn::points : mode <= LINE_STRIP ? Drawn::lines : Drawn::faces;
}

void set_capability(Settings& settings, double capability, bool is_on)
{
    if (capability == BLEND) {
        settings.blended = is_on;
    } else if (capability == LIGHTING) {
        settings.lit = is_on;
    } else if (capability == TEXTURE_2D) {
        settings.textured = is_on;
    }
}

/// Returns the fourth component of a colour, of bytes, floats or doubles; 1 for three components.
double opacity_of(const LegacyGLCall& call, std::string_view name)
{
    const bool is_bytes = name.find("ub") != std::string_view::npos;
    return call.argument_count < 4 ? 1.0 : call.arguments[3] / (is_bytes ? 255.0 : 1.0);
}

/// Returns the first two to four numbers of a call as a place.
glm::dvec4 place_of(const LegacyGLCall& call)
{
    glm::dvec4 place(0.0, 0.0, 0.0, 1.0);
    const int count = std::min(call.argument_count, 4);
    for (int i = 0; i < count; ++i) {
        place[i] = call.arguments[i];
    }
    return place;
}

} // namespace

std::vector<DrawnVertex> drawn_vertices(const FrameCapture& capture, const app::CameraView& camera)
{
    const glm::dmat4 to_world = glm::inverse(glm::lookAt(camera.eye, camera.centre, camera.up));
    std::vector<DrawnVertex> vertices;
    std::vector<Settings> pushed;
    Settings now;
    for (const LegacyGLCall& call : capture.calls) {
        const std::string_view name = call.name;
        if (name == "glBegin") {
            now.drawn = drawn_by(call.arguments[0]);
        } else if (name == "glEnable" || name == "glDisable") {
            set_capability(now, call.arguments[0], name == "glEnable");
        } else if (name == "glDepthMask") {
            now.writes_depth = call.arguments[0] != 0.0;
        } else if (name.starts_with("glColor3") || name.starts_with("glColor4")) {
            now.opacity = opacity_of(call, name);
        } else if (name == "glPushAttrib") {
            pushed.push_back(now);
        } else if (name == "glPopAttrib" && !pushed.empty()) {
            now = pushed.back();
            pushed.pop_back();
        } else if (name.starts_with("glVertex") && name != "glVertexPointer") {
            glm::dmat4 modelview;
            std::copy(std::begin(call.modelview), std::end(call.modelview), &modelview[0][0]);
            const glm::dvec4 world = to_world * modelview * place_of(call);
            vertices.push_back({glm::dvec3(world) / world.w, now.drawn, now.blended, now.lit, now.textured,
                                now.writes_depth, now.opacity});
        }
    }
    return vertices;
}

} // namespace checks
