#include "scene/drawing/lights.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

glm::vec3 from(const GLfloat (&values)[4])
{
    return {values[0], values[1], values[2]};
}

/// Returns the diffuse light from a direction.
glm::vec3 diffuse(const GLfloat (&colour)[4], const GLfloat (&towards)[4], const glm::vec3& normal)
{
    return std::max(glm::dot(normal, glm::normalize(from(towards))), 0.0f) * from(colour);
}

} // namespace

glm::vec3 light_on(const glm::vec3& normal)
{
    const glm::vec3 unit = glm::normalize(normal);
    return glm::min(from(AMBIENT) + diffuse(SUN_COLOUR, SUN_POSITION, unit) +
                        diffuse(SKY_LIGHT_COLOUR, TO_SKY_LIGHT, unit),
                    glm::vec3(1.0f));
}

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
