#include "collision/matrix_norm.h"

#include "collision/rounding.h"

#include <algorithm>
#include <cmath>

namespace collision {

namespace {

/// A symmetric 3x3 matrix: the diagonal, and the elements (1,2), (2,0), (0,1), each opposite to its number.
struct Symmetric
{
    double diagonal[3];
    double beside[3];
};

/// Returns the matrix's transpose times itself, its eigenvalues being the squares of the singular values.
/// Elements beside the diagonal come without their sign in `bound`, everything there rounded up.
void gram_matrix(const glm::mat3& matrix, Symmetric& gram, Symmetric& bound)
{
    const glm::dmat3 m(matrix);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        gram.diagonal[i] = bound.diagonal[i] = 0.0;
        gram.beside[i] = 0.0;
        double error = 0.0;
        for (int row = 0; row < 3; ++row) {
            // Products of floats are exact in double.
            bound.diagonal[i] = sum_up(bound.diagonal[i], m[i][row] * m[i][row]);
            const WithError sum = two_sum(gram.beside[i], m[j][row] * m[k][row]);
            gram.beside[i] = sum.value;
            error = sum_up(error, std::abs(sum.error));
        }
        gram.diagonal[i] = bound.diagonal[i];
        bound.beside[i] = sum_up(std::abs(gram.beside[i]), error);
    }
}

/// Returns a bound of the largest eigenvalue: the largest sum of a row. Gershgorin 1931.
double largest_row(const Symmetric& bound)
{
    double largest = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double beside = sum_up(bound.beside[(i + 1) % 3], bound.beside[(i + 2) % 3]);
        largest = std::max(largest, sum_up(bound.diagonal[i], beside));
    }
    return largest;
}

/// Turns the matrix about axis k so that the element opposite to k becomes 0.
/// Golub and Van Loan, Matrix Computations, 8.5.2.
void jacobi_rotation(Symmetric& a, int k)
{
    const int p = (k + 1) % 3;
    const int q = (k + 2) % 3;
    if (a.beside[k] == 0.0) {
        return;
    }
    const double ratio = (a.diagonal[q] - a.diagonal[p]) / (2.0 * a.beside[k]);
    const double root = std::sqrt(1.0 + ratio * ratio);
    const double t = ratio >= 0.0 ? 1.0 / (ratio + root) : 1.0 / (ratio - root);
    const double c = 1.0 / std::sqrt(1.0 + t * t);
    const double s = t * c;
    a.diagonal[p] -= t * a.beside[k];
    a.diagonal[q] += t * a.beside[k];
    a.beside[k] = 0.0;
    const double beside_p = a.beside[q]; // element (k, p) is opposite to q
    const double beside_q = a.beside[p];
    a.beside[q] = c * beside_p - s * beside_q;
    a.beside[p] = s * beside_p + c * beside_q;
}

double largest_eigenvalue(Symmetric a)
{
    // Six sweeps bring the rest far below a double's last place; it converges quadratically.
    for (int sweep = 0; sweep < 6; ++sweep) {
        for (int k = 0; k < 3; ++k) {
            jacobi_rotation(a, k);
        }
    }
    return std::max({a.diagonal[0], a.diagonal[1], a.diagonal[2]});
}

} // namespace

double largest_stretch(const glm::mat3& matrix)
{
    Symmetric gram;
    Symmetric bound;
    gram_matrix(matrix, gram, bound);
    const double row = largest_row(bound);
    const double diagonal = std::max({bound.diagonal[0], bound.diagonal[1], bound.diagonal[2]});
    if (row <= diagonal * (1.0 + 1e-6)) {
        return sqrt_up(row); // a rotation, a uniform scale, a scale along the axes
    }
    // The rotations round eighteen times; 1e-12 is a thousand times that.
    return sqrt_up(std::min(row, largest_eigenvalue(gram) * (1.0 + 1e-12)));
}

} // namespace collision
