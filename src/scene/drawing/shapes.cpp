#include "scene/drawing/shapes.h"

#include "scene/drawing/scoped_state.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include <GL/gl.h>
#include <GL/glu.h>

namespace scene {
namespace {

/// Returns a unit vector at a right angle to another one.
glm::dvec3 across(const glm::dvec3& direction)
{
    const bool is_upright = std::abs(direction.y) > 0.9;
    return glm::normalize(
        glm::cross(is_upright ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0), direction));
}

/// Draws a sphere of radius 1 whose poles are above and below; gluSphere's lie along z.
void draw_unit_sphere(GLUquadric* quadric, GLenum style, int slices, int stacks)
{
    gluQuadricDrawStyle(quadric, style);
    glRotatef(-90.0f, 1.0f, 0.0f, 0.0f);
    gluSphere(quadric, 1.0, slices, stacks);
}

constexpr int RING_CORNERS = 40;

void draw_unit_ring()
{
    glBegin(GL_LINE_LOOP);
    for (int corner = 0; corner < RING_CORNERS; ++corner) {
        const double around = 2.0 * std::numbers::pi * corner / RING_CORNERS;
        glVertex3f(static_cast<float>(std::cos(around)), static_cast<float>(std::sin(around)), 0.0f);
    }
    glEnd();
}

/// Moves what is drawn into a frame of three axes at an origin.
void enter_frame(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& origin)
{
    const GLdouble columns[16] = {x.x, x.y, x.z, 0.0, y.x,      y.y,      y.z,      0.0,
                                  z.x, z.y, z.z, 0.0, origin.x, origin.y, origin.z, 1.0};
    glMultMatrixd(columns);
}

} // namespace

bool Shapes::load()
{
    first_list_ = glGenLists(LIST_COUNT);
    GLUquadric* quadric = gluNewQuadric();
    if (first_list_ == 0 || quadric == nullptr) {
        return false;
    }
    const auto compile = [this](List list, auto draw) {
        glNewList(first_list_ + list, GL_COMPILE);
        draw();
        glEndList();
    };
    compile(SPHERE, [quadric] { draw_unit_sphere(quadric, GLU_FILL, 48, 24); });
    compile(WIRE_SPHERE, [quadric] { draw_unit_sphere(quadric, GLU_LINE, 24, 12); });
    compile(BALL, [quadric] { draw_unit_sphere(quadric, GLU_FILL, 20, 10); });
    compile(CONE, [quadric] {
        gluQuadricDrawStyle(quadric, GLU_FILL);
        gluCylinder(quadric, 1.0, 0.0, 1.0, 20, 1);
    });
    compile(RING, draw_unit_ring);
    gluDeleteQuadric(quadric);
    return true;
}

void Shapes::draw_at(List list, const glm::dvec3& centre, double radius) const
{
    const PushedMatrix matrix;
    glTranslated(centre.x, centre.y, centre.z);
    glScaled(radius, radius, radius);
    glCallList(first_list_ + list);
}

void Shapes::draw_cone(const glm::dvec3& base, const glm::dvec3& direction, double radius,
                       double length) const
{
    const glm::dvec3 x = across(direction);
    const PushedMatrix matrix;
    enter_frame(radius * x, radius * glm::cross(direction, x), length * direction, base);
    glCallList(first_list_ + CONE);
}

void Shapes::draw_ring(const glm::dvec3& centre, const glm::dvec3& x, const glm::dvec3& y) const
{
    const PushedMatrix matrix;
    enter_frame(x, y, glm::cross(x, y), centre);
    glCallList(first_list_ + RING);
}

} // namespace scene
