#pragma once

#include <cstddef>

namespace legacygl {

/// Bytes that a pointer argument points to; copied when the call is compiled into a list.
struct Blob
{
    const void* data;
    std::size_t size;
};

} // namespace legacygl
