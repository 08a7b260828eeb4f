// GLU where no picture is needed: what it gives to OpenGL, and what it makes of bad input.

#include "recorded_gl.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

namespace {

class Glu : public RecordedGl
{
protected:
    Glu() { gluQuadricCallback(quadric, GLU_ERROR, reinterpret_cast<_GLUfuncptr>(note_error)); }
    ~Glu() override { gluDeleteQuadric(quadric); }

    std::vector<LegacyGLCall> calls_of(void (*draw)(GLUquadric*))
    {
        context->capture.begin();
        draw(quadric);
        const auto calls = context->capture.end();
        return {calls.begin(), calls.end()};
    }

    static void note_error(GLenum code) { error = code; }

    GLUquadric* quadric = gluNewQuadric();
    static inline GLenum error = 0;
};

bool is(const LegacyGLCall& call, const char* name)
{
    return std::string_view(call.name) == name;
}

/// Returns a component of the vector that a call was noted with; its size is noted first.
double component(const LegacyGLCall& call, int i)
{
    return call.arguments[1 + i];
}

TEST_F(Glu, ASphereHasItsVerticesOnTheSphereAndItsNormalsAlongThem)
{
    LegacyGLCall normal{};
    int vertices = 0;
    for (const LegacyGLCall& call : calls_of([](GLUquadric* q) { gluSphere(q, 2, 12, 6); })) {
        if (is(call, "glNormal3f")) {
            normal = call;
        }
        if (!is(call, "glVertex3f")) {
            continue;
        }
        ++vertices;
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(component(call, i), 2 * component(normal, i), 1e-6);
        }
    }
    EXPECT_EQ(vertices, 2 * 14 + 4 * 26); // Two fans and four strips.
}

TEST_F(Glu, AnInsideSphereTurnsItsNormals)
{
    gluQuadricOrientation(quadric, GLU_INSIDE);
    LegacyGLCall normal{};
    for (const LegacyGLCall& call : calls_of([](GLUquadric* q) { gluSphere(q, 1, 8, 4); })) {
        if (is(call, "glNormal3f")) {
            normal = call;
        }
        if (is(call, "glVertex3f")) {
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(component(call, i), -component(normal, i), 1e-6);
            }
        }
    }
}

TEST_F(Glu, EveryCircleClosesWithoutAGap)
{
    std::vector<LegacyGLCall> vertices;
    for (const LegacyGLCall& call : calls_of([](GLUquadric* q) { gluCylinder(q, 1, 0.5, 2, 7, 1); })) {
        if (is(call, "glVertex3f")) {
            vertices.push_back(call);
        }
    }
    ASSERT_EQ(vertices.size(), 16u);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(component(vertices[0], i), component(vertices[14], i));
        EXPECT_EQ(component(vertices[1], i), component(vertices[15], i));
    }
}

TEST_F(Glu, TextureCoordinatesAreGivenOnlyWhenAskedFor)
{
    const auto given = [this] {
        const auto calls = calls_of([](GLUquadric* q) {
            gluSphere(q, 1, 5, 5);
            gluCylinder(q, 1, 1, 1, 5, 5);
            gluDisk(q, 0, 1, 5, 5);
        });
        return std::count_if(calls.begin(), calls.end(),
                             [](const LegacyGLCall& call) { return is(call, "glTexCoord2f"); });
    };
    EXPECT_EQ(given(), 0);
    gluQuadricTexture(quadric, GL_TRUE);
    EXPECT_GT(given(), 0);
}

TEST_F(Glu, TooFineDivisionsAreBoundAndTooCoarseOnesRefused)
{
    const auto calls = calls_of([](GLUquadric* q) { gluDisk(q, 0, 1, 1 << 30, 1); });
    EXPECT_EQ(std::count_if(calls.begin(), calls.end(),
                            [](const LegacyGLCall& call) { return is(call, "glVertex3f"); }),
              241);
    error = 0;
    gluSphere(quadric, 1, 1, 1);
    EXPECT_EQ(error, static_cast<GLenum>(GLU_INVALID_VALUE));
}

TEST_F(Glu, ABadSettingIsRefusedAndChangesNothing)
{
    error = 0;
    gluQuadricDrawStyle(quadric, GL_LINE);
    EXPECT_EQ(error, static_cast<GLenum>(GLU_INVALID_ENUM));
    const auto calls = calls_of([](GLUquadric* q) { gluDisk(q, 0.5, 1, 4, 1); });
    EXPECT_TRUE(std::any_of(calls.begin(), calls.end(), [](const LegacyGLCall& call) {
        return is(call, "glBegin") && call.arguments[0] == GL_QUAD_STRIP;
    }));
}

TEST_F(Glu, UnProjectingTakesBackWhatProjectingDid)
{
    const GLdouble model[16] = {1, 0, 0, 0, 0, 0.8, 0.6, 0, 0, -0.6, 0.8, 0, 1, 2, -9, 1};
    const GLdouble projection[16] = {1.5, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1.2, -1, 0, 0, -2.2, 0};
    const GLint viewport[4] = {5, 6, 640, 480};
    GLdouble window[3], object[3];
    ASSERT_EQ(gluProject(0.3, -0.4, 1.5, model, projection, viewport, &window[0], &window[1], &window[2]),
              GL_TRUE);
    ASSERT_EQ(gluUnProject(window[0], window[1], window[2], model, projection, viewport, &object[0],
                           &object[1], &object[2]),
              GL_TRUE);
    EXPECT_NEAR(object[0], 0.3, 1e-12);
    EXPECT_NEAR(object[1], -0.4, 1e-12);
    EXPECT_NEAR(object[2], 1.5, 1e-12);
}

TEST_F(Glu, NothingIsUnProjectedThroughAMatrixWithoutInverse)
{
    const GLdouble zero[16] = {}, identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const GLint viewport[4] = {0, 0, 10, 10};
    GLdouble x = 7, y = 7, z = 7;
    EXPECT_EQ(gluUnProject(1, 1, 0, identity, zero, viewport, &x, &y, &z), GL_FALSE);
    EXPECT_EQ(gluProject(1, 1, 0, identity, zero, viewport, &x, &y, &z), GL_FALSE);
    EXPECT_EQ(x, 7);
}

TEST_F(Glu, MipmapsReachDownToOneTexel)
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const std::vector<GLubyte> pixels(19 * 5 * 3, 200);
    EXPECT_EQ(gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 19, 5, GL_RGB, GL_UNSIGNED_BYTE, pixels.data()), 0);
    const auto& levels = context->state.texturing.bound(legacygl::TextureTarget::two_dimensional).levels;
    ASSERT_EQ(levels.size(), 5u); // 16 × 4, 8 × 2, 4 × 1, 2 × 1, 1 × 1
    EXPECT_EQ(levels[0].width, 16);
    EXPECT_EQ(levels[0].height, 4);
    EXPECT_EQ(levels[4].width, 1);
    EXPECT_EQ(levels[4].rgba[0], 200); // All of one colour stays so.
}

TEST_F(Glu, AnImageOfOneColourStaysSoAtAnySize)
{
    for (int size = 1; size < 40; ++size) {
        const std::vector<GLubyte> in(7 * 7, 93);
        std::vector<GLubyte> out(static_cast<std::size_t>(size) * size);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        ASSERT_EQ(gluScaleImage(GL_LUMINANCE, 7, 7, GL_UNSIGNED_BYTE, in.data(), size, size, GL_UNSIGNED_BYTE,
                                out.data()),
                  0);
        EXPECT_EQ(std::set<GLubyte>(out.begin(), out.end()), std::set<GLubyte>{93}) << size;
    }
}

TEST_F(Glu, WhatIsNotImplementedLinksAndDoesNothing)
{
    EXPECT_EQ(gluNewTess(), nullptr);
    EXPECT_EQ(gluNewNurbsRenderer(), nullptr);
    gluTessBeginPolygon(nullptr, nullptr);
    gluDeleteTess(nullptr);
    EXPECT_NE(gluBuild3DMipmaps(GL_TEXTURE_3D, GL_RGB, 1, 1, 1, GL_RGB, GL_FLOAT, nullptr), 0);
    EXPECT_STREQ(reinterpret_cast<const char*>(gluGetString(GLU_EXTENSIONS)), "");
}

} // namespace
