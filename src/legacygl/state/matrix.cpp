#include "legacygl/state/matrix.h"

#include <cmath>
#include <cstring>
#include <initializer_list>
#include <utility>

namespace legacygl {
namespace {

constexpr std::array<float, 16> IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr double PI = 3.14159265358979323846;

constexpr std::uint32_t AFFINE = Matrix::rotation | Matrix::translation | Matrix::uniform_scale |
                                 Matrix::general_scale | Matrix::general_3d;

float square(float x)
{
    return x * x;
}

/// Four floats that GCC and Clang compute with at once, each as if alone.
using Column = float __attribute__((vector_size(16)));

Column column(const float* matrix, int i)
{
    Column out;
    std::memcpy(&out, matrix + 4 * i, sizeof out);
    return out;
}

/// out = a * b; out may be a.
void multiply_4x4(float* out, const float* a, const float* b)
{
    const Column a0 = column(a, 0), a1 = column(a, 1), a2 = column(a, 2), a3 = column(a, 3);
    for (int i = 0; i < 4; ++i) {
        const float* bc = b + 4 * i;
        const Column product = a0 * bc[0] + a1 * bc[1] + a2 * bc[2] + a3 * bc[3];
        std::memcpy(out + 4 * i, &product, sizeof product);
    }
}

} // namespace

void Matrix::set_identity()
{
    m_ = IDENTITY;
    inverse_ = IDENTITY;
    content_ = 0;
    content_known_ = true;
    analysed_ = true;
}

void Matrix::load(const float* values)
{
    std::memcpy(m_.data(), values, sizeof m_);
    content_known_ = false;
    analysed_ = false;
}

void Matrix::multiply(const float* values)
{
    multiply_4x4(m_.data(), m_.data(), values);
    content_known_ = false;
    analysed_ = false;
}

void Matrix::multiply(const float* values, std::uint32_t content)
{
    multiply_4x4(m_.data(), m_.data(), values);
    content_ |= content;
    analysed_ = false;
}

void Matrix::translate(float x, float y, float z)
{
    for (int row = 0; row < 4; ++row) {
        m_[row + 12] = m_[row] * x + m_[row + 4] * y + m_[row + 8] * z + m_[row + 12];
    }
    content_ |= translation;
    analysed_ = false;
}

void Matrix::scale(float x, float y, float z)
{
    for (int row = 0; row < 4; ++row) {
        m_[row] *= x;
        m_[row + 4] *= y;
        m_[row + 8] *= z;
    }
    const bool uniform = std::fabs(x - y) < 1e-8f && std::fabs(x - z) < 1e-8f;
    content_ |= uniform ? uniform_scale : general_scale;
    analysed_ = false;
}

void Matrix::rotate(float degrees, float x, float y, float z)
{
    // The angle is rounded to float before the sine, as sinf() would see it; the sine itself is computed
    // in double so that it is the same on every platform.
    const double angle = static_cast<double>(static_cast<float>(static_cast<double>(degrees) * PI / 180.0));
    const float s = static_cast<float>(std::sin(angle));
    const float c = static_cast<float>(std::cos(angle));

    std::array<float, 16> r = IDENTITY;
    if (x == 0 && y == 0 && z != 0) {
        r[0] = r[5] = c;
        r[1] = z < 0 ? -s : s;
        r[4] = -r[1];
    } else if (x == 0 && y != 0 && z == 0) {
        r[0] = r[10] = c;
        r[8] = y < 0 ? -s : s;
        r[2] = -r[8];
    } else if (x != 0 && y == 0 && z == 0) {
        r[5] = r[10] = c;
        r[6] = x < 0 ? -s : s;
        r[9] = -r[6];
    } else {
        const float length = std::sqrt(x * x + y * y + z * z);
        if (!(length > 1e-4f)) {
            return;
        }
        x /= length;
        y /= length;
        z /= length;
        const float one_c = 1.0f - c;
        const float xy = x * y, yz = y * z, zx = z * x, xs = x * s, ys = y * s, zs = z * s;
        r[0] = one_c * (x * x) + c;
        r[4] = one_c * xy - zs;
        r[8] = one_c * zx + ys;
        r[1] = one_c * xy + zs;
        r[5] = one_c * (y * y) + c;
        r[9] = one_c * yz - xs;
        r[2] = one_c * zx - ys;
        r[6] = one_c * yz + xs;
        r[10] = one_c * (z * z) + c;
    }
    multiply(r.data(), rotation);
}

void Matrix::frustum(float left, float right, float bottom, float top, float near_plane, float far_plane)
{
    std::array<float, 16> p{};
    p[0] = (2.0f * near_plane) / (right - left);
    p[5] = (2.0f * near_plane) / (top - bottom);
    p[8] = (right + left) / (right - left);
    p[9] = (top + bottom) / (top - bottom);
    p[10] = -(far_plane + near_plane) / (far_plane - near_plane);
    p[11] = -1.0f;
    p[14] = -(2.0f * far_plane * near_plane) / (far_plane - near_plane);
    multiply(p.data(), perspective);
}

void Matrix::ortho(float left, float right, float bottom, float top, float near_plane, float far_plane)
{
    std::array<float, 16> p = IDENTITY;
    p[0] = 2.0f / (right - left);
    p[5] = 2.0f / (top - bottom);
    p[10] = -2.0f / (far_plane - near_plane);
    p[12] = -(right + left) / (right - left);
    p[13] = -(top + bottom) / (top - bottom);
    p[14] = -(far_plane + near_plane) / (far_plane - near_plane);
    multiply(p.data(), general_scale | translation);
}

Matrix Matrix::product(const Matrix& left, const Matrix& right)
{
    Matrix out{Unset{}};
    multiply_4x4(out.m_.data(), left.m_.data(), right.m_.data());
    out.content_ = left.content_ | right.content_;
    out.content_known_ = left.content_known_ && right.content_known_;
    out.analysed_ = false;
    return out;
}

glm::vec4 Matrix::transform(glm::vec4 p) const
{
    glm::vec4 out;
    for (int row = 0; row < 4; ++row) {
        out[row] = m_[row] * p[0] + m_[row + 4] * p[1] + m_[row + 8] * p[2] + m_[row + 12] * p[3];
    }
    return out;
}

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
