#include "legacygl/stipple_image.h"

#include <cstddef>

namespace legacygl {
namespace {

constexpr int SIZE = 32;

/// Where pixel (x, y) of a bitmap lies in client memory.
struct BitPlace
{
    std::size_t byte;
    int shift;
};

BitPlace place(const PixelStore& store, int x, int y)
{
    const std::size_t length = static_cast<std::size_t>(store.row_length > 0 ? store.row_length : SIZE);
    const auto alignment = static_cast<std::size_t>(store.alignment);
    const std::size_t row_bytes = ((length + 7) / 8 + alignment - 1) / alignment * alignment;
    const auto bit = static_cast<std::size_t>(store.skip_pixels + x);
    const int in_byte = static_cast<int>(bit % 8);
    return {row_bytes * static_cast<std::size_t>(store.skip_rows + y) + bit / 8,
            store.lsb_first ? in_byte : 7 - in_byte};
}

} // namespace

StippleRows unpack_stipple(const PixelStore& unpack, const std::uint8_t* bits)
{
    StippleRows rows{};
    for (int y = 0; y < SIZE; ++y)
        for (int x = 0; x < SIZE; ++x) {
            const BitPlace p = place(unpack, x, y);
            rows[y] |= static_cast<std::uint32_t>(bits[p.byte] >> p.shift & 1) << (31 - x);
        }
    return rows;
}

void pack_stipple(const StippleRows& rows, const PixelStore& pack, std::uint8_t* bits)
{
    for (int y = 0; y < SIZE; ++y)
        for (int x = 0; x < SIZE; ++x) {
            const BitPlace p = place(pack, x, y);
            const auto mask = static_cast<std::uint8_t>(1u << p.shift);
            const bool set = rows[y] >> (31 - x) & 1;
            bits[p.byte] = static_cast<std::uint8_t>(set ? bits[p.byte] | mask : bits[p.byte] & ~mask);
        }
}

} // namespace legacygl
