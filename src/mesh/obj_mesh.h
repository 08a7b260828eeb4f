#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace mesh {

/// One corner of a face: 0-based indices into the three arrays of its ObjMesh.
struct FaceVertex
{
    int position = -1;
    int normal = -1;             ///< never -1 in a mesh that read_obj returned
    int texture_coordinate = -1; ///< -1: none

    bool operator==(const FaceVertex&) const = default;
};

/// A triangle. Corners in the file's order: anticlockwise seen from outside, where the file keeps to that.
struct Face
{
    std::array<FaceVertex, 3> vertices;

    bool operator==(const Face&) const = default;
};

/// Faces that follow each other and that the file puts into one group.
struct FaceGroup
{
    std::string name; ///< the first one that the file's `g` gives
    int first_face = 0;
    int face_count = 0; ///< at least 1

    bool operator==(const FaceGroup&) const = default;
};

/// A triangle mesh as an OBJ file and the lab have it: three arrays, and faces that index each separately.
struct ObjMesh
{
    std::vector<glm::vec3> positions;           ///< in the file's units
    std::vector<glm::vec3> normals;             ///< of any length that GL_NORMALIZE can normalise
    std::vector<glm::vec2> texture_coordinates; ///< (0, 0) is the image's lower left corner
    std::vector<Face> faces;
    std::vector<FaceGroup> groups; ///< in the order of the faces; faces of no group are in none
};

} // namespace mesh
