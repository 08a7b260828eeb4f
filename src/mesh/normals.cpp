#include "mesh/normals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

namespace mesh {
namespace {

constexpr glm::vec3 any_direction(0, 1, 0);
constexpr int MISSING = -1;

/// Twice the vector area of a face. In double: the square of no float overflows or vanishes there.
glm::dvec3 vector_area(const ObjMesh& mesh, const Face& face)
{
    const glm::dvec3 a(mesh.positions[face.vertices[0].position]);
    const glm::dvec3 b(mesh.positions[face.vertices[1].position]);
    const glm::dvec3 c(mesh.positions[face.vertices[2].position]);
    return glm::cross(b - a, c - a);
}

bool vanishes(const glm::dvec3& v)
{
    return !(glm::dot(v, v) > 0);
}

glm::vec3 direction_of(const glm::dvec3& v)
{
    return vanishes(v) ? any_direction : glm::vec3(v / std::sqrt(glm::dot(v, v)));
}

/// The angle of a face at one of its corners; 0 where two corners coincide.
double corner_angle(const ObjMesh& mesh, const Face& face, int corner)
{
    const glm::dvec3 here(mesh.positions[face.vertices[corner].position]);
    const glm::dvec3 to_next = glm::dvec3(mesh.positions[face.vertices[(corner + 1) % 3].position]) - here;
    const glm::dvec3 to_previous =
        glm::dvec3(mesh.positions[face.vertices[(corner + 2) % 3].position]) - here;
    const glm::dvec3 cross = glm::cross(to_next, to_previous);
    return std::atan2(std::sqrt(glm::dot(cross, cross)), glm::dot(to_next, to_previous));
}

int append_normal(ObjMesh& mesh, const glm::vec3& normal)
{
    mesh.normals.push_back(normal);
    return static_cast<int>(mesh.normals.size()) - 1;
}

glm::dvec3 vector_area(const ObjMesh& mesh, const Polygon& polygon)
{
    glm::dvec3 sum(0);
    for (int i = 0; i < polygon.face_count; ++i) {
        sum += vector_area(mesh, mesh.faces[polygon.first_face + i]);
    }
    return sum;
}

/// Gives the polygon's normal to those of its corners that take it; true when some are left for their
/// group's.
bool complete_flat(ObjMesh& mesh, const Polygon& polygon)
{
    int flat_normal = MISSING;
    bool some_left = false;
    for (int i = 0; i < polygon.face_count; ++i) {
        for (FaceVertex& vertex : mesh.faces[polygon.first_face + i].vertices) {
            const bool has_normal = vertex.normal != MISSING;
            if (has_normal && is_normalisable(mesh.normals[vertex.normal])) {
                continue;
            }
            if (!has_normal && polygon.smoothing_group != 0) {
                some_left = true;
                continue;
            }
            if (flat_normal == MISSING) {
                flat_normal = append_normal(mesh, direction_of(vector_area(mesh, polygon)));
            }
            vertex.normal = flat_normal;
        }
    }
    return some_left;
}

/// A corner of a face in a smoothing group. Sorted, the corners that share a normal are neighbours.
struct SmoothCorner
{
    int position;
    int smoothing_group;
    int face;
    int corner;

    auto key() const { return std::tie(position, smoothing_group, face, corner); }
    bool operator<(const SmoothCorner& other) const { return key() < other.key(); }
    bool shares_normal_with(const SmoothCorner& other) const
    {
        return position == other.position && smoothing_group == other.smoothing_group;
    }
};

std::vector<SmoothCorner> sorted_smooth_corners(const ObjMesh& mesh, std::span<const Polygon> polygons)
{
    std::vector<SmoothCorner> corners;
    for (const Polygon& polygon : polygons) {
        if (polygon.smoothing_group != 0) {
            for (int face = polygon.first_face; face < polygon.first_face + polygon.face_count; ++face) {
                for (int corner = 0; corner < 3; ++corner) {
                    corners.push_back(
                        {mesh.faces[face].vertices[corner].position, polygon.smoothing_group, face, corner});
                }
            }
        }
    }
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// Gives the mean normal of corners that share one to those that have none.
void complete_shared(ObjMesh& mesh, std::span<const SmoothCorner> corners)
{
    glm::dvec3 sum(0);
    for (const SmoothCorner& c : corners) {
        if (const glm::dvec3 area = vector_area(mesh, mesh.faces[c.face]); !vanishes(area)) {
            sum +=
                area * (corner_angle(mesh, mesh.faces[c.face], c.corner) / std::sqrt(glm::dot(area, area)));
        }
    }
    constexpr double MIN_LENGTH = 1e-9; // what is left when normals cancel is rounding, and points anywhere
    const bool cancels = glm::dot(sum, sum) < MIN_LENGTH * MIN_LENGTH;
    int shared_normal = MISSING;
    for (const SmoothCorner& c : corners) {
        int& normal = mesh.faces[c.face].vertices[c.corner].normal;
        if (normal != MISSING) {
            continue;
        }
        if (cancels) {
            normal = append_normal(mesh, direction_of(vector_area(mesh, mesh.faces[c.face])));
        } else if (shared_normal == MISSING) {
            normal = shared_normal = append_normal(mesh, direction_of(sum));
        } else {
            normal = shared_normal;
        }
    }
}

void complete_smooth(ObjMesh& mesh, std::span<const Polygon> polygons)
{
    const std::vector<SmoothCorner> corners = sorted_smooth_corners(mesh, polygons);
    for (std::size_t begin = 0; begin < corners.size();) {
        std::size_t end = begin + 1;
        while (end < corners.size() && corners[end].shares_normal_with(corners[begin])) {
            ++end;
        }
        complete_shared(mesh, std::span(corners).subspan(begin, end - begin));
        begin = end;
    }
}

} // namespace

bool is_normalisable(const glm::vec3& normal)
{
    const float squared = glm::dot(normal, normal);
    return squared >= std::numeric_limits<float>::min() && squared <= std::numeric_limits<float>::max();
}

void complete_normals(ObjMesh& mesh, std::span<const Polygon> polygons)
{
    bool some_left = false;
    for (const Polygon& polygon : polygons) {
        some_left |= complete_flat(mesh, polygon);
    }
    if (some_left) {
        complete_smooth(mesh, polygons);
    }
}

} // namespace mesh
