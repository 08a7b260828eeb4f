// Front and back on a real OpenGL ES 3: what is drawn where, what present and resize do with it.

#include "platform/offscreen/egl_context.h"

#include <legacygl/legacygl.h>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include <array>

namespace {

using Color = std::array<int, 3>;
constexpr Color RED{255, 0, 0}, GREEN{0, 255, 0}, BLUE{0, 0, 255}, BLACK{0, 0, 0};

class DrawBuffers : public testing::Test
{
protected:
    ~DrawBuffers() override { legacygl_destroy(gl_); }

    void open(LegacyGLTarget target)
    {
        ASSERT_EQ(egl_.open(platform::GlApi::es_3), "");
        gl_ = legacygl_create(platform::find_egl_function, 8, 8, target);
        ASSERT_NE(gl_, nullptr) << legacygl_last_message();
        glViewport(0, 0, 8, 8);
    }
    static void clear(GLenum buffer, const Color& c)
    {
        glDrawBuffer(buffer);
        glClearColor(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]), 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    static void draw(GLenum buffer, const Color& c)
    {
        glDrawBuffer(buffer);
        glColor3ub(static_cast<GLubyte>(c[0]), static_cast<GLubyte>(c[1]), static_cast<GLubyte>(c[2]));
        glRectf(-1, -1, 1, 1);
    }
    static Color read(GLenum buffer, int x = 3, int y = 3)
    {
        std::array<GLubyte, 4> rgba{};
        glReadBuffer(buffer);
        glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return {rgba[0], rgba[1], rgba[2]};
    }
    static GLint get(GLenum name)
    {
        GLint value = -1;
        glGetIntegerv(name, &value);
        return value;
    }

    platform::EglContext egl_;
    LegacyGLContext* gl_ = nullptr;
};

TEST_F(DrawBuffers, FrontAndBackAreTwoPictures)
{
    open(LEGACYGL_TARGET_OWN);
    EXPECT_EQ(get(GL_DOUBLEBUFFER), GL_TRUE);
    EXPECT_EQ(get(GL_DRAW_BUFFER), GL_BACK);
    clear(GL_BACK, RED);
    clear(GL_FRONT, GREEN);
    EXPECT_EQ(read(GL_BACK), RED);
    EXPECT_EQ(read(GL_FRONT), GREEN);
    draw(GL_FRONT, BLUE);
    EXPECT_EQ(read(GL_BACK), RED);
    EXPECT_EQ(read(GL_FRONT), BLUE);
    draw(GL_FRONT_AND_BACK, GREEN);
    EXPECT_EQ(read(GL_BACK), GREEN);
    EXPECT_EQ(read(GL_FRONT), GREEN);
    clear(GL_FRONT_AND_BACK, RED);
    draw(GL_NONE, BLUE);
    clear(GL_NONE, BLUE);
    EXPECT_EQ(read(GL_BACK), RED);
    EXPECT_EQ(read(GL_FRONT), RED);
}

TEST_F(DrawBuffers, BothAreTestedAgainstOneDepth)
{
    open(LEGACYGL_TARGET_OWN);
    glEnable(GL_DEPTH_TEST);
    draw(GL_FRONT_AND_BACK, RED);
    draw(GL_FRONT_AND_BACK, BLUE); // As near as the red: GL_LESS refuses it in both.
    EXPECT_EQ(read(GL_BACK), RED);
    EXPECT_EQ(read(GL_FRONT), RED);
}

TEST_F(DrawBuffers, PresentMakesTheBackTheFrontAndKeepsIt)
{
    open(LEGACYGL_TARGET_OWN);
    clear(GL_FRONT, BLACK);
    clear(GL_BACK, RED);
    glEnable(GL_SCISSOR_TEST); // Of drawing, not of presenting.
    glScissor(0, 0, 1, 1);
    legacygl_present(gl_);
    EXPECT_EQ(read(GL_FRONT), RED);
    EXPECT_EQ(read(GL_BACK), RED);
    glDisable(GL_SCISSOR_TEST);
    clear(GL_FRONT, GREEN);
    legacygl_show_front(gl_);
    EXPECT_EQ(read(GL_FRONT), GREEN);
    EXPECT_EQ(read(GL_BACK), RED);
}

TEST_F(DrawBuffers, ResizingKeepsWhatFitsOfBoth)
{
    open(LEGACYGL_TARGET_OWN);
    clear(GL_BACK, RED);
    clear(GL_FRONT, GREEN);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // Of drawing, not of resizing.
    legacygl_resize(gl_, 12, 6);
    EXPECT_EQ(read(GL_BACK), RED);
    EXPECT_EQ(read(GL_FRONT), GREEN);
    EXPECT_EQ(read(GL_BACK, 10), BLACK);
}

TEST_F(DrawBuffers, ASingleBufferIsTheFront)
{
    open(LEGACYGL_TARGET_OWN_SINGLE);
    EXPECT_EQ(get(GL_DOUBLEBUFFER), GL_FALSE);
    EXPECT_EQ(get(GL_DRAW_BUFFER), GL_FRONT);
    EXPECT_EQ(get(GL_READ_BUFFER), GL_FRONT);
    clear(GL_FRONT, RED);
    glFlush();
    legacygl_present(gl_);
    EXPECT_EQ(read(GL_FRONT), RED) << "What was drawn stays.";
    draw(GL_FRONT_AND_BACK, GREEN);
    EXPECT_EQ(read(GL_FRONT), GREEN);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    glDrawBuffer(GL_BACK);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    glReadBuffer(GL_BACK);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
}

TEST_F(DrawBuffers, BuffersThatAreNotThereAreErrors)
{
    open(LEGACYGL_TARGET_OWN);
    for (GLenum name : {GL_RIGHT, GL_FRONT_RIGHT, GL_BACK_RIGHT, GL_AUX0}) {
        glDrawBuffer(name);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
        glReadBuffer(name);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    }
    glDrawBuffer(GL_LINES);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
    glReadBuffer(GL_FRONT_AND_BACK);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
    EXPECT_EQ(get(GL_DRAW_BUFFER), GL_BACK);
}

TEST_F(DrawBuffers, TheBufferBelongsToTheAttributes)
{
    open(LEGACYGL_TARGET_OWN);
    glPushAttrib(GL_COLOR_BUFFER_BIT | GL_PIXEL_MODE_BIT);
    clear(GL_FRONT, GREEN);
    glPopAttrib();
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(read(GL_FRONT), GREEN);
    EXPECT_EQ(read(GL_BACK), RED);
}

TEST_F(DrawBuffers, ANewContextBeginsClearedWhateverTheLastOneLeft)
{
    open(LEGACYGL_TARGET_OWN);
    clear(GL_BACK, RED);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 2, 2);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilMask(0);
    draw(GL_BACK, GREEN);
    glFinish();
    legacygl_destroy(gl_);
    gl_ = legacygl_create(platform::find_egl_function, 8, 8, LEGACYGL_TARGET_OWN);
    ASSERT_NE(gl_, nullptr);
    EXPECT_EQ(read(GL_BACK), BLACK);
    EXPECT_EQ(read(GL_FRONT), BLACK);
    glEnable(GL_DEPTH_TEST);
    draw(GL_BACK, BLUE);
    EXPECT_EQ(read(GL_BACK), BLUE) << "the depth buffer is clear, too";
}

} // namespace
