#include "recorded_gl.h"

namespace {

class DisplayList : public RecordedGl
{
protected:
    /// Compiles what the function calls and returns the list.
    template <class Draw> GLuint compiled(Draw draw, GLenum mode = GL_COMPILE)
    {
        const GLuint list = glGenLists(1);
        glNewList(list, mode);
        draw();
        glEndList();
        return list;
    }
};

TEST_F(DisplayList, CompilingDrawsNothing)
{
    compiled([] { triangle(); });
    EXPECT_TRUE(corners().empty());
}

TEST_F(DisplayList, CompileAndExecuteDrawsAtOnceAndAgainWhenCalled)
{
    const GLuint list = compiled([] { triangle(); }, GL_COMPILE_AND_EXECUTE);
    EXPECT_EQ(corners().size(), 3u);
    glCallList(list);
    EXPECT_EQ(corners().size(), 6u);
}

TEST_F(DisplayList, AnAttributeTheListDoesNotSetIsTheCallers)
{
    glColor3f(1, 0, 0);
    const GLuint list = compiled([] { triangle(); });
    glColor3f(0, 1, 0);
    glCallList(list);
    EXPECT_EQ(corners().at(0).color, glm::vec4(0, 1, 0, 1));
}

TEST_F(DisplayList, AnAttributeSetInTheMiddleLeavesEarlierVerticesToTheCaller)
{
    const GLuint list = compiled([] {
        glBegin(GL_TRIANGLES);
        glVertex2f(0, 0);
        glColor3f(0, 0, 1);
        glVertex2f(1, 0);
        glVertex2f(0, 1);
        glEnd();
    });
    glColor3f(0, 1, 0);
    glCallList(list);
    const auto drawn = corners();
    ASSERT_EQ(drawn.size(), 3u);
    EXPECT_EQ(drawn[0].color, glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(drawn[1].color, glm::vec4(0, 0, 1, 1));
}

TEST_F(DisplayList, LeavesItsLastAttributesCurrent)
{
    const GLuint list = compiled([] {
        triangle();
        glColor4f(0.25f, 0.5f, 0.75f, 1);
        glNormal3f(1, 0, 0);
    });
    glCallList(list);
    GLfloat color[4], normal[3];
    glGetFloatv(GL_CURRENT_COLOR, color);
    glGetFloatv(GL_CURRENT_NORMAL, normal);
    EXPECT_EQ(color[1], 0.5f);
    EXPECT_EQ(normal[0], 1.0f);
    triangle();
    EXPECT_EQ(corners().back().color, glm::vec4(0.25f, 0.5f, 0.75f, 1));
}

TEST_F(DisplayList, CompilingDoesNotChangeTheCurrentAttributes)
{
    compiled([] { glColor3f(0, 0, 1); });
    GLfloat color[4];
    glGetFloatv(GL_CURRENT_COLOR, color);
    EXPECT_EQ(color[0], 1.0f);
}

TEST_F(DisplayList, AConstantColourAfterItsVerticesDoesNotReachBack)
{
    const GLuint list = compiled([] {
        glColor3f(1, 0, 0);
        triangle();
        glColor3f(0, 0, 1);
        triangle(5);
        glColor3f(0, 1, 0);
    });
    glCallList(list);
    const auto drawn = corners();
    ASSERT_EQ(drawn.size(), 6u);
    EXPECT_EQ(drawn[2].color, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(drawn[3].color, glm::vec4(0, 0, 1, 1));
}

TEST_F(DisplayList, CallsItselfOnlyToTheNestingLimit)
{
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    triangle();
    glCallList(list);
    glEndList();
    glCallList(list);
    EXPECT_EQ(corners().size(), 3u * 64);
}

TEST_F(DisplayList, MayReplaceAChildWhileItRuns)
{
    const GLuint child = compiled([] { triangle(); });
    const GLuint parent = compiled([=] {
        glCallList(child);
        glTranslatef(1, 0, 0);
        glCallList(child);
    });
    glNewList(child, GL_COMPILE);
    triangle();
    triangle();
    glEndList();
    glCallList(parent);
    EXPECT_EQ(corners().size(), 12u);
}

TEST_F(DisplayList, FreesItsGeometryWhenItGoes)
{
    const GLuint list = compiled([] { triangle(); });
    glCallList(list);
    EXPECT_EQ(backend->live_geometries, 1);
    glDeleteLists(list, 1);
    EXPECT_EQ(backend->live_geometries, 0);
}

TEST_F(DisplayList, IsOnlyReplacedAtEndList)
{
    const GLuint list = compiled([] { triangle(); });
    glNewList(list, GL_COMPILE_AND_EXECUTE);
    glCallList(list); // Still the old one.
    glEndList();
    EXPECT_EQ(corners().size(), 3u);
}

TEST_F(DisplayList, InsideBeginAndEndGivesVerticesToThePrimitive)
{
    const GLuint list = compiled([] {
        glColor3f(0, 0, 1);
        glVertex2f(1, 0);
        glVertex2f(0, 1);
    });
    glBegin(GL_TRIANGLES);
    glVertex2f(0, 0);
    glCallList(list);
    glEnd();
    const auto drawn = corners();
    ASSERT_EQ(drawn.size(), 3u);
    EXPECT_EQ(drawn[0].color, glm::vec4(1));
    EXPECT_EQ(drawn[2].color, glm::vec4(0, 0, 1, 1));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(DisplayList, GenListsFindsARowBetweenOthers)
{
    EXPECT_EQ(glGenLists(3), 1u);
    glNewList(5, GL_COMPILE);
    glEndList();
    EXPECT_EQ(glGenLists(1), 4u);
    EXPECT_EQ(glGenLists(2), 6u);
    glDeleteLists(2, 1);
    EXPECT_EQ(glGenLists(2), 8u);
    EXPECT_EQ(glGenLists(1), 2u);
}

} // namespace
