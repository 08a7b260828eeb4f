// What is not implemented yet links, refuses and changes nothing; what needs no more than state works.

#include "recorded_gl.h"

#include <string>

namespace {

using Undone = RecordedGl;

TEST_F(Undone, RefusesWithInvalidOperationAndSaysSoOnce)
{
    testing::internal::CaptureStderr();
    glAccum(GL_LOAD, 1);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    glAccum(GL_LOAD, 1);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "legacygl: glAccum is not implemented and sets GL_INVALID_OPERATION\n");
}

TEST_F(Undone, RefusesWhatItLacksOfFunctionsThatAreThere)
{
    testing::internal::CaptureStderr();
    const GLubyte index = 1;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, &index);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    EXPECT_NE(testing::internal::GetCapturedStderr().find("colour indices"), std::string::npos);
}

TEST_F(Undone, RenderingIsTheOneMode)
{
    EXPECT_EQ(glRenderMode(GL_RENDER), 0);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    testing::internal::CaptureStderr();
    glRenderMode(GL_SELECT);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    EXPECT_NE(testing::internal::GetCapturedStderr(), "");
    glRenderMode(GL_LINES);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
    glInitNames();
    glPushName(3);
    glLoadName(4);
    glPopName();
    glPopName();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "Names are ignored outside selection.";
}

} // namespace
