#pragma once

#include "mesh/obj_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace assets {

/// Names a side of the tank, as its driver has it.
enum class Side : std::uint8_t
{
    left,  ///< +X
    right, ///< -X
};

constexpr std::size_t SIDE_COUNT = 2;

/// A face of a track's link, and those at the same place of the links around it in its chain.
struct LinkFace
{
    int previous;
    int here;
    int next; ///< where driving forward takes it
    int after_next;
};

/// The faces of a body's mesh that run round with its tracks: links, and what has teeth or spokes between
/// them.
///
/// A chain is made of the mesh's groups left_NAME_0, left_NAME_1 ... or right_NAME_0 ..., in the order in
/// which they follow each other when the tank drives forward, the first after the last. All links of a chain
/// have as many faces, in the same order, at least three links; else it is no chain and rests. What is tested
/// for collisions are the meshes as loaded: a link's way to the next one's place changes their surface by
/// less than its gaps.
struct TrackLinks
{
    std::array<std::vector<LinkFace>, SIDE_COUNT> moving; ///< by Side
    std::vector<int> resting;                             ///< the other faces of the mesh, in their order
    int per_turn = 0; ///< how many links pass while a wheel turns once; 0: nothing moves

    bool any() const { return per_turn != 0; }
};

/// Finds the links of a body's mesh. wheel_radius: metres; without one, nothing moves.
/// `per_turn` is a whole number, so that a wheel's angle alone, which wraps, says where the links are: the
/// nearest one to the wheel's circumference over the links' pitch.
TrackLinks find_track_links(const mesh::ObjMesh& body, double wheel_radius);

/// Returns which of `phases` equal steps of a pitch the links of a side are at. angle: of its wheels,
/// radians.
std::size_t link_phase(const TrackLinks& links, double angle, std::size_t phases);

/// Returns a side's moving faces, `way` in [0, 1) of the way from their places to the next ones': every
/// corner runs along the Catmull-Rom spline through its places in the links around it, so that links that
/// touch go on touching. At 0 that is, to the bit, what the body's mesh has. The normals are not of unit
/// length between. Catmull, Rom: A class of local interpolating splines (1974).
mesh::ObjMesh moved_links(const mesh::ObjMesh& body, const TrackLinks& links, Side side, double way);

/// Returns the body's mesh without the faces that move.
mesh::ObjMesh without_links(const mesh::ObjMesh& body, const TrackLinks& links);

} // namespace assets
