// Random streams of everything that decides how primitives are rasterised: a list replays what is drawn at
// once, and nothing but numbers comes out.

#define GL_GLEXT_PROTOTYPES
#include "recorded_gl.h"

#include <cmath>
#include <random>

namespace {

using legacygl::BackendRecord;

/// Calls GL at random, but the same for the same seed.
class RandomRaster
{
public:
    explicit RandomRaster(unsigned seed) : random_(seed) {}

    void make(int count)
    {
        for (int i = 0; i < count; ++i) {
            one();
        }
        if (inside_) {
            begin_or_end();
        }
    }

private:
    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    float number() { return static_cast<float>(pick(13)) * 0.25f - 1.5f; }
    void enable(GLenum name) { pick(3) ? glEnable(name) : glDisable(name); }

    void one()
    {
        switch (pick(inside_ ? 10 : 26)) {
        case 0:
        case 1:
        case 2:
        case 3:
        case 4: {
            const float x = number(), y = number(), z = number(), w = pick(6) ? 1 : number();
            return glVertex4f(x, y, z, w);
        }
        case 5:
            return glEdgeFlag(pick(2) ? GL_TRUE : GL_FALSE);
        case 6: {
            const float r = number(), g = number();
            return glColor3f(r, g, 0.5f);
        }
        case 7:
            return material();
        case 8: {
            const float x = number(), y = number();
            return glNormal3f(x, y, 1);
        }
        case 9:
        case 10:
        case 11:
        case 12:
        case 13:
        case 14:
            return begin_or_end();
        default:
            return state();
        }
    }

    void state()
    {
        constexpr GLenum MODES[] = {GL_POINT, GL_LINE, GL_FILL},
                         faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
        switch (pick(12)) {
        case 0: {
            const GLenum face = faces[pick(3)], mode = MODES[pick(3)];
            return glPolygonMode(face, mode);
        }
        case 1: {
            const int factor = 1 + pick(20), pattern = pick(65536);
            return glLineStipple(factor, static_cast<GLushort>(pattern));
        }
        case 2:
            return enable(GL_LINE_STIPPLE);
        case 3:
            return enable(GL_CLIP_PLANE0 + static_cast<GLenum>(pick(5)));
        case 4: {
            const GLenum name = GL_CLIP_PLANE0 + static_cast<GLenum>(pick(5));
            GLdouble equation[4];
            for (GLdouble& e : equation) {
                e = static_cast<double>(number());
            }
            return glClipPlane(name, equation);
        }
        case 5:
            return enable(pick(2) ? GL_CULL_FACE : GL_LIGHTING);
        case 6:
            return glFrontFace(pick(2) ? GL_CW : GL_CCW);
        case 7:
            return glShadeModel(pick(2) ? GL_FLAT : GL_SMOOTH);
        case 8:
            return enable(pick(2) ? GL_LINE_SMOOTH : GL_POINT_SMOOTH);
        case 9:
            return glLineWidth(static_cast<float>(1 + pick(9)));
        case 10:
            return glProvokingVertex(pick(2) ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
        default:
            return enable(pick(2) ? GL_POLYGON_OFFSET_LINE : GL_LIGHT0);
        }
    }

    void material()
    {
        const float color[4] = {number(), number(), 0.5f, 1};
        glMaterialfv(pick(2) ? GL_FRONT : GL_BACK, pick(2) ? GL_EMISSION : GL_DIFFUSE, color);
    }

    void begin_or_end()
    {
        if (inside_) {
            glEnd();
        } else {
            glBegin(static_cast<GLenum>(pick(10)));
        }
        inside_ = !inside_;
    }

    std::mt19937 random_;
    bool inside_ = false;
};

class RandomRasters : public RecordedGl
{
protected:
    void renew()
    {
        auto made = std::make_unique<legacygl::RecordingBackend>();
        backend = made.get();
        backend->maximum_line_width = 4;
        context = std::make_unique<legacygl::Context>(std::move(made), 64, 48);
        legacygl::current_context = context.get();
        glEnable(GL_POLYGON_STIPPLE); // Quads are then cut along the same diagonal at once and from a list.
        glEnable(GL_COLOR_MATERIAL);  // Or lighting reads no colour, and a draw need not have the right one.
        // A plane that cuts nothing off: all is then drawn by the CPU, also where the stream asks for
        // nothing.
        const GLdouble everywhere[4] = {0, 0, 0, 1};
        glClipPlane(GL_CLIP_PLANE5, everywhere);
        glEnable(GL_CLIP_PLANE5);
        glPolygonOffset(1, 2);
    }
};

TEST_F(RandomRasters, ReplayedFromListsAreAsDrawnAtOnce)
{
    std::size_t drawn = 0;
    for (unsigned seed = 0; seed < 8000; ++seed) {
        const int length = 10 + static_cast<int>(seed % 90);
        renew();
        RandomRaster(seed).make(length);
        const std::vector<Corner> direct = corners();
        const GLenum error = context->error;
        renew();
        glNewList(1, GL_COMPILE);
        RandomRaster(seed).make(length);
        glEndList();
        glCallList(1);
        const std::vector<Corner> replayed = corners();
        ASSERT_EQ(direct.size(), replayed.size()) << "seed " << seed;
        for (std::size_t i = 0; i < direct.size(); ++i) {
            ASSERT_EQ(direct[i].position, replayed[i].position) << "seed " << seed << " corner " << i;
            ASSERT_EQ(direct[i].color, replayed[i].color) << "seed " << seed << " corner " << i;
        }
        ASSERT_EQ(error, context->error) << "seed " << seed;
        drawn += direct.size();
    }
    EXPECT_GT(drawn, 100000u) << "The streams draw too little to hold anything.";
}

TEST_F(RandomRasters, OnlyNumbersReachTheBackend)
{
    for (unsigned seed = 0; seed < 4000; ++seed) {
        renew();
        RandomRaster(100000 + seed).make(60);
        context->flush_vertices();
        for (const BackendRecord& draw : backend->draws()) {
            for (const float value : draw.vertices) {
                ASSERT_TRUE(std::isfinite(value)) << "seed " << seed;
            }
        }
    }
}

} // namespace
