#include "scene/drawing/materials.h"

#include <GL/gl.h>

namespace scene {
namespace {

constexpr GLfloat WHITE[] = {1.0f, 1.0f, 1.0f, 1.0f};
constexpr GLfloat BLACK[] = {0.0f, 0.0f, 0.0f, 1.0f};
constexpr GLfloat FAINT_GLOSS[] = {0.22f, 0.22f, 0.20f, 1.0f};

} // namespace

void use_tank_material()
{
    // White, so that light times texture is what is seen (GL_MODULATE).
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, WHITE);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, FAINT_GLOSS);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 24.0f);
}

void use_plain_material()
{
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, BLACK);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 0.0f);
}

} // namespace scene
