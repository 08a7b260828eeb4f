#pragma once

#include "app/state/state.h"
#include "app/view/camera_view.h"
#include "assets/assets.h"
#include "base/static_vector.h"
#include "collision/part_set.h"
#include "particles/particle_view.h"
#include "tank/joint.h"
#include "tank/part.h"

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

namespace app {

/// Holds one tank to draw; the heading is a joint.
struct TankInFrame
{
    glm::dvec3 position; ///< where it stands, metres
    tank::JointAngles joints;
    lod::Level level;
};

/// Holds a bounding sphere to draw with gluSphere. Metres.
struct SphereInFrame
{
    glm::dvec3 centre;
    double radius;
    bool is_root;       ///< around the whole tank; otherwise around `part`
    tank::Part part;    ///< body for the root
    bool is_penetrated; ///< draw it transparent, in the colour of its level; otherwise as wire
};

/// Marks the point of the probe that is closest to the centre of a penetrated sphere.
struct ClosestPointInFrame
{
    glm::dvec3 point;
    glm::dvec3 centre; ///< of the sphere
    bool is_root;
};

/// Holds what is tested against the spheres. Metres.
struct ProbeInFrame
{
    Probe probe; ///< none: draw nothing
    glm::dvec3 point;
    double point_radius; ///< to draw; that of the test, but never too small to be seen
    glm::dvec3 a;        ///< the line's handles
    glm::dvec3 b;
    glm::dvec3 from; ///< the line's visible ends, far away where it has none of its own
    glm::dvec3 to;
    Handle handle; ///< what the keys move
};

/// Holds the projectile in flight. Metres, m/s.
struct ShotInFrame
{
    bool flies; ///< otherwise draw nothing
    glm::dvec3 position;
    glm::dvec3 velocity;
    double radius;
};

/// Holds an axis to draw as a line. Metres.
struct AxisInFrame
{
    bool is_shown;
    glm::dvec3 origin;    ///< the pivot
    glm::dvec3 direction; ///< of unit length, right-handed about positive angles
};

/// Marks how a point was tested against the triangles of a part whose sphere it is inside of. Metres.
struct TriangleInFrame
{
    std::array<glm::dvec3, 3> corners; ///< of the nearest triangle
    glm::dvec3 point;                  ///< of it, nearest to the probe's
    bool is_inside;                    ///< the probe's point is inside the part's mesh
};

/// Says what is drawn in a part of the window, which is divided into `parts` columns and as many rows; this
/// one is `left` columns from the left and `bottom` rows from the bottom.
struct PaneInFrame
{
    int left;
    int bottom;
    int parts;
    CameraView camera;
};

/// Holds everything that scene/ needs to draw one picture, besides the assets. Without a heap, copied freely;
/// the particles are views, which last until the Simulation they come from is next changed.
struct Frame
{
    static constexpr std::size_t MAX_TANKS = 2;
    static constexpr std::size_t MAX_SPHERES = 1 + tank::PART_COUNT;
    static constexpr std::size_t MAX_PARTICLES = 5;
    static constexpr std::size_t MAX_PANES = 4;

    CameraView camera; ///< of the pane that is drawn; before that of the last one
    base::StaticVector<PaneInFrame, MAX_PANES> panes;
    bool reticle; ///< mark what is in the middle of the window
    base::StaticVector<TankInFrame, MAX_TANKS> tanks;
    collision::PartSet parts; ///< draw these, by index of the part
    bool ground;              ///< draw it
    bool wireframe;           ///< draw the tanks' edges, not their faces

    base::StaticVector<SphereInFrame, MAX_SPHERES> spheres; ///< furthest centre first
    ProbeInFrame probe;
    base::StaticVector<ClosestPointInFrame, MAX_SPHERES> closest_points;
    base::StaticVector<TriangleInFrame, tank::PART_COUNT> triangles;
    ShotInFrame shot;
    AxisInFrame axis;
    base::StaticVector<particles::ParticleView, MAX_PARTICLES> particles;
    double threshold; ///< metres
};

/// How far beside the high tank the low one stands when both are drawn: to +X. Metres.
constexpr double BESIDE = 5.5;

/// Returns the axis of a joint, where the state has it; of a side's wheels the front one's.
AxisInFrame axis_of(const State& state, const assets::Assets& assets, tank::Joint joint);

/// Computes what a state says by itself of its frame: all but spheres, closest points, triangles, particles
/// and the axis of what moves, which Simulation::frame() adds. Pure: the same state and assets give the same
/// frame. The level by distance is that without a memory of the level before.
Frame make_frame(const State& state, const assets::Assets& assets);

} // namespace app
