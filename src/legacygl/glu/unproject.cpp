// Coordinate projection (GLU 1.3, chapter 4.2), all of it in double.

#include <GL/gl.h>
#include <GL/glu.h>

#include <array>

namespace {

using Vector = std::array<double, 4>;
using Matrix = std::array<double, 16>; ///< Column by column.

Vector transform(const GLdouble* m, const Vector& v)
{
    Vector out;
    for (int row = 0; row < 4; ++row) {
        out[row] = v[0] * m[row] + v[1] * m[row + 4] + v[2] * m[row + 8] + v[3] * m[row + 12];
    }
    return out;
}

/// Returns what first does, then second.
Matrix combined(const GLdouble* first, const GLdouble* second)
{
    Matrix out;
    for (int column = 0; column < 4; ++column) {
        const GLdouble* c = first + static_cast<std::ptrdiff_t>(4) * column;
        const Vector result = transform(second, {c[0], c[1], c[2], c[3]});
        for (int row = 0; row < 4; ++row) {
            out[4 * column + row] = result[row];
        }
    }
    return out;
}

/// Returns the determinant of m without one row and one column, its sign that of the cofactor.
double cofactor(const Matrix& m, int without_row, int without_column)
{
    std::array<std::array<double, 3>, 3> minor; // minor[column][row]
    for (int column = 0, to_column = 0; column < 4; ++column) {
        if (column == without_column) {
            continue;
        }
        for (int row = 0, to_row = 0; row < 4; ++row) {
            if (row != without_row) {
                minor[to_column][to_row++] = m[4 * column + row];
            }
        }
        ++to_column;
    }
    const auto& [a, b, c] = minor;
    // The sign goes to the first factors, and the products are added in one row: so the last bits are
    // libGLU's.
    const double sign = (without_row + without_column) % 2 == 0 ? 1 : -1;
    const double a0 = sign * a[0], b0 = sign * b[0], c0 = sign * c[0];
    return a0 * b[1] * c[2] - a0 * b[2] * c[1] - b0 * a[1] * c[2] + b0 * a[2] * c[1] + c0 * a[1] * b[2] -
           c0 * a[2] * b[1];
}

/// Returns whether m has an inverse, and that in out (Cramer's rule).
bool invert(const Matrix& m, Matrix& out)
{
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            out[4 * column + row] = cofactor(m, column, row);
        }
    }
    const double determinant = m[0] * out[0] + m[1] * out[4] + m[2] * out[8] + m[3] * out[12];
    if (determinant == 0) {
        return false;
    }
    const double scale = 1 / determinant;
    for (double& value : out) {
        value *= scale;
    }
    return true;
}

/// Returns whether a point of the window could be taken back to object space, and its four coordinates.
bool unproject(double x, double y, double depth, double clip_w, const GLdouble* model, const GLdouble* proj,
               const GLint* view, Vector& out)
{
    Matrix inverse;
    if (!invert(combined(model, proj), inverse)) {
        return false;
    }
    out = transform(inverse.data(), {(x - view[0]) / view[2] * 2 - 1, (y - view[1]) / view[3] * 2 - 1,
                                     depth * 2 - 1, clip_w});
    return out[3] != 0;
}

} // namespace

GLint gluProject(GLdouble objX, GLdouble objY, GLdouble objZ, const GLdouble* model, const GLdouble* proj,
                 const GLint* view, GLdouble* winX, GLdouble* winY, GLdouble* winZ)
{
    const Vector clip = transform(proj, transform(model, {objX, objY, objZ, 1}));
    if (clip[3] == 0) {
        return GL_FALSE;
    }
    *winX = (clip[0] / clip[3] * 0.5 + 0.5) * view[2] + view[0];
    *winY = (clip[1] / clip[3] * 0.5 + 0.5) * view[3] + view[1];
    *winZ = clip[2] / clip[3] * 0.5 + 0.5;
    return GL_TRUE;
}

GLint gluUnProject(GLdouble winX, GLdouble winY, GLdouble winZ, const GLdouble* model, const GLdouble* proj,
                   const GLint* view, GLdouble* objX, GLdouble* objY, GLdouble* objZ)
{
    Vector object;
    if (!unproject(winX, winY, winZ, 1, model, proj, view, object)) {
        return GL_FALSE;
    }
    *objX = object[0] / object[3];
    *objY = object[1] / object[3];
    *objZ = object[2] / object[3];
    return GL_TRUE;
}

GLint gluUnProject4(GLdouble winX, GLdouble winY, GLdouble winZ, GLdouble clipW, const GLdouble* model,
                    const GLdouble* proj, const GLint* view, GLdouble nearVal, GLdouble farVal,
                    GLdouble* objX, GLdouble* objY, GLdouble* objZ, GLdouble* objW)
{
    Vector object;
    if (!unproject(winX, winY, (winZ - nearVal) / (farVal - nearVal), clipW, model, proj, view, object)) {
        return GL_FALSE;
    }
    *objX = object[0];
    *objY = object[1];
    *objZ = object[2];
    *objW = object[3];
    return GL_TRUE;
}
