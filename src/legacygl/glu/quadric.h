#pragma once

#include <GL/gl.h>
#include <GL/glu.h>

#include <array>

/// How quadrics are drawn (GLU 1.3, chapter 6).
class GLUquadric
{
public:
    GLenum draw_style = GLU_FILL;
    GLenum normals = GLU_SMOOTH;
    GLenum orientation = GLU_OUTSIDE;
    bool textured = false;
    void (*error_callback)(GLenum) = nullptr;

    bool outside() const { return orientation == GLU_OUTSIDE; }
    void error(GLenum code) const
    {
        if (error_callback) {
            error_callback(code);
        }
    }
};

namespace legacygl::glu {

constexpr double PI = 3.14159265358979323846;

/// Finer divisions are drawn with this many, as libGLU draws them.
constexpr int MAX_DIVISIONS = 239;

/// The sines and cosines of count + 1 angles, evenly spread from start over span (radians), times a factor.
///
/// As libGLU has them: the angle is rounded to float, its sine is computed in double, and the product with
/// the factor is rounded once. Double sines rounded to float are the same natively and on the web.
struct AngleTable
{
    /// count is at most MAX_DIVISIONS. shift moves the angles back by a fraction of a division.
    AngleTable(int count, double span, double factor = 1, double shift = 0, float start = 0);
    /// Makes the last angle's values the first's: a full turn closes without a gap.
    void close(int count);

    std::array<float, MAX_DIVISIONS + 1> sine, cosine;
};

/// Returns the table of a full turn in count divisions, closed.
AngleTable full_turn(int count, double factor = 1, double shift = 0);

} // namespace legacygl::glu
