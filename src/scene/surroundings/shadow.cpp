#include "scene/surroundings/shadow.h"

#include "scene/drawing/lights.h"
#include "scene/drawing/scoped_state.h"
#include "scene/tank/draw_tank.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include <GL/gl.h>

namespace scene {
namespace {

/// So many suns at most stand close together and throw one layer of the shadow each. Where all of them are
/// hidden it is dark, where some are it is half dark: the edge is soft. Beyond this distance of the eye,
/// metres, the edge is only a few pixels wide, and fewer layers are enough: each of them draws the whole
/// tank.
constexpr int MAX_LAYERS = 8;
constexpr double ALL_LAYERS_WITHIN = 25.0;

int layer_count(const app::CameraView& camera)
{
    const double distance = glm::distance(camera.eye, camera.centre);
    return static_cast<int>(std::ceil(MAX_LAYERS * std::min(1.0, ALL_LAYERS_WITHIN / distance)));
}

/// The suns stand in a disc that looks so wide: this much to each side of its middle, in metres on the ground
/// for each metre of height. A hazy sky's sun; the bare one's would be 0.005.
constexpr double SUN_RADIUS = 0.022;

/// How dark the ground is where no sun shines on it: what is left is the sky's light. A tank of wires throws
/// a fainter shadow, before which the wires can be seen.
constexpr double DARKNESS = 0.56;
constexpr double DARKNESS_OF_WIRES = 0.25;
constexpr GLfloat SKY_TINT[] = {0.03f, 0.04f, 0.07f};

/// Returns how far a shadow is from under what throws it: along X and Z, for each metre of height.
struct Slope
{
    double x;
    double z;
};

/// Returns the slope of one of the suns. They are spread evenly over the disc along a spiral: H. Vogel, A
/// better way to construct the sunflower head, Mathematical Biosciences 44 (1979).
Slope slope_of(int layer, int layers)
{
    constexpr double GOLDEN_ANGLE = 2.39996322972865332;
    const double radius = SUN_RADIUS * std::sqrt((layer + 0.5) / layers);
    const double around = GOLDEN_ANGLE * layer;
    const glm::dvec3 to_sun(TO_SUN);
    return {to_sun.x / to_sun.y + radius * std::cos(around), to_sun.z / to_sun.y + radius * std::sin(around)};
}

/// Throws what is drawn along parallel rays on the plane y = 0: (x, y, z) -> (x - y * slope.x, 0, z - y *
/// slope.z). J. Blinn, Me and My (Fake) Shadow, IEEE Computer Graphics and Applications 8 (1988), for a light
/// infinitely far away.
void project_on_ground(const Slope& slope)
{
    const GLfloat columns[16] = {1.0f,
                                 0.0f,
                                 0.0f,
                                 0.0f, //
                                 static_cast<GLfloat>(-slope.x),
                                 0.0f,
                                 static_cast<GLfloat>(-slope.z),
                                 0.0f, //
                                 0.0f,
                                 0.0f,
                                 1.0f,
                                 0.0f, //
                                 0.0f,
                                 0.0f,
                                 0.0f,
                                 1.0f};
    glMultMatrixf(columns);
}

bool has_stencil()
{
    GLint bits = 0;
    glGetIntegerv(GL_STENCIL_BITS, &bits);
    return bits >= 4; // MAX_LAYERS are counted in it
}

/// Lets the stencil pass each pixel once for every layer: it holds the last layer that has darkened it.
class OncePerLayer
{
public:
    OncePerLayer() : test_(GL_STENCIL_TEST) { glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE); }
    ~OncePerLayer()
    {
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        glStencilFunc(GL_ALWAYS, 0, ~0u);
    }
    OncePerLayer(const OncePerLayer&) = delete;
    OncePerLayer& operator=(const OncePerLayer&) = delete;

    static void begin(int layer) { glStencilFunc(GL_GREATER, layer + 1, ~0u); }

private:
    Enabled test_;
};

} // namespace

lod::Level shadow_level(const assets::Assets& assets)
{
    return assets.has_low_model ? lod::Level::low : lod::Level::high;
}

void draw_shadow(const app::Frame& frame, const assets::Assets& assets, const TankLists& lists)
{
    if (!has_stencil()) {
        return;
    }
    const int layers = layer_count(frame.camera);
    const Blended blended;
    OncePerLayer once;
    // Layers of one opacity, which together are as dark as they shall be.
    const double darkness = frame.wireframe ? DARKNESS_OF_WIRES : DARKNESS;
    const double light_through_one = std::pow(1.0 - darkness, 1.0 / layers);
    glColor4f(SKY_TINT[0], SKY_TINT[1], SKY_TINT[2], static_cast<GLfloat>(1.0 - light_through_one));
    for (int layer = 0; layer < layers; ++layer) {
        once.begin(layer);
        const PushedMatrix matrix;
        project_on_ground(slope_of(layer, layers));
        for (const app::TankInFrame& tank : frame.tanks) {
            const TankDrawing drawing(lists, assets.layout_of(shadow_level(assets)), tank.joints,
                                      frame.parts);
            const glm::vec3 position(tank.position);
            drawing.draw_tank_shape(position.x, position.y, position.z);
        }
    }
    glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
}

} // namespace scene
