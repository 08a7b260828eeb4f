#include "legacygl/state/matrix.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using legacygl::Matrix;

void expect_inverse(const Matrix& m, float tolerance = 1e-5f)
{
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            float sum = 0;
            for (int k = 0; k < 4; ++k) {
                sum += m.values()[row + 4 * k] * m.inverse()[k + 4 * column];
            }
            EXPECT_NEAR(sum, row == column ? 1.0f : 0.0f, tolerance) << row << "," << column;
        }
    }
}

TEST(Matrix, InvertsEveryKind)
{
    Matrix m;
    expect_inverse(m);
    m.translate(1, -2, 3);
    expect_inverse(m);
    m.rotate(37, 0, 0, 1);
    expect_inverse(m);
    m.rotate(50, 1, 2, -3);
    expect_inverse(m);
    m.scale(2, 2, 2);
    expect_inverse(m);
    m.scale(1, 0.3f, 5);
    expect_inverse(m);
    Matrix projection;
    projection.frustum(-1, 2, -1, 1, 1, 50);
    expect_inverse(projection, 1e-4f);
    expect_inverse(Matrix::product(projection, m), 1e-3f);
}

TEST(Matrix, ALoadedMatrixIsInvertedLikeTheSameMadeByCalls)
{
    Matrix made;
    made.translate(1, 2, 3);
    made.rotate(30, 0, 1, 0);
    Matrix loaded;
    loaded.load(made.values());
    for (int i = 0; i < 16; ++i) {
        EXPECT_EQ(loaded.inverse()[i], made.inverse()[i]) << i;
    }
    EXPECT_TRUE(loaded.preserves_length());
}

TEST(Matrix, ASingularOneHasTheIdentityForAnInverse)
{
    Matrix m;
    m.scale(1, 0, 1);
    EXPECT_EQ(m.inverse()[5], 1.0f);
    Matrix flat;
    const float zeros[16] = {};
    flat.load(zeros);
    EXPECT_EQ(flat.inverse()[0], 1.0f);
}

TEST(Matrix, OnlyRotationsAndTranslationsPreserveLength)
{
    Matrix m;
    m.rotate(20, 1, 1, 0);
    m.translate(5, 0, 0);
    EXPECT_TRUE(m.preserves_length());
    m.scale(1, 1, 1.01f);
    EXPECT_FALSE(m.preserves_length());
}

TEST(Matrix, RotatingAboutAnAxisIsTheSameAsAboutAnyMultipleOfIt)
{
    Matrix a, b;
    a.rotate(33, 0, 0, 1);
    b.rotate(33, 0, 0, 7);
    for (int i = 0; i < 16; ++i) {
        EXPECT_EQ(a.values()[i], b.values()[i]);
    }
    Matrix none;
    none.rotate(33, 0, 0, 0);
    EXPECT_EQ(none.values()[0], 1.0f);
}

TEST(Matrix, AQuarterTurnTakesXToY)
{
    Matrix m;
    m.rotate(90, 0, 0, 1);
    const glm::vec4 p = m.transform({1, 0, 0, 1});
    EXPECT_NEAR(p.x, 0, 1e-7);
    EXPECT_EQ(p.y, 1.0f);
}

} // namespace
