#include "legacygl/pixel/stipple_image.h"

#include "legacygl/pixel/client_bitmap.h"

namespace legacygl {
namespace {

constexpr int SIZE = 32;

} // namespace

StippleRows unpack_stipple(const PixelStore& unpack, const std::uint8_t* bits)
{
    StippleRows rows{};
    for (int y = 0; y < SIZE; ++y) {
        for (int x = 0; x < SIZE; ++x) {
            rows[y] |= static_cast<std::uint32_t>(read_bit(unpack, SIZE, x, y, bits)) << (31 - x);
        }
    }
    return rows;
}

void pack_stipple(const StippleRows& rows, const PixelStore& pack, std::uint8_t* bits)
{
    for (int y = 0; y < SIZE; ++y) {
        for (int x = 0; x < SIZE; ++x) {
            write_bit(pack, SIZE, x, y, rows[y] >> (31 - x) & 1, bits);
        }
    }
}

} // namespace legacygl
