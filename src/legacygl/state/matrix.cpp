#include "legacygl/state/matrix.h"

#include <cmath>
#include <cstring>

namespace legacygl {
namespace {

constexpr double PI = 3.14159265358979323846;

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

} // namespace legacygl
