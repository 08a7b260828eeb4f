#include "scene/ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include <GL/gl.h>

namespace scene {
namespace {

/// A ring of the ground and how much of the earth is seen there through the haze.
struct GroundRing
{
    double radius; ///< metres
    float opacity; ///< 0 to 1
};

constexpr GroundRing GROUND_RINGS[] = {{0.0, 1.0f},   {12.0, 1.0f},   {30.0, 0.98f}, {60.0, 0.92f},
                                       {120.0, 0.7f}, {240.0, 0.35f}, {500.0, 0.0f}};
constexpr int SECTORS = 48;

void ground_vertex(const GroundRing& ring, int sector)
{
    const double around = 2.0 * std::numbers::pi * (sector % SECTORS) / SECTORS;
    glColor4f(0.46f, 0.41f, 0.31f, ring.opacity);
    glVertex3f(static_cast<float>(ring.radius * std::sin(around)), 0.0f,
               static_cast<float>(ring.radius * std::cos(around)));
}

constexpr int GRID_REACH = 40;  // metres from the origin
constexpr int GRID_SEGMENT = 2; // metres; short enough for the fade to look round

/// Draws one end of a segment, fainter the further it is from the origin.
void grid_vertex(int x, int z, double opacity)
{
    const double distance = std::sqrt(static_cast<double>(x * x + z * z));
    const double share = std::max(0.0, 1.0 - distance / GRID_REACH);
    glColor4f(0.16f, 0.14f, 0.11f, static_cast<float>(opacity * share));
    glVertex3f(static_cast<float>(x), 0.0f, static_cast<float>(z));
}

// The hull's patch is a rectangle with round corners: full up to one distance from the rectangle, gone at
// another.
constexpr double SHADOW_HALF_WIDTH = 1.3; // metres
constexpr double SHADOW_HALF_LENGTH = 2.6;
constexpr double SHADOW_FULL_TO = 0.25;
constexpr double SHADOW_GONE_AT = 1.1;
constexpr float SHADOW_OPACITY = 0.6f;
constexpr int SHADOW_SECTORS = 32; // a multiple of four: each corner then gets an equal share

/// Draws a point of the patch's edge, `distance` metres out from the rectangle.
void shadow_vertex(int sector, double distance, float opacity)
{
    // Half a sector on, so that no direction lies on an axis between two corners.
    const double around = 2.0 * std::numbers::pi * (sector % SHADOW_SECTORS + 0.5) / SHADOW_SECTORS;
    const double x = std::sin(around);
    const double z = std::cos(around);
    glColor4f(0.0f, 0.0f, 0.0f, opacity);
    glVertex3f(static_cast<float>(std::copysign(SHADOW_HALF_WIDTH, x) + distance * x), 0.0f,
               static_cast<float>(std::copysign(SHADOW_HALF_LENGTH, z) + distance * z));
}

} // namespace

void draw_earth()
{
    glNormal3f(0.0f, 1.0f, 0.0f);
    for (std::size_t ring = 0; ring + 1 < std::size(GROUND_RINGS); ++ring) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int sector = 0; sector <= SECTORS; ++sector) {
            ground_vertex(GROUND_RINGS[ring], sector);
            ground_vertex(GROUND_RINGS[ring + 1], sector);
        }
        glEnd();
    }
}

void draw_metre_grid()
{
    glBegin(GL_LINES);
    for (int line = -GRID_REACH; line <= GRID_REACH; ++line) {
        const double opacity = line % 5 == 0 ? 0.6 : 0.25;
        for (int start = -GRID_REACH; start < GRID_REACH; start += GRID_SEGMENT) {
            grid_vertex(line, start, opacity);
            grid_vertex(line, start + GRID_SEGMENT, opacity);
            grid_vertex(start, line, opacity);
            grid_vertex(start + GRID_SEGMENT, line, opacity);
        }
    }
    glEnd();
}

void draw_contact_shadow()
{
    glBegin(GL_TRIANGLE_FAN);
    for (int sector = 0; sector < SHADOW_SECTORS; ++sector) {
        shadow_vertex(sector, SHADOW_FULL_TO, SHADOW_OPACITY);
    }
    glEnd();
    glBegin(GL_TRIANGLE_STRIP);
    for (int sector = 0; sector <= SHADOW_SECTORS; ++sector) {
        shadow_vertex(sector, SHADOW_FULL_TO, SHADOW_OPACITY);
        shadow_vertex(sector, SHADOW_GONE_AT, 0.0f);
    }
    glEnd();
}

} // namespace scene
