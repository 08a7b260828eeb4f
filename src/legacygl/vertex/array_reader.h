#pragma once

#include "legacygl/vertex/client_arrays.h"

#include <glm/vec4.hpp>

namespace legacygl {

/// Returns element i of an array as its attribute takes it: colours and normals of integers as fractions,
/// missing components as (0, 0, 0, 1). An element beyond its buffer object reads as if missing.
glm::vec4 read_element(const ClientArray& array, Attribute attribute, GLint i);

/// Gives element i of the enabled arrays to the assembler: first all attributes, then the vertex
/// (OpenGL 1.5, 2.8, glArrayElement).
template <class Assembler> void give_element(const ClientArrays& arrays, GLint i, Assembler& to)
{
    for (int a = ATTRIBUTE_COUNT; a-- > 0;) {
        const ClientArray& array = arrays.arrays[a];
        if (!array.enabled) {
            continue;
        }
        const auto attribute = static_cast<Attribute>(a);
        const glm::vec4 value = read_element(array, attribute, i);
        if (attribute == Attribute::position) {
            to.vertex(array.size, value);
        } else {
            to.attribute(attribute, array.size, value);
        }
    }
}

} // namespace legacygl
