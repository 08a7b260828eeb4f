#include "mesh/obj_reader.h"

#include "base/quoted.h"
#include "mesh/normals.h"
#include "mesh/obj_number.h"
#include "mesh/obj_statements.h"
#include "mesh/polygon.h"

#include <array>
#include <utility>

namespace mesh {
namespace {

/// Turns an index as written, 1-based or counting backwards, into a 0-based one below `count`.
Cause resolve_index(int written, std::size_t count, const char* kind, int& index)
{
    const int size = static_cast<int>(count);
    index = written > 0 ? written - 1 : size + written;
    if (index >= 0 && index < size) {
        return {};
    }
    return std::string(kind) + " index " + std::to_string(written) +
           " is out of range: " + std::to_string(size) + (size == 1 ? " was" : " were") +
           " given before this line";
}

/// Builds a mesh statement by statement.
class Builder
{
public:
    explicit Builder(std::string_view text) : statements_(text) {}

    /// Reads all of the text; a fault's line is where it was found.
    TextFault read()
    {
        while (statements_.next_statement()) {
            fault_line_ = statements_.statement_line();
            if (Cause cause = read_statement(statements_.next_word()); !cause.empty()) {
                return {fault_line_, std::move(cause)};
            }
        }
        if (mesh_.faces.empty()) {
            return {0, mesh_.positions.empty() ? "the file has no vertices and no faces; is it an OBJ file?"
                                               : "the file has vertices but no faces"};
        }
        return {};
    }

    /// Returns the mesh read, its normals completed.
    ObjMesh finish() &&
    {
        complete_normals(mesh_, polygons_);
        return std::move(mesh_);
    }

private:
    Cause read_statement(std::string_view keyword)
    {
        if (keyword == "v") {
            return read_position();
        }
        if (keyword == "vn") {
            return read_normal();
        }
        if (keyword == "vt") {
            return read_texture_coordinate();
        }
        if (keyword == "f") {
            return read_face();
        }
        if (keyword == "s") {
            read_smoothing_group();
        }
        if (keyword == "g") {
            group_ = statements_.next_word();
        }
        return {};
    }

    /// Reads the statement's numbers into `numbers_`, `least` to `most` of them. `what` completes "...
    /// needs".
    Cause read_numbers(std::size_t least, std::size_t most, const char* what)
    {
        number_count_ = 0;
        numbers_ = {};
        for (std::string_view word = statements_.next_word(); !word.empty(); word = statements_.next_word()) {
            if (number_count_ == most) {
                return std::string(what) + "; this line has more";
            }
            float& number = numbers_[number_count_++];
            if (Cause cause = read_number(word, number); !cause.empty()) {
                fault_line_ = statements_.word_line();
                return cause;
            }
        }
        if (number_count_ < least) {
            return std::string(what) + "; this line has " + std::to_string(number_count_);
        }
        return {};
    }

    Cause read_position()
    {
        Cause cause = read_numbers(
            3, MAX_NUMBERS, "a vertex (v) needs three numbers, and may have a weight or a colour after them");
        if (cause.empty()) {
            mesh_.positions.emplace_back(numbers_[0], numbers_[1], numbers_[2]);
        }
        return cause;
    }

    Cause read_normal()
    {
        Cause cause = read_numbers(3, 3, "a normal (vn) needs three numbers");
        if (cause.empty()) {
            mesh_.normals.emplace_back(numbers_[0], numbers_[1], numbers_[2]);
        }
        return cause;
    }

    Cause read_texture_coordinate()
    {
        Cause cause = read_numbers(1, 3, "a texture coordinate (vt) needs one to three numbers");
        if (cause.empty()) {
            mesh_.texture_coordinates.emplace_back(numbers_[0], numbers_[1]);
        }
        return cause;
    }

    /// `s off`, `s 0` and what is not a positive number switch smoothing off: it decides on shading only, so
    /// is no error.
    void read_smoothing_group()
    {
        WrittenCorner number;
        const std::string_view word = statements_.next_word();
        const bool is_number = read_corner(word, number).empty() && number.has_form_of({});
        smoothing_group_ = is_number && number.position > 0 ? number.position : 0;
    }

    Cause read_corner_of_face(std::string_view word, WrittenCorner& first)
    {
        WrittenCorner written;
        if (Cause cause = read_corner(word, written); !cause.empty()) {
            return cause;
        }
        if (corners_.empty()) {
            first = written;
        } else if (!written.has_form_of(first)) {
            return "a face must be written the same way at all its corners (v, v/vt, v//vn or v/vt/vn); " +
                   base::quoted(word) + " differs from the corners before it";
        }
        FaceVertex vertex;
        Cause cause = resolve_index(written.position, mesh_.positions.size(), "vertex", vertex.position);
        if (cause.empty() && written.texture_coordinate != 0) {
            cause = resolve_index(written.texture_coordinate, mesh_.texture_coordinates.size(),
                                  "texture coordinate", vertex.texture_coordinate);
        }
        if (cause.empty() && written.normal != 0) {
            cause = resolve_index(written.normal, mesh_.normals.size(), "normal", vertex.normal);
        }
        corners_.push_back(vertex);
        return cause;
    }

    Cause read_face()
    {
        corners_.clear();
        WrittenCorner first;
        for (std::string_view word = statements_.next_word(); !word.empty(); word = statements_.next_word()) {
            if (Cause cause = read_corner_of_face(word, first); !cause.empty()) {
                fault_line_ = statements_.word_line();
                return cause;
            }
        }
        if (corners_.size() < 3) {
            return "a face (f) needs at least three vertices; this one has " +
                   std::to_string(corners_.size());
        }
        if (mesh_.faces.size() + corners_.size() - 2 > MAX_OBJ_TRIANGLES) {
            return "the model has more than " + std::to_string(MAX_OBJ_TRIANGLES) +
                   " triangles; reduce the number of its polygons";
        }
        return cut_face();
    }

    Cause cut_face()
    {
        triangles_.clear();
        outline_.clear();
        for (const FaceVertex& corner : corners_) {
            outline_.push_back(mesh_.positions[corner.position]);
        }
        if (!triangulate_polygon(outline_, triangles_, polygon_steps_left_)) {
            return "the outline of this face is too intricate to be cut into triangles; triangulate it in "
                   "the "
                   "modelling program";
        }
        polygons_.push_back(
            {static_cast<int>(mesh_.faces.size()), static_cast<int>(triangles_.size()), smoothing_group_});
        add_to_group(static_cast<int>(triangles_.size()));
        for (const CornerTriangle& t : triangles_) {
            mesh_.faces.push_back({{corners_[t[0]], corners_[t[1]], corners_[t[2]]}});
        }
        return {};
    }

    /// Notes that the next `face_count` faces belong to the current group, if there is one.
    void add_to_group(int face_count)
    {
        if (group_.empty()) {
            return;
        }
        const int first_face = static_cast<int>(mesh_.faces.size());
        if (!mesh_.groups.empty()) {
            FaceGroup& last = mesh_.groups.back();
            if (last.name == group_ && last.first_face + last.face_count == first_face) {
                last.face_count += face_count;
                return;
            }
        }
        mesh_.groups.push_back({std::string(group_), first_face, face_count});
    }

    static constexpr std::size_t MAX_NUMBERS = 8; // x y z, w, r g b a

    ObjStatements statements_;
    int fault_line_ = 0;
    ObjMesh mesh_;
    std::vector<Polygon> polygons_;
    int smoothing_group_ = 0;
    std::string_view group_; // of the text
    long long polygon_steps_left_ = MAX_POLYGON_STEPS;

    // Of the current statement; members so that they keep their memory.
    std::array<float, MAX_NUMBERS> numbers_{};
    std::size_t number_count_ = 0;
    std::vector<FaceVertex> corners_;
    std::vector<glm::vec3> outline_;
    std::vector<CornerTriangle> triangles_;
};

} // namespace

base::Result<ObjMesh> read_obj(std::string_view file_name, std::string_view text)
{
    if (TextFault fault = check_obj_text(text); !fault.cause.empty()) {
        return base::ReadError{std::string(file_name), fault.line, std::move(fault.cause)};
    }
    Builder builder(text);
    if (TextFault fault = builder.read(); !fault.cause.empty()) {
        return base::ReadError{std::string(file_name), fault.line, std::move(fault.cause)};
    }
    return std::move(builder).finish();
}

} // namespace mesh
