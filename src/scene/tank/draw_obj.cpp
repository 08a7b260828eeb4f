#include "scene/tank/draw_obj.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include <GL/gl.h>

namespace scene {
namespace {

bool is_wire(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    constexpr float LONG = 1.0f;
    constexpr float THIN = 0.04f;
    const float longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    return longest > LONG && glm::length(glm::cross(b - a, c - a)) < THIN * longest;
}

} // namespace

void draw_obj(const mesh::ObjMesh& obj)
{
    glBegin(GL_TRIANGLES);
    for (const mesh::Face& face : obj.faces) {
        for (const mesh::FaceVertex& corner : face.vertices) {
            const glm::vec3& normal = obj.normals[corner.normal];
            glNormal3f(normal.x, normal.y, normal.z);
            if (corner.texture_coordinate >= 0) {
                const glm::vec2& texture_coordinate = obj.texture_coordinates[corner.texture_coordinate];
                glTexCoord2f(texture_coordinate.x, texture_coordinate.y);
            } else {
                glTexCoord2f(0.0f, 0.0f);
            }
            const glm::vec3& position = obj.positions[corner.position];
            glVertex3f(position.x, position.y, position.z);
        }
    }
    glEnd();
}

void draw_shape(const mesh::ObjMesh& obj)
{
    glBegin(GL_TRIANGLES);
    for (const mesh::Face& face : obj.faces) {
        std::array<glm::vec3, 3> corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            corners[i] = obj.positions[static_cast<std::size_t>(face.vertices[i].position)];
        }
        if (is_wire(corners[0], corners[1], corners[2])) {
            continue;
        }
        for (const glm::vec3& position : corners) {
            glVertex3f(position.x, position.y, position.z);
        }
    }
    glEnd();
}

} // namespace scene
