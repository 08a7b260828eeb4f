#pragma once

#include "base/result.h"
#include "mesh/obj_mesh.h"

#include <cstddef>
#include <string_view>

namespace mesh {

/// The longest OBJ text that is read, in bytes: some 400,000 triangles with all their indices. It takes half
/// a second.
inline constexpr std::size_t MAX_OBJ_BYTES = std::size_t{32} << 20;

/// The most triangles that are read from one OBJ text, polygons counted as cut.
inline constexpr std::size_t MAX_OBJ_TRIANGLES = 2'000'000;

/// The longest line, in bytes. A face of 20,000 vertices fits several times over.
inline constexpr std::size_t MAX_OBJ_LINE_BYTES = std::size_t{1} << 20;

/// How many steps cutting the concave polygons of one text may take: a second or two of work.
/// Polygons that do not cross themselves need a few dozen steps a vertex.
inline constexpr long long MAX_POLYGON_STEPS = 1LL << 26;

/// Reads the faces of an OBJ text and what they are made of.
///
/// `v`, `vt`, `vn`, `f`, `g` and `s` are read; every other statement is tolerated and skipped. Lines may end
/// in LF, CR LF or CR, a backslash before the line's end continues it, and `#` starts a comment. Numbers have
/// a decimal point in every locale.
/// - Positions: the first three numbers of `v`; a weight or a colour after them is dropped.
/// - Texture coordinates: the first two numbers of `vt`; a missing second one is 0.
/// - Indices count from 1, or backwards from -1, and must name something further up in the text.
/// - Groups: the first name of `g`; one without a name ends the group before. A group without faces is
/// dropped.
/// - Polygons are cut into n - 2 triangles each (see polygon.h), concave ones too.
/// - Given normals are kept as they are, except that one too short or too long to be normalised is replaced,
/// where a
///   face uses it, by that face's. Missing ones are computed (see normals.h) and appended; computed ones have
///   length 1.
///
/// Every float of the result is finite and every index is within its array. `file_name` is used in errors
/// only. Errors (line, cause): no text, not a text, too long, no faces, too few or too many or malformed
/// numbers, a number outside float's range, an index that names nothing, a face of fewer than three vertices
/// or of mixed forms, too many triangles, outlines too intricate to be cut.
base::Result<ObjMesh> read_obj(std::string_view file_name, std::string_view text);

} // namespace mesh
