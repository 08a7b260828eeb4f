// What kind of transform a matrix is, and its inverse by that.

#include "legacygl/state/matrix.h"

#include <cmath>
#include <initializer_list>
#include <utility>

namespace legacygl {
namespace {

float square(float x)
{
    return x * x;
}

} // namespace

const float* Matrix::inverse() const
{
    analyse();
    return inverse_.data();
}

bool Matrix::preserves_length() const
{
    analyse();
    return only(rotation | translation);
}

void Matrix::analyse() const
{
    if (analysed_) {
        return;
    }
    const Kind kind = content_known_ ? kind_from_content() : kind_from_values();
    content_known_ = true;
    if (!invert(kind)) {
        inverse_ = IDENTITY;
    }
    analysed_ = true;
}

Matrix::Kind Matrix::kind_from_content() const
{
    const bool flat = m_[10] == 1 && m_[14] == 0;
    if (content_ == 0) {
        return Kind::identity;
    }
    if (only(translation | uniform_scale | general_scale)) {
        return flat ? Kind::scaled_2d : Kind::scaled_3d;
    }
    if (only(AFFINE)) {
        return Kind::affine;
    }
    return Kind::general;
}

Matrix::Kind Matrix::kind_from_values() const
{
    const auto zero = [this](std::initializer_list<int> indices) {
        for (int i : indices) {
            if (m_[i] != 0) {
                return false;
            }
        }
        return true;
    };
    constexpr float TOLERANCE = 1e-12f; // (1e-6)², as the squares below are compared.

    content_ = zero({12, 13, 14}) ? 0u : static_cast<std::uint32_t>(translation);
    if (!zero({3, 7, 11}) || m_[15] != 1) {
        content_ |= general;
        return Kind::general;
    }
    if (zero({1, 2, 4, 6, 8, 9})) {
        if (m_[10] == 1 && m_[14] == 0) {
            if (m_[0] == 1 && m_[5] == 1) {
                return content_ == 0 ? Kind::identity : Kind::scaled_2d;
            }
            content_ |= general_scale;
            return Kind::scaled_2d;
        }
        if (square(m_[0] - m_[5]) < TOLERANCE && square(m_[0] - m_[10]) < TOLERANCE) {
            if (square(m_[0] - 1.0f) > TOLERANCE) {
                content_ |= uniform_scale;
            }
        } else {
            content_ |= general_scale;
        }
        return Kind::scaled_3d;
    }
    if (zero({2, 6, 8, 9, 14}) && m_[10] == 1) {
        const float xx = m_[0] * m_[0] + m_[1] * m_[1];
        const float yy = m_[4] * m_[4] + m_[5] * m_[5];
        const float xy = m_[0] * m_[4] + m_[1] * m_[5];
        if (square(xx - 1) > TOLERANCE || square(yy - 1) > TOLERANCE) {
            content_ |= general_scale;
        }
        content_ |= square(xy) > TOLERANCE ? general_3d : rotation;
        return Kind::affine;
    }
    const auto dot = [this](int a, int b) {
        return m_[a] * m_[b] + m_[a + 1] * m_[b + 1] + m_[a + 2] * m_[b + 2];
    };
    const float xx = dot(0, 0), yy = dot(4, 4), zz = dot(8, 8), xy = dot(0, 4);
    if (square(xx - yy) < TOLERANCE && square(xx - zz) < TOLERANCE) {
        if (square(xx - 1.0f) > TOLERANCE) {
            content_ |= uniform_scale;
        }
    } else {
        content_ |= general_scale;
    }
    if (square(xy) < TOLERANCE) {
        const float cx = m_[1] * m_[6] - m_[2] * m_[5] - m_[8];
        const float cy = m_[2] * m_[4] - m_[0] * m_[6] - m_[9];
        const float cz = m_[0] * m_[5] - m_[1] * m_[4] - m_[10];
        content_ |= cx * cx + cy * cy + cz * cz < TOLERANCE ? rotation : general_3d;
    } else {
        content_ |= general_3d;
    }
    return Kind::affine;
}

bool Matrix::invert(Kind kind) const
{
    switch (kind) {
    case Kind::identity:
        inverse_ = IDENTITY;
        return true;
    case Kind::scaled_2d:
        return invert_scaled(true);
    case Kind::scaled_3d:
        return invert_scaled(false);
    case Kind::affine:
        return invert_affine();
    default:
        return invert_general();
    }
}

bool Matrix::invert_scaled(bool two_dimensional) const
{
    const int axes = two_dimensional ? 2 : 3;
    for (int axis = 0; axis < axes; ++axis) {
        if (m_[5 * axis] == 0) {
            return false;
        }
    }
    inverse_ = IDENTITY;
    for (int axis = 0; axis < axes; ++axis) {
        inverse_[5 * axis] = 1.0f / m_[5 * axis];
        if (content_ & translation) {
            inverse_[12 + axis] = -(m_[12 + axis] * inverse_[5 * axis]);
        }
    }
    return true;
}

bool Matrix::invert_affine() const
{
    if (!only(rotation | translation | uniform_scale)) {
        return invert_affine_general();
    }
    inverse_ = IDENTITY;
    if (content_ & (uniform_scale | rotation)) {
        float factor = 1.0f;
        if (content_ & uniform_scale) {
            factor = m_[0] * m_[0] + m_[4] * m_[4] + m_[8] * m_[8];
            if (factor == 0) {
                return false;
            }
            factor = 1.0f / factor;
        }
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                inverse_[row + 4 * column] = factor * m_[column + 4 * row];
            }
        }
    }
    if (content_ & translation) {
        for (int row = 0; row < 3; ++row) {
            inverse_[12 + row] =
                -(m_[12] * inverse_[row] + m_[13] * inverse_[row + 4] + m_[14] * inverse_[row + 8]);
        }
    }
    return true;
}

bool Matrix::invert_affine_general() const
{
    const auto at = [this](int row, int column) { return m_[row + 4 * column]; };
    // The determinant's positive and negative terms are summed apart, which loses fewer digits.
    float positive = 0, negative = 0;
    for (const float term : {at(0, 0) * at(1, 1) * at(2, 2), at(1, 0) * at(2, 1) * at(0, 2),
                             at(2, 0) * at(0, 1) * at(1, 2), -at(2, 0) * at(1, 1) * at(0, 2),
                             -at(1, 0) * at(0, 1) * at(2, 2), -at(0, 0) * at(2, 1) * at(1, 2)}) {
        (term >= 0 ? positive : negative) += term;
    }
    float determinant = positive + negative;
    if (std::fabs(determinant) < 1e-25f) {
        return false;
    }
    determinant = 1.0f / determinant;

    inverse_ = IDENTITY;
    const auto set = [&](int row, int column, float value) { inverse_[row + 4 * column] = value; };
    set(0, 0, (at(1, 1) * at(2, 2) - at(2, 1) * at(1, 2)) * determinant);
    set(0, 1, -(at(0, 1) * at(2, 2) - at(2, 1) * at(0, 2)) * determinant);
    set(0, 2, (at(0, 1) * at(1, 2) - at(1, 1) * at(0, 2)) * determinant);
    set(1, 0, -(at(1, 0) * at(2, 2) - at(2, 0) * at(1, 2)) * determinant);
    set(1, 1, (at(0, 0) * at(2, 2) - at(2, 0) * at(0, 2)) * determinant);
    set(1, 2, -(at(0, 0) * at(1, 2) - at(1, 0) * at(0, 2)) * determinant);
    set(2, 0, (at(1, 0) * at(2, 1) - at(2, 0) * at(1, 1)) * determinant);
    set(2, 1, -(at(0, 0) * at(2, 1) - at(2, 0) * at(0, 1)) * determinant);
    set(2, 2, (at(0, 0) * at(1, 1) - at(1, 0) * at(0, 1)) * determinant);
    for (int row = 0; row < 3; ++row) {
        inverse_[12 + row] =
            -(m_[12] * inverse_[row] + m_[13] * inverse_[row + 4] + m_[14] * inverse_[row + 8]);
    }
    return true;
}

/// Gauss-Jordan elimination with partial pivoting, in double and rounded once.
bool Matrix::invert_general() const
{
    double a[4][8];
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            a[row][column] = static_cast<double>(m_[row + 4 * column]);
            a[row][column + 4] = row == column ? 1.0 : 0.0;
        }
    }
    for (int column = 0; column < 4; ++column) {
        int pivot = column;
        for (int row = column + 1; row < 4; ++row) {
            if (std::fabs(a[row][column]) > std::fabs(a[pivot][column])) {
                pivot = row;
            }
        }
        if (!(std::fabs(a[pivot][column]) > 0.0)) {
            return false;
        }
        if (pivot != column) {
            for (int k = 0; k < 8; ++k) {
                std::swap(a[pivot][k], a[column][k]);
            }
        }
        const double divisor = a[column][column];
        for (int k = 0; k < 8; ++k) {
            a[column][k] /= divisor;
        }
        for (int row = 0; row < 4; ++row) {
            const double factor = a[row][column];
            if (row == column || factor == 0.0) {
                continue;
            }
            for (int k = 0; k < 8; ++k) {
                a[row][k] -= factor * a[column][k];
            }
        }
    }
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            inverse_[row + 4 * column] = static_cast<float>(a[row][column + 4]);
        }
    }
    return true;
}

} // namespace legacygl
