#include "scene/draw_obj.h"

#include <GL/gl.h>

namespace scene {

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
        for (const mesh::FaceVertex& corner : face.vertices) {
            const glm::vec3& position = obj.positions[corner.position];
            glVertex3f(position.x, position.y, position.z);
        }
    }
    glEnd();
}

} // namespace scene
