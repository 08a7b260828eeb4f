#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>

namespace legacygl {

/// A column-major 4x4 matrix that knows what kind of transform it is.
///
/// The kind chooses how the inverse is computed and whether lengths are preserved. Both decide the last
/// bit of a lit vertex, so the kinds and the order of the additions are those that Mesa uses: a picture
/// can then be compared with Mesa's byte by byte. OpenGL 1.5, 2.11.2, defines the transforms.
class Matrix
{
public:
    /// What a matrix may contain, as a set; identity is the empty set.
    enum Content : std::uint32_t
    {
        rotation = 1,
        translation = 2,
        uniform_scale = 4,
        general_scale = 8,
        general_3d = 16,
        perspective = 32,
        general = 64,
    };

    Matrix() { set_identity(); }

    void set_identity();
    /// Replaces the matrix by 16 column-major values.
    void load(const float* values);

    /// Post-multiplies by 16 column-major values of unknown kind.
    void multiply(const float* values);
    void translate(float x, float y, float z);
    void scale(float x, float y, float z);
    /// Post-multiplies a rotation about (x, y, z), which need not be of unit length.
    /// A vector shorter than 1e-4 leaves the matrix as it is.
    void rotate(float degrees, float x, float y, float z);
    void frustum(float left, float right, float bottom, float top, float near_plane, float far_plane);
    void ortho(float left, float right, float bottom, float top, float near_plane, float far_plane);

    const float* values() const { return m_.data(); }
    /// Returns the 16 column-major values of the inverse; the identity when the matrix is singular.
    const float* inverse() const;
    /// Returns whether the matrix is a rotation and a translation at most.
    bool preserves_length() const;

    /// Returns left * right, both affine or not.
    static Matrix product(const Matrix& left, const Matrix& right);

    glm::vec4 transform(glm::vec4 point) const;

private:
    struct Unset
    {};
    /// Leaves the members to the caller.
    explicit Matrix(Unset) {}

    enum class Kind : std::uint8_t
    {
        identity,
        scaled_2d,
        scaled_3d,
        affine,
        general
    };

    static constexpr std::array<float, 16> IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    static constexpr std::uint32_t AFFINE =
        rotation | translation | uniform_scale | general_scale | general_3d;

    void multiply(const float* values, std::uint32_t content);
    void analyse() const;
    Kind kind_from_values() const;
    Kind kind_from_content() const;
    bool invert(Kind kind) const;
    bool invert_scaled(bool two_dimensional) const;
    bool invert_affine() const;
    bool invert_affine_general() const;
    bool invert_general() const;
    bool only(std::uint32_t content) const { return (content_ & ~content) == 0; }

    std::array<float, 16> m_;
    mutable std::array<float, 16> inverse_;
    mutable std::uint32_t content_;
    mutable bool content_known_; ///< content_ can be trusted without looking at the values.
    mutable bool analysed_;
};

} // namespace legacygl
