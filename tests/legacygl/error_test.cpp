#include "recorded_gl.h"

namespace {

using Errors = RecordedGl;

void expect_error(GLenum code)
{
    EXPECT_EQ(glGetError(), code);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Errors, TheFirstOneStays)
{
    glMatrixMode(1);
    glPopMatrix();
    expect_error(GL_INVALID_ENUM);
}

TEST_F(Errors, CallsThatMayNotStandInsideBeginAndEndChangeNothing)
{
    glBegin(GL_TRIANGLES);
    glTranslatef(1, 2, 3);
    glEnable(GL_LIGHTING);
    glEnd();
    expect_error(GL_INVALID_OPERATION);
    EXPECT_FALSE(glIsEnabled(GL_LIGHTING));
    GLfloat matrix[16];
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
    EXPECT_EQ(matrix[12], 0.0f);
}

TEST_F(Errors, ABadMatrixStackKeepsItsTop)
{
    glTranslatef(1, 0, 0);
    glPopMatrix();
    expect_error(GL_STACK_UNDERFLOW);
    for (int i = 0; i < 40; ++i) {
        glPushMatrix();
    }
    expect_error(GL_STACK_OVERFLOW);
    GLint depth = 0;
    glGetIntegerv(GL_MODELVIEW_STACK_DEPTH, &depth);
    EXPECT_EQ(depth, 32);
}

TEST_F(Errors, ValuesOutOfRangeAreRefused)
{
    glMaterialf(GL_FRONT, GL_SHININESS, 129);
    expect_error(GL_INVALID_VALUE);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 91);
    expect_error(GL_INVALID_VALUE);
    glLightf(GL_LIGHT0, GL_POSITION, 1);
    expect_error(GL_INVALID_ENUM);
    glLineWidth(0);
    expect_error(GL_INVALID_VALUE);
    glTexImage2D(GL_TEXTURE_2D, -1, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    expect_error(GL_INVALID_VALUE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_LINES, GL_UNSIGNED_BYTE, nullptr);
    expect_error(GL_INVALID_ENUM);
    glClear(1);
    expect_error(GL_INVALID_VALUE);
}

TEST(WithoutAContext, CallsDoNothing)
{
    legacygl::current_context = nullptr;
    glBegin(GL_TRIANGLES);
    glVertex2f(0, 0);
    glEnd();
    glEnable(GL_LIGHTING);
    GLint value = 42;
    glGetIntegerv(GL_MATRIX_MODE, &value);
    EXPECT_EQ(value, 42);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(glGetString(GL_VENDOR), nullptr);
}

TEST(Creating, SaysWhyItFails)
{
    EXPECT_EQ(legacygl_create(nullptr, 0, 5, LEGACYGL_TARGET_OWN), nullptr);
    EXPECT_NE(std::string(legacygl_last_message()), "");
#ifndef __EMSCRIPTEN__ // WebGL is linked there and not loaded
    const LegacyGLLoader finds_nothing = [](const char*) -> void* { return nullptr; };
    EXPECT_EQ(legacygl_create(finds_nothing, 4, 4, LEGACYGL_TARGET_OWN), nullptr);
    EXPECT_NE(std::string(legacygl_last_message()).find("glActiveTexture"), std::string::npos);
#endif
}

} // namespace
