#include "scene/tank/draw_low_obj.h"

#include "scene/drawing/lights.h"
#include "scene/drawing/rgb.h"
#include "tank/rotation.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>
#include <vector>

#include <GL/gl.h>

namespace scene {
namespace {

constexpr int TURNS = 12; ///< so many of a wheel are averaged

glm::vec3 light_in(const LowPose& pose, const glm::vec3& normal)
{
    const glm::dmat3 to_world(tank::rotation({0.0, 1.0, 0.0}, pose.yaw));
    const int turns = pose.turns_about_x ? TURNS : 1;
    glm::vec3 light(0.0f);
    for (int i = 0; i < turns; ++i) {
        const glm::dmat3 turn(tank::rotation({1.0, 0.0, 0.0}, 2.0 * std::numbers::pi * i / turns));
        light += light_on(glm::vec3(to_world * turn * glm::dvec3(normal)));
    }
    return light / static_cast<float>(turns);
}

std::uint8_t byte_of(float value)
{
    return static_cast<std::uint8_t>(std::lround(255.0f * glm::clamp(value, 0.0f, 1.0f)));
}

} // namespace

void draw_low_obj(const mesh::ObjMesh& obj, std::span<const assets::FacePaint> paint, const LowPose& pose)
{
    std::vector<glm::vec3> lights;
    for (const glm::vec3& normal : obj.normals) {
        lights.push_back(light_in(pose, normal));
    }
    glBegin(GL_TRIANGLES);
    for (std::size_t face = 0; face < obj.faces.size(); ++face) {
        for (std::size_t i = 0; i < 3; ++i) {
            const mesh::FaceVertex& corner = obj.faces[face].vertices[i];
            const glm::vec3 light = lights[static_cast<std::size_t>(corner.normal)];
            const glm::vec3 seen = face < paint.size() ? paint[face][i] * light : light;
            const Rgb colour{byte_of(seen.r), byte_of(seen.g), byte_of(seen.b)};
            glColor3ub(colour.red, colour.green, colour.blue);
            const glm::vec3& position = obj.positions[static_cast<std::size_t>(corner.position)];
            glVertex3f(position.x, position.y, position.z);
        }
    }
    glEnd();
}

} // namespace scene
