#pragma once

#include "image/image.h"
#include "mesh/normals.h"
#include "mesh/obj_mesh.h"
#include "mesh/obj_reader.h"

#include <cmath>
#include <string>

// What must hold of everything the readers return, whatever they were given. Shared by the tests and the fuzz
// targets. Each function returns what does not hold; empty: all is well.

inline std::string broken_invariant(const mesh::ObjMesh& m)
{
    for (const glm::vec3& p : m.positions) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
            return "a position is not finite";
        }
    }
    for (const glm::vec2& t : m.texture_coordinates) {
        if (!std::isfinite(t.x) || !std::isfinite(t.y)) {
            return "a texture coordinate is not finite";
        }
    }
    for (const glm::vec3& n : m.normals) {
        if (!std::isfinite(n.x) || !std::isfinite(n.y) || !std::isfinite(n.z)) {
            return "a normal is not finite";
        }
    }
    const auto is_index = [](int index, std::size_t size) { return index >= 0 && std::size_t(index) < size; };
    for (const mesh::Face& face : m.faces) {
        for (const mesh::FaceVertex& v : face.vertices) {
            if (!is_index(v.position, m.positions.size())) {
                return "a position index is out of range";
            }
            if (!is_index(v.normal, m.normals.size())) {
                return "a normal index is out of range";
            }
            if (!mesh::is_normalisable(m.normals[std::size_t(v.normal)])) {
                return "a face uses a normal that cannot be normalised";
            }
            if (v.texture_coordinate != -1 && !is_index(v.texture_coordinate, m.texture_coordinates.size())) {
                return "a texture coordinate index is out of range";
            }
        }
    }
    std::size_t ungrouped = 0; // the first face that no group before has
    for (const mesh::FaceGroup& group : m.groups) {
        if (group.name.empty() || group.face_count < 1 || group.first_face < 0 ||
            std::size_t(group.first_face) < ungrouped) {
            return "a group has no name, no faces or those of another";
        }
        ungrouped = std::size_t(group.first_face) + std::size_t(group.face_count);
        if (ungrouped > m.faces.size()) {
            return "a group's faces are out of range";
        }
    }
    if (m.faces.empty()) {
        return "there are no faces";
    }
    return m.faces.size() > mesh::MAX_OBJ_TRIANGLES ? "there are too many faces" : "";
}

inline std::string broken_invariant(const image::Image& image)
{
    if (image.width < 1 || image.height < 1 || image.width > image::MAX_IMAGE_SIDE ||
        image.height > image::MAX_IMAGE_SIDE) {
        return "the size is out of range";
    }
    if (image.channels != 3 && image.channels != 4) {
        return "there are neither 3 nor 4 channels";
    }
    if (image.pixels.size() !=
        std::size_t(image.width) * std::size_t(image.height) * std::size_t(image.channels)) {
        return "the number of bytes does not match the size";
    }
    return "";
}

inline std::string broken_invariant(const base::ReadError& error, int line_count)
{
    if (error.cause.size() < 10) {
        return "the cause is no sentence";
    }
    if (error.cause.size() > 300) {
        return "the cause is too long to be read";
    }
    if (error.line < 0 || error.line > line_count) {
        return "the line does not exist";
    }
    for (const char c : error.cause) {
        if (c < ' ' || c > '~') {
            return "the cause holds a character that may not print";
        }
    }
    return "";
}
