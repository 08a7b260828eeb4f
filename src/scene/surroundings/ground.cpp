#include "scene/surroundings/ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include <GL/gl.h>

namespace scene {
namespace {

/// A ring of the earth, and how much of it is seen there through the haze.
struct EarthRing
{
    double radius;
    float opacity; ///< 0 to 1
};

constexpr EarthRing EARTH_RINGS[] = {{0.0, 1.0f},  {0.03, 1.0f},  {0.1, 0.93f}, {0.2, 0.82f},
                                     {0.4, 0.55f}, {0.65, 0.25f}, {1.0, 0.0f}};
constexpr int EARTH_SECTORS = 48;

void earth_vertex(const EarthRing& ring, int sector)
{
    const double around = 2.0 * std::numbers::pi * (sector % EARTH_SECTORS) / EARTH_SECTORS;
    glColor4f(0.46f, 0.41f, 0.31f, ring.opacity);
    glVertex3f(static_cast<float>(ring.radius * std::sin(around)), 0.0f,
               static_cast<float>(ring.radius * std::cos(around)));
}

constexpr int GRID_SEGMENT_LINES = 4; // a segment crosses so many; short enough for the fade to look round

/// Draws one end of a segment, fainter the further it is from the middle. x, z, reach: metres.
void grid_vertex(int x, int z, int reach)
{
    const double distance = std::sqrt(static_cast<double>(x * x + z * z));
    const double share = std::max(0.0, 1.0 - distance / reach);
    glColor4f(0.16f, 0.14f, 0.11f, static_cast<float>(GRID_OPACITY * share));
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
    for (std::size_t ring = 0; ring + 1 < std::size(EARTH_RINGS); ++ring) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int sector = 0; sector <= EARTH_SECTORS; ++sector) {
            earth_vertex(EARTH_RINGS[ring], sector);
            earth_vertex(EARTH_RINGS[ring + 1], sector);
        }
        glEnd();
    }
}

void draw_grid(int spacing, int lines)
{
    const int reach = spacing * lines;
    const int segment = spacing * GRID_SEGMENT_LINES;
    glBegin(GL_LINES);
    for (int line = -reach; line <= reach; line += spacing) {
        for (int start = -reach; start < reach; start += segment) {
            grid_vertex(line, start, reach);
            grid_vertex(line, start + segment, reach);
            grid_vertex(start, line, reach);
            grid_vertex(start + segment, line, reach);
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
