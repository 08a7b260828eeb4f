#include "original_set.h"

#include "tank/original_layout.h"

#include <array>
#include <cstdio>

namespace assets {

namespace {

using tank::Box;
using tank::MeshKind;

/// Writes an OBJ text, quirks and all.
class ObjText
{
public:
    ObjText(const char* group, bool textured, const OriginalSetOptions& options)
        : options_(options), textured_(textured)
    {
        text_ = "# exported\ng " + std::string(group) + "\ns 1\n";
    }

    /// Adds the six sides of a box, each of `steps` by `steps` squares of two triangles.
    void add_box(const Box& box, int steps)
    {
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool upper : {false, true}) {
                add_side(box, axis, upper, steps);
            }
        }
    }

    std::string take() { return std::move(text_); }

private:
    void add_side(const Box& box, int axis, bool upper, int steps)
    {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        glm::vec3 normal(0.0f);
        normal[axis] = upper ? 1.0f : -1.0f;
        const int first = vertices_ + 1;
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; j <= steps; ++j) {
                glm::vec3 corner = upper ? box.maximum : box.minimum;
                const std::array<float, 2> part = {float(i) / float(steps), float(j) / float(steps)};
                corner[u] = i == steps ? box.maximum[u]
                                       : box.minimum[u] + part[0] * (box.maximum[u] - box.minimum[u]);
                corner[v] = j == steps ? box.maximum[v]
                                       : box.minimum[v] + part[1] * (box.maximum[v] - box.minimum[v]);
                add_vertex(corner, normal, part);
            }
        }
        for (int i = 0; i < steps; ++i) {
            for (int j = 0; j < steps; ++j) {
                const int a = first + i * (steps + 1) + j;
                const int b = a + steps + 1;
                add_triangle(a, b, b + 1, upper);
                add_triangle(a, b + 1, a + 1, upper);
            }
        }
    }

    void add_vertex(const glm::vec3& position, const glm::vec3& normal, const std::array<float, 2>& texture)
    {
        // From 0.2 to 3.8 in steps that do not repeat soon.
        const double length = options_.varied_normals ? 0.2 + 3.6 * ((vertices_ * 7) % 31) / 30.0 : 1.0;
        add("v %.6f %.6f %.6f\n", glm::dvec3(position) * options_.unit);
        add("vn %.6f %.6f %.6f\n", glm::dvec3(normal) * length);
        if (textured_) {
            add("vt %.6f %.6f %.6f\n", {double(texture[0]), double(texture[1]), 0.0});
        }
        ++vertices_;
    }

    void add_triangle(int a, int b, int c, bool anticlockwise)
    {
        const bool reversed = options_.reversed_faces && triangles_ % 17 == 5;
        if (anticlockwise == reversed) {
            std::swap(b, c);
        }
        text_ += "f";
        for (const int corner : {a, b, c}) {
            const std::string index = std::to_string(corner);
            text_ += textured_ ? " " + index + "/" + index + "/" + index : " " + index + "//" + index;
        }
        text_ += "\n";
        ++triangles_;
    }

    void add(const char* format, const glm::dvec3& numbers)
    {
        char line[128];
        std::snprintf(line, sizeof line, format, numbers.x, numbers.y, numbers.z);
        text_ += line;
    }

    const OriginalSetOptions& options_;
    bool textured_;
    std::string text_;
    int vertices_ = 0;
    int triangles_ = 0;
};

/// Returns the parts of a mesh's shape: of the turret a flat body and two whip antennas, which reach higher.
std::vector<Box> shape_of(MeshKind mesh, const OriginalSetOptions& options)
{
    Box box = tank::box_of(tank::original_boxes(), mesh);
    if (mesh != MeshKind::turret) {
        return {box};
    }
    box.minimum.z *= options.turret_stretch;
    box.maximum.z *= options.turret_stretch;
    Box flat = box;
    flat.maximum.y = MADE_ROOF;
    const float z = box.minimum.z + 5.0f;
    return {flat,
            {{-20.0f, MADE_ROOF, z}, {-19.5f, box.maximum.y, z + 0.5f}},
            {{19.5f, MADE_ROOF, z}, {20.0f, box.maximum.y, z + 0.5f}}};
}

std::string obj_text(const MeshFile& file, const OriginalSetOptions& options)
{
    // As many triangles as the lab's meshes have, about: 6 sides of 2 steps^2.
    constexpr std::array<int, tank::MESH_KIND_COUNT> STEPS = {11, 6, 6, 2, 3};
    ObjText text("part", file.level == lod::Level::high, options);
    for (const Box& box : shape_of(file.mesh, options)) {
        text.add_box(box, file.level == lod::Level::high ? STEPS[tank::index_of(file.mesh)] : 1);
    }
    return text.take();
}

} // namespace

std::string original_tga()
{
    constexpr int SIDE = 1024;
    // Run-length encoded true colour, 24 bits, descriptor 0: "rows from the bottom", which is not so.
    std::string bytes = {0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, SIDE >> 8, 0, SIDE >> 8, 24, 0};
    for (int row = 0; row < SIDE; ++row) {
        const bool upper = row < SIDE / 2;
        for (int packet = 0; packet < SIDE / 128; ++packet) {
            bytes.push_back(static_cast<char>(0x80 | 127));
            for (const int channel : {upper ? 0 : 200, 0, upper ? 200 : 0}) { // blue, green, red
                bytes.push_back(static_cast<char>(channel));
            }
        }
    }
    return bytes;
}

Files original_set(const OriginalSetOptions& options)
{
    Files files;
    for (const MeshFile& file : mesh_files()) {
        if (file.level == lod::Level::high || options.has_low_model) {
            files.add("tankobjs/" + std::string(file.name), obj_text(file, options));
        }
    }
    if (options.has_texture) {
        files.add("texture.tga", original_tga());
    }
    return files;
}

} // namespace assets
