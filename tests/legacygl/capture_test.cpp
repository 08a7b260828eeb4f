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
        for (const LegacyGLCall& call : calls) {
            out.emplace_back(call.name);
        }
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

TEST_F(Capture, NotesTheArgumentsThatWereGivenAndNoOthers)
{
    const auto calls = captured(
        [](GLuint) {
            glBegin(GL_POINTS);
            glColor3ub(255, 0, 7);
            glTexCoord1f(0.5f);
            glMultiTexCoord2f(GL_TEXTURE1, 3, 4);
            const GLshort place[] = {5, 6, 7};
            glVertex3sv(place);
            glEnd();
        },
        0);
    const auto arguments = [&](std::size_t call) {
        return std::vector<double>(calls[call].arguments, calls[call].arguments + calls[call].argument_count);
    };
    ASSERT_EQ(names(calls), (std::vector<std::string>{"glBegin", "glColor3ub", "glTexCoord1f",
                                                      "glMultiTexCoord2f", "glVertex3sv", "glEnd"}));
    EXPECT_EQ(arguments(1), (std::vector<double>{255, 0, 7}));
    EXPECT_EQ(arguments(2), (std::vector<double>{0.5}));
    EXPECT_EQ(arguments(3), (std::vector<double>{GL_TEXTURE1, 3, 4}));
    EXPECT_EQ(arguments(4), (std::vector<double>{5, 6, 7}));
}

TEST_F(Capture, NotesWhatAListHoldsConstantWithEachOfItsVertices)
{
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) {
        glNormal3f(0, 1, 0);
        glVertex2f(static_cast<float>(i), 0);
    }
    glEnd();
    glColor3f(1, 0, 0);
    glEndList();
    const auto calls = captured([](GLuint l) { glCallList(l); }, list);
    EXPECT_EQ(names(calls),
              (std::vector<std::string>{"glCallList", "glBegin", "glNormal3f", "glVertex4f", "glNormal3f",
                                        "glVertex4f", "glNormal3f", "glVertex4f", "glEnd", "glColor4f"}));
    EXPECT_EQ(calls[6].arguments[1], 1.0);
    EXPECT_EQ(calls.back().arguments[0], 1.0);
}

TEST_F(Capture, NotesAListThatOnlySetsACurrentValue)
{
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glNormal3f(0, 1, 0);
    glEndList();
    const auto calls = captured([](GLuint l) { glCallList(l); }, list);
    EXPECT_EQ(names(calls), (std::vector<std::string>{"glCallList", "glNormal3f"}));
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
