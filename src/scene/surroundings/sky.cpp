#include "scene/surroundings/sky.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include <GL/gl.h>

namespace scene {
namespace {

/// The colour of the sky at a height above the horizon.
struct SkyBand
{
    double elevation_degrees;
    float red, green, blue;
};

// Below the horizon the haze goes on, for the ground fades out into it.
constexpr SkyBand SKY_BANDS[] = {
    {-30.0, 0.78f, 0.80f, 0.79f}, {0.0, 0.78f, 0.80f, 0.79f},  {4.0, 0.71f, 0.77f, 0.80f},
    {12.0, 0.59f, 0.70f, 0.79f},  {30.0, 0.43f, 0.58f, 0.74f}, {90.0, 0.28f, 0.43f, 0.64f},
};
constexpr int SECTORS = 48;

void sky_vertex(const SkyBand& band, int sector)
{
    const double elevation = band.elevation_degrees * std::numbers::pi / 180.0;
    const double around = 2.0 * std::numbers::pi * (sector % SECTORS) / SECTORS;
    glColor3f(band.red, band.green, band.blue);
    glVertex3f(static_cast<float>(std::cos(elevation) * std::sin(around)),
               static_cast<float>(std::sin(elevation)),
               static_cast<float>(std::cos(elevation) * std::cos(around)));
}

} // namespace

void draw_sky_dome()
{
    for (std::size_t band = 0; band + 1 < std::size(SKY_BANDS); ++band) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int sector = 0; sector <= SECTORS; ++sector) {
            sky_vertex(SKY_BANDS[band + 1], sector);
            sky_vertex(SKY_BANDS[band], sector);
        }
        glEnd();
    }
}

} // namespace scene
