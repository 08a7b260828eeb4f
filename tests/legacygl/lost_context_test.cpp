#include "recorded_gl.h"

#include <algorithm>

namespace {

class LostContext : public RecordedGl
{
protected:
    void lose_and_restore()
    {
        backend->context_lost();
        context->renderer.forget_objects();
        backend->records.clear();
        backend->context_restored();
        context->renderer.forget_objects();
    }
    long count(legacygl::BackendRecord::Kind kind) const
    {
        return std::count_if(backend->records.begin(), backend->records.end(),
                             [kind](const legacygl::BackendRecord& r) { return r.kind == kind; });
    }
};

TEST_F(LostContext, ListsAndTexturesAreBuiltAgain)
{
    using Kind = legacygl::BackendRecord::Kind;
    const GLubyte pixels[16] = {1, 2, 3, 4};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    glEnable(GL_TEXTURE_2D);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    triangle();
    glEndList();
    glCallList(list);
    const auto before = corners();
    lose_and_restore();
    glCallList(list);
    EXPECT_EQ(corners(), before);
    EXPECT_EQ(count(Kind::geometry), 1);
    EXPECT_EQ(count(Kind::texture_image), 1);
    EXPECT_EQ(count(Kind::program), 1);
}

TEST_F(LostContext, InTheMiddleOfCompilingAListLosesNothing)
{
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    glVertex2f(0, 0);
    lose_and_restore();
    glVertex2f(1, 0);
    glVertex2f(0, 1);
    glEnd();
    glEndList();
    glCallList(list);
    EXPECT_EQ(corners().size(), 3u);
}

TEST_F(LostContext, ObjectsOfTheLostContextAreNotFreedInTheNewOne)
{
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    triangle();
    glEndList();
    glCallList(list);
    lose_and_restore();
    glDeleteLists(list, 1);
    EXPECT_EQ(backend->live_geometries, 0) << "-1 would be a double free";
}

} // namespace
