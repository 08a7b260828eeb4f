#pragma once

#include "legacygl/glu/client_image.h"

#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace legacygl::glu {

/// Images of any component type, rows without gaps, and the filters gluBuild2DMipmaps makes its levels with.
/// Sums and roundings are libGLU's, type by type, so that its textures and ours have the same texels.
template <class T> struct TypedImage
{
    TypedImage(int w, int h, int c) : TypedImage(w, h, c, std::vector<T>(static_cast<std::size_t>(w) * h * c))
    {}
    TypedImage(int w, int h, int c, std::vector<T> v)
        : width(w), height(h), components(c), values(std::move(v))
    {}

    T* at(int x, int y) { return &values[(static_cast<std::size_t>(y) * width + x) * components]; }
    const T* at(int x, int y) const
    {
        return &values[(static_cast<std::size_t>(y) * width + x) * components];
    }

    int width, height, components;
    std::vector<T> values;
};

/// Returns the mean of two values (of a texture one texel wide or high).
template <class T> T mean(T a, T b)
{
    if constexpr (std::is_same_v<T, GLfloat>) {
        return (a + b) / 2;
    } else if constexpr (std::is_same_v<T, GLint>) {
        // libGLU reads them as unsigned here; what is negative is 0 in a texture anyway.
        return to_int(static_cast<double>(static_cast<float>(static_cast<GLuint>(a)) +
                                          static_cast<float>(static_cast<GLuint>(b))) /
                      2);
    } else if constexpr (std::is_same_v<T, GLuint>) {
        return static_cast<T>((static_cast<double>(a) + static_cast<double>(b)) / 2);
    } else {
        return static_cast<T>((a + b) / 2);
    }
}

/// Returns the mean of four values, integers rounded to the nearest.
template <class T> T mean(T a, T b, T c, T d)
{
    if constexpr (std::is_same_v<T, GLfloat>) {
        return (a + b + c + d) / 4;
    } else if constexpr (std::is_same_v<T, GLint>) {
        const float sum =
            static_cast<float>(a) + static_cast<float>(b) + static_cast<float>(c) + static_cast<float>(d);
        return to_int(static_cast<double>(sum / 4) + 0.5);
    } else if constexpr (std::is_same_v<T, GLuint>) {
        return static_cast<T>((static_cast<double>(a) + b + c + d) / 4 + 0.5);
    } else {
        return static_cast<T>((a + b + c + d + 2) / 4);
    }
}

/// Returns the image at half its size; a side of 1 stays. An odd side's last row or column is left out.
/// The image is larger than 1 × 1.
template <class T> TypedImage<T> halved(const TypedImage<T>& image)
{
    TypedImage<T> out(std::max(1, image.width / 2), std::max(1, image.height / 2), image.components);
    const int dx = image.width > 1 ? 1 : 0, dy = image.height > 1 ? 1 : 0;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            for (int k = 0; k < image.components; ++k) {
                const T* a = image.at(2 * x, 2 * y) + k;
                if (dx && dy) {
                    out.at(x, y)[k] = mean(*a, image.at(2 * x + 1, 2 * y)[k], image.at(2 * x, 2 * y + 1)[k],
                                           image.at(2 * x + 1, 2 * y + 1)[k]);
                } else {
                    out.at(x, y)[k] = mean(*a, image.at(2 * x + dx, 2 * y + dy)[k]);
                }
            }
        }
    }
    return out;
}

/// Walks over the stretches of input that each output row (or column) covers: from a fraction of one input
/// row to a fraction of another. They meet without a gap.
class StretchWalk
{
public:
    StretchWalk(int size, int new_size)
        : step_(static_cast<float>(size) / static_cast<float>(new_size)),
          whole_step_(static_cast<int>(std::floor(step_))),
          fraction_step_(step_ - static_cast<float>(whole_step_)), high(whole_step_),
          high_fraction(fraction_step_)
    {}
    void next()
    {
        low = high;
        low_fraction = high_fraction;
        high += whole_step_;
        high_fraction += fraction_step_;
        if (high_fraction > 1) {
            high_fraction -= 1;
            ++high;
        }
    }
    float step() const { return step_; }

private:
    float step_;
    int whole_step_;
    float fraction_step_;

public:
    int low = 0;
    float low_fraction = 0; ///< How much of low the stretch leaves out.
    int high;
    float high_fraction; ///< How much of high it covers.
};

/// Converts a scaled value back to the image's type.
template <class T> T from_scaled(float value)
{
    if constexpr (std::is_same_v<T, GLuint>) {
        // 2^32 is not a value of the type, but the float next to its greatest.
        constexpr auto MAX_VALUE = std::numeric_limits<GLuint>::max();
        return value >= static_cast<float>(MAX_VALUE) ? MAX_VALUE : static_cast<T>(value);
    } else if constexpr (std::is_same_v<T, GLfloat>) {
        return value;
    } else {
        return static_cast<T>(to_int(static_cast<double>(value)));
    }
}

/// What becomes of the last row when the height is a multiple of the new one.
enum class LastRow : bool
{
    whole,
    /// It loses its last input row, and where the height stays it is black: libGLU 9.0.2 ends there one row
    /// early for all types but the packed ones, and programs are to look as they do with it.
    cut
};

/// Returns the image scaled to another size by a box filter; values are cut off, not rounded.
template <class T>
TypedImage<T> scaled(const TypedImage<T>& image, int new_width, int new_height, LastRow last_row)
{
    if (image.width == 2 * new_width && image.height == 2 * new_height) {
        return halved(image);
    }
    TypedImage<T> out(new_width, new_height, image.components);
    StretchWalk rows(image.height, new_height);
    for (int y = 0; y < new_height; ++y, rows.next()) {
        if (last_row == LastRow::cut) {
            rows.high = std::min(rows.high, image.height - 1);
        }
        StretchWalk columns(image.width, new_width);
        for (int x = 0; x < new_width; ++x, columns.next()) {
            std::array<float, 4> totals{};
            const auto add = [&](int column, int row, float weight) {
                // One column or row beyond the image may be asked for, with no weight.
                const T* from = image.at(std::min(column, image.width - 1), std::min(row, image.height - 1));
                for (int k = 0; k < image.components; ++k) {
                    totals[k] += static_cast<float>(from[k]) * weight;
                }
            };
            const auto add_row = [&](int row, float weight) {
                add(columns.low, row, weight * (1 - columns.low_fraction));
                for (int column = columns.low + 1; column < columns.high; ++column) {
                    add(column, row, weight);
                }
                add(columns.high, row, weight * columns.high_fraction);
            };
            const bool many_rows = rows.high > rows.low, many_columns = columns.high > columns.low;
            const float row_part = rows.high_fraction - rows.low_fraction;
            const float column_part = columns.high_fraction - columns.low_fraction;
            if (many_rows && many_columns) {
                add_row(rows.low, 1 - rows.low_fraction);
                add_row(rows.high, rows.high_fraction);
                for (int row = rows.low + 1; row < rows.high; ++row) {
                    const T* left = image.at(columns.low, row);
                    const T* right = image.at(std::min(columns.high, image.width - 1), row);
                    for (int k = 0; k < image.components; ++k) {
                        totals[k] += static_cast<float>(left[k]) * (1 - columns.low_fraction) +
                                     static_cast<float>(right[k]) * columns.high_fraction;
                    }
                }
                for (int row = rows.low + 1; row < rows.high; ++row) {
                    for (int column = columns.low + 1; column < columns.high; ++column) {
                        add(column, row, 1);
                    }
                }
            } else if (many_rows) {
                add(columns.low, rows.low, (1 - rows.low_fraction) * column_part);
                for (int row = rows.low + 1; row < rows.high; ++row) {
                    add(columns.low, row, column_part);
                }
                add(columns.low, rows.high, column_part * rows.high_fraction);
            } else if (many_columns) {
                add_row(rows.low, row_part);
            } else {
                add(columns.low, rows.low, row_part * column_part);
            }
            const float area = columns.step() * rows.step();
            for (int k = 0; k < image.components; ++k) {
                out.at(x, y)[k] = from_scaled<T>(totals[k] / area);
            }
        }
    }
    return out;
}

} // namespace legacygl::glu
