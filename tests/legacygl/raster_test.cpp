// What the CPU makes of polygons, lines and points that ES cannot draw itself.

#define GL_GLEXT_PROTOTYPES
#include "legacygl/pixel/pixel_conversion.h"
#include "legacygl/pixel/stipple_image.h"
#include "recorded_gl.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using legacygl::BackendRecord;
using legacygl::PrimitiveClass;

class Raster : public RecordedGl
{
protected:
    /// Returns how many vertices were drawn as primitives of a class.
    std::uint32_t drawn(PrimitiveClass primitive)
    {
        context->flush_vertices();
        std::uint32_t count = 0;
        for (const BackendRecord& draw : backend->draws()) {
            for (const legacygl::DrawRun& run : draw.runs) {
                if (run.primitive == primitive) {
                    count += run.count;
                }
            }
        }
        return count;
    }
    void square()
    {
        glBegin(GL_QUADS);
        glVertex2f(-0.5f, -0.5f);
        glVertex2f(0.5f, -0.5f);
        glVertex2f(0.5f, 0.5f);
        glVertex2f(-0.5f, 0.5f);
        glEnd();
    }
    /// The lengths of the drawn lines in clip coordinates.
    std::vector<float> line_lengths()
    {
        std::vector<float> out;
        const std::vector<Corner> all = corners();
        for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
            const glm::vec4 d = all[i + 1].position - all[i].position;
            out.push_back(std::sqrt(d.x * d.x + d.y * d.y));
        }
        return out;
    }
    void plane(GLenum name, double a, double b, double c, double d)
    {
        const GLdouble equation[4] = {a, b, c, d};
        glClipPlane(name, equation);
        glEnable(name);
    }
};

TEST_F(Raster, FilledPolygonsStayWithTheGpu)
{
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    square();
    glEndList();
    glCallList(list);
    EXPECT_EQ(backend->draws().front().kind, BackendRecord::Kind::draw);
    glPolygonMode(GL_BACK, GL_LINE);
    glEnable(GL_CULL_FACE);
    glCallList(list);
    EXPECT_EQ(backend->draws().back().kind, BackendRecord::Kind::draw) << "The back faces are culled.";
}

TEST_F(Raster, ALineModeQuadHasItsFourEdgesAndNoDiagonal)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    square();
    EXPECT_EQ(drawn(PrimitiveClass::triangles), 0u);
    for (const float length : line_lengths()) {
        EXPECT_FLOAT_EQ(length, 1);
    }
    EXPECT_EQ(drawn(PrimitiveClass::lines), 8u);
}

TEST_F(Raster, EdgesThatAreNotFlaggedAreNotDrawn)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glBegin(GL_POLYGON);
    glEdgeFlag(GL_FALSE);
    glVertex2f(0, 0);
    glEdgeFlag(GL_TRUE);
    glVertex2f(0.5f, 0);
    glVertex2f(0.5f, 0.5f);
    glEnd();
    EXPECT_EQ(drawn(PrimitiveClass::lines), 4u);
}

TEST_F(Raster, TheEdgeFlagIsCurrentStateAndAnArray)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    const GLfloat positions[6] = {0, 0, 0.5f, 0, 0.5f, 0.5f};
    const GLboolean flags[3] = {GL_FALSE, GL_FALSE, GL_TRUE};
    glVertexPointer(2, GL_FLOAT, 0, positions);
    glEdgeFlagPointer(0, flags);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_EDGE_FLAG_ARRAY);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    EXPECT_EQ(drawn(PrimitiveClass::lines), 2u);
    glDisableClientState(GL_EDGE_FLAG_ARRAY);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    EXPECT_EQ(drawn(PrimitiveClass::lines), 8u) << "The current edge flag is as it was before the array.";
}

TEST_F(Raster, PointModeDrawsEachCornerOnce)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    square();
    EXPECT_EQ(drawn(PrimitiveClass::points), 4u);
}

TEST_F(Raster, EachFaceHasItsMode)
{
    glPolygonMode(GL_FRONT, GL_POINT);
    square();
    EXPECT_EQ(drawn(PrimitiveClass::points), 4u);
    glFrontFace(GL_CW);
    square();
    EXPECT_EQ(drawn(PrimitiveClass::points), 4u) << "Now it is a back face, and filled.";
    EXPECT_EQ(drawn(PrimitiveClass::triangles), 6u);
}

TEST_F(Raster, CulledFacesHaveNoEdges)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    square();
    EXPECT_EQ(drawn(PrimitiveClass::lines), 0u);
    glCullFace(GL_BACK);
    square();
    EXPECT_EQ(drawn(PrimitiveClass::lines), 8u);
    EXPECT_FALSE(backend->draws().back().pipeline.cull_face) << "Lines have no face that ES may cull.";
}

TEST_F(Raster, AUserPlaneCutsAPolygonAndShowsTheCutAsAnEdge)
{
    plane(GL_CLIP_PLANE0, 1, 0, 0, 0);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glBegin(GL_TRIANGLES);
    glVertex2f(-0.5f, 0);
    glVertex2f(0.5f, 0);
    glVertex2f(0.5f, 0.5f);
    glEnd();
    EXPECT_EQ(drawn(PrimitiveClass::lines), 8u);
    for (const Corner& corner : corners()) {
        EXPECT_GE(corner.position.x, 0);
    }
}

TEST_F(Raster, TheViewVolumeCutsAPolygonWithoutAnEdge)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glBegin(GL_TRIANGLES);
    glVertex2f(0, 0);
    glVertex2f(2, 0);
    glVertex2f(0, 0.5f);
    glEnd();
    EXPECT_EQ(drawn(PrimitiveClass::lines), 6u);
}

TEST_F(Raster, LightIsThatOfTheVerticesBeforeTheyAreCut)
{
    glColor3f(0, 0, 0);
    plane(GL_CLIP_PLANE3, 1, 0, 0, 0);
    glBegin(GL_LINES);
    glVertex2f(-0.5f, 0);
    glColor3f(1, 0, 0);
    glVertex2f(0.5f, 0);
    glEnd();
    const std::vector<Corner> all = corners();
    ASSERT_EQ(all.size(), 2u);
    EXPECT_FLOAT_EQ(all[0].position.x, 0);
    EXPECT_FLOAT_EQ(all[0].color.r, 0.5f);
}

TEST_F(Raster, PointsBeyondAUserPlaneAreDropped)
{
    plane(GL_CLIP_PLANE5, 0, 1, 0, -0.25);
    glBegin(GL_POINTS);
    glVertex2f(0, 0.2f);
    glVertex2f(0, 0.3f);
    glEnd();
    EXPECT_EQ(drawn(PrimitiveClass::points), 1u);
}

TEST_F(Raster, AStippleCutsALineAndGoesOnAlongAStrip)
{
    glViewport(0, 0, 64, 64);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(1, 0x00ff);
    glBegin(GL_LINE_STRIP);
    glVertex2f(-1, 0.5f / 32);
    glVertex2f(-1 + 12.0f / 32, 0.5f / 32);
    glVertex2f(-1 + 24.0f / 32, 0.5f / 32);
    glEnd();
    // On: pixels 0 to 7 of the first line; the second goes on with pixel 12, and 16 to 23 are on again.
    EXPECT_EQ(drawn(PrimitiveClass::triangles), 12u);
    const float first_x = corners().front().position.x;
    EXPECT_NEAR(first_x, -32.0f / (32 + 256), 1e-5f) << "In a viewport grown by 256 pixels.";
}

TEST_F(Raster, SeparateLinesBeginTheStippleAnew)
{
    glViewport(0, 0, 64, 64);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(1, 0x0001);
    for (const GLenum mode : {GL_LINES, GL_LINE_STRIP}) {
        const std::uint32_t before = drawn(PrimitiveClass::triangles);
        glBegin(mode);
        for (int i = 0; i < 4; ++i) {
            glVertex2f(-1 + 8.0f / 32 * static_cast<float>(i), 0.5f / 32);
        }
        glEnd();
        EXPECT_EQ(drawn(PrimitiveClass::triangles) - before, 12u)
            << (mode == GL_LINES ? "of 2 lines" : "of 3 lines");
    }
}

TEST_F(Raster, AStippleOfAllOnesLeavesLinesToTheGpu)
{
    glEnable(GL_LINE_STIPPLE);
    glBegin(GL_LINES);
    glVertex2f(-1, 0);
    glVertex2f(1, 0);
    glEnd();
    EXPECT_EQ(drawn(PrimitiveClass::lines), 2u);
}

TEST_F(Raster, LinesThatLeaveTheViewAreCutWhereEsDoesNotCutThem)
{
    const auto lines = [&](float x) {
        glBegin(GL_LINES);
        glVertex2f(0, 0.5f);
        glVertex2f(x, 0.5f);
        glEnd();
    };
    const auto greatest_x = [&] {
        float x = 0;
        for (const Corner& corner : corners()) {
            x = std::max(x, corner.position.x);
        }
        return x;
    };
    lines(3);
    EXPECT_EQ(greatest_x(), 3) << "ES cuts it.";
    backend->records.clear();
    backend->lines_are_clipped = false;
    lines(0.75f);
    EXPECT_EQ(greatest_x(), 0.75f);
    lines(3);
    EXPECT_EQ(greatest_x(), 1);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    lines(1e5f);
    glEndList();
    glCallList(list);
    EXPECT_EQ(greatest_x(), 1);
    EXPECT_EQ(drawn(PrimitiveClass::lines), 6u);
}

TEST_F(Raster, ThinLinesWithinASmallViewportStayWithTheGpu)
{
    glViewport(8, 8, 16, 16);
    glBegin(GL_LINES);
    glVertex2f(-1, -0.5f); // From side to side, and none along a side.
    glVertex2f(1, 0.5f);
    glVertex2f(0.25f, -1);
    glVertex2f(0.25f, 1);
    glEnd();
    context->flush_vertices();
    EXPECT_EQ(backend->draws().back().pipeline.viewport[2], 16);
}

TEST_F(Raster, LinesReachBeyondAViewportThatIsSmallerThanTheTarget)
{
    glViewport(8, 8, 16, 16);
    glBegin(GL_LINES);
    glVertex2f(-1, -0.5f);
    glVertex2f(-1, 3);
    glEnd();
    context->flush_vertices();
    const BackendRecord draw = backend->draws().back();
    EXPECT_LT(draw.pipeline.viewport[0], 8);
    EXPECT_GT(draw.pipeline.viewport[2], 16);
    const auto y = [&](const Corner& corner) {
        const auto height = static_cast<float>(draw.pipeline.viewport[3]);
        return (corner.position.y / corner.position.w + 1) * height / 2 +
               static_cast<float>(draw.pipeline.viewport[1]);
    };
    EXPECT_FLOAT_EQ(y(corners().front()), 12);
    EXPECT_FLOAT_EQ(y(corners().back()), 24) << "What is cut off is what is outside of the smaller viewport.";
}

TEST_F(Raster, LinesWiderThanEsDrawsBecomeTriangles)
{
    backend->maximum_line_width = 1;
    glLineWidth(1.4f);
    glBegin(GL_LINES);
    glVertex2f(-0.5f, 0);
    glVertex2f(0.5f, 0);
    glEnd();
    EXPECT_EQ(drawn(PrimitiveClass::lines), 2u) << "1.4 pixels are rounded to one.";
    glLineWidth(4);
    glBegin(GL_LINES);
    glVertex2f(-0.5f, 0);
    glVertex2f(0.5f, 0);
    glEnd();
    EXPECT_EQ(drawn(PrimitiveClass::triangles), 6u);
}

TEST_F(Raster, TheFirstVertexCanProvoke)
{
    glShadeModel(GL_FLAT);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) {
        glColor3f(static_cast<float>(i) * 0.5f, 0, 0);
        glVertex2f(static_cast<float>(i) * 0.2f, i == 2 ? 0.5f : 0);
    }
    glEnd();
    for (const Corner& corner : corners()) {
        EXPECT_EQ(corner.color.r, 0);
    }
    EXPECT_EQ(drawn(PrimitiveClass::triangles), 3u);
}

TEST_F(Raster, AMaterialHoldsFromItsVertexOn)
{
    const GLfloat black[4] = {0, 0, 0, 1}, red[4] = {1, 0, 0, 1};
    glEnable(GL_LIGHTING);
    glMaterialfv(GL_FRONT, GL_EMISSION, black);
    glMaterialfv(GL_FRONT, GL_AMBIENT, black);
    glBegin(GL_TRIANGLES);
    glVertex2f(0, 0);
    glMaterialfv(GL_FRONT, GL_EMISSION, red);
    glVertex2f(0.5f, 0);
    glVertex2f(0, 0.5f);
    glEnd();
    const std::vector<Corner> all = corners();
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].color.r, 0);
    EXPECT_EQ(all[1].color.r, 1);
    EXPECT_EQ(all[2].color.r, 1);
    EXPECT_EQ(context->state.lighting.materials[0][legacygl::MaterialProperty::emission].r, 1);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Raster, BadValuesAreErrorsAndChangeNothing)
{
    const GLdouble equation[4] = {1, 2, 3, 4};
    const auto error = [](auto call) {
        call();
        return glGetError();
    };
    EXPECT_EQ(error([] { glPolygonMode(GL_FRONT, GL_SMOOTH); }), static_cast<GLenum>(GL_INVALID_ENUM));
    EXPECT_EQ(error([] { glPolygonMode(GL_LEFT, GL_LINE); }), static_cast<GLenum>(GL_INVALID_ENUM));
    EXPECT_EQ(error([&] { glClipPlane(GL_CLIP_PLANE0 + 6, equation); }),
              static_cast<GLenum>(GL_INVALID_ENUM));
    EXPECT_EQ(error([] { glLogicOp(GL_ADD); }), static_cast<GLenum>(GL_INVALID_ENUM));
    EXPECT_EQ(error([] { glProvokingVertex(GL_QUADS); }), static_cast<GLenum>(GL_INVALID_ENUM));
    EXPECT_EQ(error([] { glPointParameterf(GL_POINT_SIZE_MIN, -1); }), static_cast<GLenum>(GL_INVALID_VALUE));
    EXPECT_EQ(error([] { glPointParameterf(GL_POINT_DISTANCE_ATTENUATION, 1); }),
              static_cast<GLenum>(GL_INVALID_ENUM));
    glBegin(GL_POINTS);
    glPolygonMode(GL_FRONT, GL_LINE);
    glEnd();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    EXPECT_EQ(context->state.raster.polygon_mode[0], static_cast<GLenum>(GL_FILL));
}

// OpenGL 1.5, 3.6.4: bits are skipped within a byte, from its highest one or from its lowest.
TEST(StippleImage, BeginsWithinAByteWhenPixelsAreSkipped)
{
    std::array<std::uint8_t, 32 * 8> bits{};
    bits[0] = 0x07; // pixels 5, 6 and 7 of the first row
    bits[1] = 0x80; // and pixel 8
    legacygl::PixelStore store;
    store.alignment = 1;
    store.row_length = 64;
    store.skip_pixels = 5;
    EXPECT_EQ(legacygl::unpack_stipple(store, bits.data())[0], 0xf0000000u);
    store.lsb_first = true; // pixels 0, 1, 2, and 15
    EXPECT_EQ(legacygl::unpack_stipple(store, bits.data())[0], 1u << (31 - 10));
}

// OpenGL 1.5, 4.3.2: stencil values read as a bitmap give their lowest bits. Mesa refuses it, so no scene can
// tell.
TEST(StencilImage, GivesItsLowestBitsAsABitmap)
{
    const std::array<std::uint8_t, 6> values = {1, 2, 3, 255, 0, 5}; // two rows of three
    legacygl::PixelStore store;
    store.alignment = 2;
    store.row_length = 9;
    store.skip_pixels = 1;
    std::array<std::uint8_t, 4> bits = {0xff, 0xff, 0x00, 0x00};
    legacygl::pack_stencils(store, 3, 2, GL_BITMAP, values, bits.data());
    EXPECT_EQ(bits, (std::array<std::uint8_t, 4>{0xdf, 0xff, 0x50, 0x00}));
    store.lsb_first = true;
    legacygl::pack_stencils(store, 3, 2, GL_BITMAP, values, bits.data());
    EXPECT_EQ(bits, (std::array<std::uint8_t, 4>{0xdb, 0xff, 0x5a, 0x00}));
}

} // namespace
