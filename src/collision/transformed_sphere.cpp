#include "collision/transformed_sphere.h"

#include "collision/matrix_norm.h"
#include "collision/rounding.h"

#include <cmath>

namespace collision {

BoundingSphere transformed(const BoundingSphere& sphere, const glm::mat4& matrix)
{
    if (sphere.is_empty()) {
        return sphere;
    }
    const glm::dmat4 exact(matrix);
    BoundingSphere result;
    double lost = 0.0; // by rounding the centre: as much as that, what is inside may lie further out
    for (int row = 0; row < 3; ++row) {
        double coordinate = exact[3][row];
        for (int column = 0; column < 3; ++column) {
            const WithError product = two_product(exact[column][row], sphere.centre[column]);
            const WithError sum = two_sum(coordinate, product.value);
            coordinate = sum.value;
            lost = sum_up(lost, sum_up(std::abs(product.error), std::abs(sum.error)));
        }
        result.centre[row] = coordinate;
    }
    result.radius = sum_up(product_up(sphere.radius, largest_stretch(glm::mat3(matrix))), lost);
    return result;
}

} // namespace collision
