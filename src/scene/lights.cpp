#include "scene/lights.h"

#include <GL/gl.h>

namespace scene {
namespace {

constexpr GLenum SUN = GL_LIGHT0;
constexpr GLenum SKY_LIGHT = GL_LIGHT1;

// The fourth component 0 makes a direction of a position: it points to the light.
constexpr GLfloat SUN_POSITION[] = {TO_SUN.x, TO_SUN.y, TO_SUN.z, 0.0f};
constexpr GLfloat TO_SKY_LIGHT[] = {-0.6f, 0.35f, -0.5f, 0.0f};

constexpr GLfloat SUN_COLOUR[] = {0.95f, 0.90f, 0.80f, 1.0f};
constexpr GLfloat SUN_SPECULAR[] = {0.60f, 0.57f, 0.50f, 1.0f};
constexpr GLfloat SKY_LIGHT_COLOUR[] = {0.22f, 0.26f, 0.32f, 1.0f};
constexpr GLfloat AMBIENT[] = {0.34f, 0.35f, 0.37f, 1.0f};
constexpr GLfloat BLACK[] = {0.0f, 0.0f, 0.0f, 1.0f};

} // namespace

void set_up_lights()
{
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, AMBIENT);
    glLightfv(SUN, GL_AMBIENT, BLACK);
    glLightfv(SUN, GL_DIFFUSE, SUN_COLOUR);
    glLightfv(SUN, GL_SPECULAR, SUN_SPECULAR);
    glLightfv(SKY_LIGHT, GL_AMBIENT, BLACK);
    glLightfv(SKY_LIGHT, GL_DIFFUSE, SKY_LIGHT_COLOUR);
    glLightfv(SKY_LIGHT, GL_SPECULAR, BLACK);
    glEnable(SUN);
    glEnable(SKY_LIGHT);
}

void place_lights()
{
    glLightfv(SUN, GL_POSITION, SUN_POSITION);
    glLightfv(SKY_LIGHT, GL_POSITION, TO_SKY_LIGHT);
}

} // namespace scene
