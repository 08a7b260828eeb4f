#include "recorded_gl.h"

#include <legacygl/legacygl.h>

#include <algorithm>
#include <cstring>

namespace {

class Capture : public RecordedGl
{
protected:
    std::vector<LegacyGLCall> captured(void (*draw)(GLuint list), GLuint list)
    {
        context->capture.begin();
        draw(list);
        const auto calls = context->capture.end();
        return {calls.begin(), calls.end()};
    }
    static std::vector<std::string> names(const std::vector<LegacyGLCall>& calls)
    {
        std::vector<std::string> out;
        for (const LegacyGLCall& call : calls)
            out.emplace_back(call.name);
        return out;
    }
};

TEST_F(Capture, NotesNamesArgumentsAndTheModelview)
{
    const auto calls = captured(
        [](GLuint) {
            glTranslatef(1, 2, 3);
            glPushMatrix();
        },
        0);
    ASSERT_EQ(names(calls), (std::vector<std::string>{"glTranslatef", "glPushMatrix"}));
    EXPECT_EQ(calls[0].argument_count, 3);
    EXPECT_EQ(calls[0].arguments[1], 2.0);
    EXPECT_EQ(calls[0].modelview[13], 0.0f) << "before the call";
    EXPECT_EQ(calls[1].modelview[13], 2.0f) << "after it";
}

TEST_F(Capture, NotesWhatListsDoWithTheirNesting)
{
    const GLuint list = glGenLists(2);
    glNewList(list, GL_COMPILE);
    triangle();
    glScalef(2, 2, 2);
    glEndList();
    glNewList(list + 1, GL_COMPILE);
    glCallList(list);
    glEndList();
    const auto calls = captured([](GLuint l) { glCallList(l + 1); }, list);
    EXPECT_EQ(names(calls), (std::vector<std::string>{"glCallList", "glCallList", "glBegin", "glVertex4f",
                                                      "glVertex4f", "glVertex4f", "glEnd", "glScalef"}));
    EXPECT_EQ(calls[0].list_depth, 0);
    EXPECT_EQ(calls[1].list_depth, 1);
    EXPECT_EQ(calls[2].list_depth, 2);
    EXPECT_EQ(calls[4].arguments[0], 1.0);
    EXPECT_EQ(calls.back().list_depth, 2);
}

TEST_F(Capture, NotesNothingWhenItIsOff)
{
    triangle();
    context->capture.begin();
    EXPECT_TRUE(context->capture.end().empty());
    triangle();
    EXPECT_TRUE(context->capture.end().empty());
}

} // namespace
