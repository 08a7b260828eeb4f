#include "legacygl/pixel/client_bitmap.h"

#include <cstddef>

namespace legacygl {
namespace {

/// Where a pixel of a bitmap lies.
struct BitPlace
{
    std::size_t byte;
    int shift;
};

BitPlace place(const PixelStore& store, int width, int x, int y)
{
    const auto length = static_cast<std::size_t>(store.row_length > 0 ? store.row_length : width);
    const auto alignment = static_cast<std::size_t>(store.alignment);
    const std::size_t row_bytes = ((length + 7) / 8 + alignment - 1) / alignment * alignment;
    const auto bit = static_cast<std::size_t>(store.skip_pixels + x);
    const int in_byte = static_cast<int>(bit % 8);
    return {row_bytes * static_cast<std::size_t>(store.skip_rows + y) + bit / 8,
            store.lsb_first ? in_byte : 7 - in_byte};
}

} // namespace

bool read_bit(const PixelStore& store, int width, int x, int y, const std::uint8_t* bits)
{
    const BitPlace p = place(store, width, x, y);
    return bits[p.byte] >> p.shift & 1;
}

void write_bit(const PixelStore& store, int width, int x, int y, bool value, std::uint8_t* bits)
{
    const BitPlace p = place(store, width, x, y);
    const auto mask = static_cast<std::uint8_t>(1u << p.shift);
    bits[p.byte] = static_cast<std::uint8_t>(value ? bits[p.byte] | mask : bits[p.byte] & ~mask);
}

} // namespace legacygl
