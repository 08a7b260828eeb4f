// Random streams of commands on a real OpenGL ES 3: no ES error ever, lists replay what is drawn at once, and
// glPopAttrib puts back what glPushAttrib saw. LEGACYGL_STREAMS sets how many streams a test makes.

#define GL_GLEXT_PROTOTYPES
#include "random_gl/random_stream.h"

#include "platform/offscreen/egl_context.h"

#include <legacygl/legacygl.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace {

using random_gl::Feature;

constexpr int WIDTH = 64, HEIGHT = 48, LENGTH = 60;

unsigned stream_count()
{
    const char* count = std::getenv("LEGACYGL_STREAMS");
    return count ? static_cast<unsigned>(std::atoi(count)) : 250;
}

/// What a program can see of the state that streams change.
std::vector<double> visible_state()
{
    constexpr GLenum NAMES[] = {GL_CURRENT_COLOR,
                                GL_CURRENT_NORMAL,
                                GL_CURRENT_TEXTURE_COORDS,
                                GL_CURRENT_SECONDARY_COLOR,
                                GL_CURRENT_FOG_COORDINATE,
                                GL_EDGE_FLAG,
                                GL_MODELVIEW_MATRIX,
                                GL_VIEWPORT,
                                GL_DEPTH_RANGE,
                                GL_LIGHTING,
                                GL_LIGHT0,
                                GL_LIGHT1,
                                GL_COLOR_MATERIAL,
                                GL_NORMALIZE,
                                GL_LIGHT_MODEL_TWO_SIDE,
                                GL_LIGHT_MODEL_LOCAL_VIEWER,
                                GL_SHADE_MODEL,
                                GL_POLYGON_MODE,
                                GL_CULL_FACE,
                                GL_POLYGON_OFFSET_FILL,
                                GL_POLYGON_OFFSET_LINE,
                                GL_LINE_WIDTH,
                                GL_POINT_SIZE,
                                GL_LINE_STIPPLE,
                                GL_LINE_STIPPLE_PATTERN,
                                GL_LINE_STIPPLE_REPEAT,
                                GL_CLIP_PLANE0,
                                GL_CLIP_PLANE1,
                                GL_CLIP_PLANE2,
                                GL_LINE_SMOOTH,
                                GL_POINT_SMOOTH,
                                GL_DEPTH_TEST,
                                GL_STENCIL_TEST,
                                GL_BLEND,
                                GL_ALPHA_TEST,
                                GL_FOG,
                                GL_DEPTH_FUNC,
                                GL_STENCIL_FUNC,
                                GL_STENCIL_REF,
                                GL_STENCIL_FAIL,
                                GL_BLEND_SRC,
                                GL_BLEND_DST,
                                GL_BLEND_EQUATION,
                                GL_BLEND_EQUATION_ALPHA_EXT,
                                GL_ALPHA_TEST_FUNC,
                                GL_ALPHA_TEST_REF,
                                GL_FOG_MODE,
                                GL_FOG_COLOR,
                                GL_SCISSOR_TEST,
                                GL_SCISSOR_BOX,
                                GL_TEXTURE_2D,
                                GL_TEXTURE_BINDING_2D,
                                GL_COLOR_LOGIC_OP,
                                GL_LOGIC_OP_MODE,
                                GL_COLOR_WRITEMASK,
                                GL_COLOR_CLEAR_VALUE};
    std::vector<double> out;
    for (const GLenum name : NAMES) {
        GLdouble values[16] = {};
        glGetDoublev(name, values);
        out.insert(out.end(), values, values + 16);
    }
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        for (const GLenum name : {GL_DIFFUSE, GL_EMISSION, GL_AMBIENT, GL_SPECULAR, GL_SHININESS}) {
            GLfloat values[4] = {};
            glGetMaterialfv(face, name, values);
            out.insert(out.end(), values, values + 4);
        }
    }
    return out;
}

class RandomStreams : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(egl_.open(platform::GlApi::es_3), "");
        es_error_ = reinterpret_cast<GLenum (*)()>(platform::find_egl_function("glGetError"));
    }
    ~RandomStreams() override { legacygl_destroy(gl_); }

    /// What streams have that is made of quads. A list draws them otherwise, as Mesa's does: separate ones it
    /// cuts along another diagonal where the last vertex provokes, and it cannot know which triangle of a
    /// strip's quad comes first, which depends on what the view cuts off.
    enum class Quads
    {
        none,
        first_provokes, ///< Separate quads, rectangles, meshes and quadrics; the first vertex provokes.
        all
    };
    void renew(Quads quads)
    {
        legacygl_destroy(gl_);
        gl_ = legacygl_create(platform::find_egl_function, WIDTH, HEIGHT, LEGACYGL_TARGET_OWN);
        ASSERT_NE(gl_, nullptr) << legacygl_last_message();
        random_gl::RandomStream::make_textures();
        if (quads == Quads::first_provokes) {
            glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
        }
    }
    /// A stream without what may not stand in a list, or leaves undefined what is current.
    static random_gl::RandomStream stream(unsigned seed, Quads quads)
    {
        if (quads == Quads::all) {
            return random_gl::RandomStream(
                seed, {Feature::display_lists, Feature::copied_textures, Feature::arrays});
        }
        if (quads == Quads::first_provokes) {
            return random_gl::RandomStream(seed, {Feature::display_lists, Feature::quad_strips,
                                                  Feature::provoking_vertex, Feature::arrays,
                                                  Feature::copied_textures, Feature::texture_parameters,
                                                  Feature::texture_combiners, Feature::second_texture_unit});
        }
        return random_gl::RandomStream(
            seed, {Feature::display_lists, Feature::quads, Feature::quad_strips, Feature::rectangles,
                   Feature::meshes, Feature::quadrics, Feature::arrays, Feature::copied_textures,
                   Feature::texture_parameters, Feature::texture_combiners, Feature::second_texture_unit});
    }
    static void run(unsigned seed, Quads quads)
    {
        random_gl::RandomStream made = stream(seed, quads);
        made.make(LENGTH);
        made.program().run();
    }
    static void compile_and_call(unsigned seed, Quads quads)
    {
        glNewList(1, GL_COMPILE);
        run(seed, quads);
        glEndList();
        glCallList(1);
    }
    static std::vector<GLubyte> pixels()
    {
        std::vector<GLubyte> rgba(std::size_t{WIDTH} * HEIGHT * 4);
        glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return rgba;
    }

    platform::EglContext egl_;
    GLenum (*es_error_)() = nullptr;
    LegacyGLContext* gl_ = nullptr;
};

TEST_F(RandomStreams, ReplayedFromListsLeaveTheSameState)
{
    for (unsigned seed = 0; seed < stream_count(); ++seed) {
        // Few have all: each makes shaders of its own.
        const Quads quads = seed % 8 == 0 ? Quads::all : Quads::none;
        renew(quads);
        run(seed, quads);
        const std::vector<double> direct = visible_state();
        glFinish();
        ASSERT_EQ(es_error_(), GLenum{GL_NO_ERROR}) << "seed " << seed;
        renew(quads);
        compile_and_call(seed, quads);
        ASSERT_EQ(direct, visible_state()) << "seed " << seed;
        glFinish();
        ASSERT_EQ(es_error_(), GLenum{GL_NO_ERROR}) << "seed " << seed;
    }
}

TEST_F(RandomStreams, ReplayedFromListsLeaveTheSamePicture)
{
    for (unsigned seed = 0; seed < stream_count(); ++seed) {
        const Quads quads = seed % 4 == 0 ? Quads::first_provokes : Quads::none;
        renew(quads);
        run(seed, quads);
        const std::vector<GLubyte> direct = pixels();
        renew(quads);
        compile_and_call(seed, quads);
        const std::vector<GLubyte> replayed = pixels();
        int differing = 0, greatest = 0;
        for (std::size_t i = 0; i < direct.size(); ++i) {
            differing += direct[i] != replayed[i];
            greatest = std::max(greatest, std::abs(direct[i] - replayed[i]));
        }
        EXPECT_EQ(differing, 0) << "seed " << seed << ", by " << greatest << " at most";
    }
}

TEST_F(RandomStreams, PoppedAttributesAreThosePushed)
{
    renew(Quads::all);
    for (unsigned seed = 0; seed < 20 * stream_count(); ++seed) {
        random_gl::RandomStream changes = stream(100000 + seed, Quads::all);
        for (int i = 0; i < 10; ++i) {
            changes.state();
        }
        changes.program().run();
        const std::size_t pushed_at = changes.program().size();
        const std::vector<double> before = visible_state();
        glPushMatrix(); // Matrices are no attributes.
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        for (int i = 0; i < 20; ++i) {
            changes.state();
        }
        changes.program().run(pushed_at);
        glPopAttrib();
        glPopMatrix();
        ASSERT_EQ(before, visible_state()) << "seed " << seed;
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << "seed " << seed;
    }
    ASSERT_EQ(es_error_(), GLenum{GL_NO_ERROR});
}

} // namespace
