#pragma once

#include "mesh/obj_statements.h"

#include <string_view>

namespace mesh {

/// The indices of one corner of a face as written: 1-based, negative counting backwards, 0: not given.
struct WrittenCorner
{
    int position = 0;
    int texture_coordinate = 0;
    int normal = 0;

    /// True when both give the same kinds of index: `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    bool has_form_of(const WrittenCorner& other) const
    {
        return (texture_coordinate == 0) == (other.texture_coordinate == 0) &&
               (normal == 0) == (other.normal == 0);
    }
};

/// Reads a number such as -1, .5, 2. or 1.5e-3 into `value`, whatever the locale, rounded to the nearest
/// double and that to the nearest float. Returns why it is not a finite float, if so.
[[nodiscard]] Cause read_number(std::string_view word, float& value);

/// Reads a corner of a face, `v`, `v/vt`, `v//vn` or `v/vt/vn`, into `corner`. Returns what is wrong with it,
/// if so. The indices read are not 0, but may name nothing.
[[nodiscard]] Cause read_corner(std::string_view word, WrittenCorner& corner);

} // namespace mesh
