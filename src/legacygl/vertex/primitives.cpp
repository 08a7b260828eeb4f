#include "legacygl/vertex/primitives.h"

namespace legacygl {
namespace {

/// Returns how many vertices one separate point, line or triangle takes; 0 for connected modes.
std::uint32_t separate_size(GLenum mode)
{
    switch (mode) {
    case GL_POINTS:
        return 1;
    case GL_LINES:
        return 2;
    case GL_TRIANGLES:
        return 3;
    default:
        return 0;
    }
}

} // namespace

PrimitiveClass class_of(GLenum mode)
{
    switch (mode) {
    case GL_POINTS:
        return PrimitiveClass::points;
    case GL_LINES:
    case GL_LINE_STRIP:
    case GL_LINE_LOOP:
        return PrimitiveClass::lines;
    default:
        return PrimitiveClass::triangles;
    }
}

void append_indices(GLenum mode, std::uint32_t first, std::uint32_t count, std::vector<std::uint32_t>& out,
                    QuadOrder quad_order)
{
    const auto line = [&](std::uint32_t a, std::uint32_t b) {
        out.insert(out.end(), {first + a, first + b});
    };
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        out.insert(out.end(), {first + a, first + b, first + c});
    };
    switch (mode) {
    case GL_POINTS:
        for (std::uint32_t i = 0; i < count; ++i) {
            out.push_back(first + i);
        }
        break;
    case GL_LINES:
        for (std::uint32_t i = 0; i + 1 < count; i += 2) {
            line(i, i + 1);
        }
        break;
    case GL_LINE_STRIP:
    case GL_LINE_LOOP:
        for (std::uint32_t i = 0; i + 1 < count; ++i) {
            line(i, i + 1);
        }
        if (mode == GL_LINE_LOOP && count > 1) {
            line(count - 1, 0);
        }
        break;
    case GL_TRIANGLES:
        for (std::uint32_t i = 0; i + 2 < count; i += 3) {
            triangle(i, i + 1, i + 2);
        }
        break;
    case GL_TRIANGLE_STRIP:
        for (std::uint32_t i = 0; i + 2 < count; ++i) {
            i % 2 == 0 ? triangle(i, i + 1, i + 2) : triangle(i + 1, i, i + 2);
        }
        break;
    case GL_TRIANGLE_FAN:
        for (std::uint32_t i = 1; i + 1 < count; ++i) {
            triangle(0, i, i + 1);
        }
        break;
    case GL_QUADS:
        for (std::uint32_t i = 0; i + 3 < count; i += 4) {
            triangle(i, i + 1, quad_order.from_first ? i + 2 : i + 3);
            triangle(quad_order.from_first ? i : i + 1, i + 2, i + 3);
        }
        break;
    case GL_QUAD_STRIP:
        for (std::uint32_t i = 0; i + 3 < count; i += 2) {
            if (quad_order.emitted) {
                triangle(i, i + 1, i + 3);
            }
            triangle(i + 2, i, i + 3);
            if (!quad_order.emitted) {
                triangle(i, i + 1, i + 3);
            }
        }
        break;
    case GL_POLYGON:
        for (std::uint32_t i = 0; i + 2 < count; ++i) {
            triangle(i + 1, i + 2, 0);
        }
        break;
    default:
        break;
    }
}

void make_runs(std::span<const Primitive> primitives, std::vector<DrawRun>& runs,
               std::vector<std::uint32_t>& indices, QuadOrders* quad_orders)
{
    for (std::size_t p = 0; p < primitives.size(); ++p) {
        const Primitive& primitive = primitives[p];
        const PrimitiveClass cls = class_of(primitive.mode);
        const std::uint32_t size = separate_size(primitive.mode);
        DrawRun* last = runs.empty() ? nullptr : &runs.back();
        if (last && last->primitive != cls) {
            last = nullptr;
        }

        if (size != 0 && (!last || (!last->indexed && last->first + last->count == primitive.first))) {
            const std::uint32_t whole = primitive.count / size * size;
            if (whole == 0) {
                continue;
            }
            if (last) {
                last->count += whole;
            } else {
                runs.push_back({cls, false, primitive.first, whole});
            }
            continue;
        }

        const auto begin = static_cast<std::uint32_t>(indices.size());
        if (last && !last->indexed) {
            // Turn what was drawn without indices into indices, so that both are one draw call.
            for (std::uint32_t i = 0; i < last->count; ++i) {
                indices.push_back(last->first + i);
            }
            *last = {cls, true, begin, last->count};
        }
        append_indices(primitive.mode, primitive.first, primitive.count, indices,
                       quad_orders ? quad_orders->of(p) : QuadOrder{});
        const auto added = static_cast<std::uint32_t>(indices.size()) - begin;
        if (added == 0) {
            continue;
        }
        if (last) {
            last->count = static_cast<std::uint32_t>(indices.size()) - last->first;
        } else {
            runs.push_back({cls, true, begin, added});
        }
    }
}

} // namespace legacygl
