#include "recorded_gl.h"

namespace {

using Vertices = RecordedGl;

TEST_F(Vertices, UnusedAttributesAreNotSent)
{
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) {
        glNormal3f(static_cast<float>(i), 0, 1);
        glTexCoord2f(static_cast<float>(i), 0);
        glVertex2f(static_cast<float>(i % 2), static_cast<float>(i / 2));
    }
    glEnd();
    context->flush_vertices();
    const auto draws = backend->draws();
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_EQ(draws[0].format.floats(), 2);
    GLfloat normal[3];
    glGetFloatv(GL_CURRENT_NORMAL, normal);
    EXPECT_EQ(normal[0], 2.0f) << "but they are current";
}

TEST_F(Vertices, AWiderPositionWidensThoseBefore)
{
    glBegin(GL_TRIANGLES);
    glVertex2f(1, 2);
    glVertex3f(3, 4, 5);
    glVertex4f(6, 7, 8, 2);
    glEnd();
    const auto drawn = corners();
    ASSERT_EQ(drawn.size(), 3u);
    EXPECT_EQ(drawn[0].position, glm::vec4(1, 2, 0, 1));
    EXPECT_EQ(drawn[1].position, glm::vec4(3, 4, 5, 1));
    EXPECT_EQ(drawn[2].position, glm::vec4(6, 7, 8, 2));
}

TEST_F(Vertices, AnAttributeThatAppearsLaterFillsInTheOldValueBefore)
{
    glColor4f(0.1f, 0.2f, 0.3f, 0.4f);
    triangle();
    glBegin(GL_TRIANGLES);
    glVertex2f(0, 0);
    glVertex2f(1, 0);
    glColor3f(1, 1, 0);
    glVertex2f(0, 1);
    glEnd();
    const auto drawn = corners();
    ASSERT_EQ(drawn.size(), 6u);
    EXPECT_EQ(drawn[4].color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(drawn[5].color, glm::vec4(1, 1, 0, 1));
}

TEST_F(Vertices, VerticesOutsideBeginAndEndAreDropped)
{
    glVertex2f(1, 1);
    triangle();
    glVertex2f(2, 2);
    EXPECT_EQ(corners().size(), 3u);
}

TEST_F(Vertices, AChangeOfStateSplitsTheBatch)
{
    triangle();
    glTranslatef(10, 0, 0);
    triangle();
    const auto drawn = corners();
    ASSERT_EQ(drawn.size(), 6u);
    EXPECT_EQ(drawn[0].position.x, 0.0f);
    EXPECT_EQ(drawn[3].position.x, 10.0f);
}

TEST_F(Vertices, AMillionMakeOnePrimitive)
{
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 1000000; ++i) {
        glVertex2f(static_cast<float>(i), static_cast<float>(i % 2));
    }
    glEnd();
    context->flush_vertices();
    EXPECT_EQ(backend->counters.vertices, 3u * 999998);
}

/// Three vertices with a colour of their own each, of three components; the batch ends with them.
void draw_colored_triangle()
{
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) {
        glColor3f(static_cast<float>(i), 0, 0);
        glVertex2f(static_cast<float>(i % 2), static_cast<float>(i / 2));
    }
    glEnd();
    glFlush();
}

TEST_F(Vertices, TheNextBatchTakesWhatIsCurrentWhateverTheLastOneHad)
{
    draw_colored_triangle();
    glColor4f(0.1f, 0.2f, 0.3f, 0.4f);
    triangle();
    const auto drawn = corners();
    ASSERT_EQ(drawn.size(), 6u);
    for (int i = 3; i < 6; ++i) {
        EXPECT_EQ(drawn[i].color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    }
}

TEST_F(Vertices, AColorBeforeTheFirstVertexKeepsItsAlphaWhateverTheLastBatchHad)
{
    draw_colored_triangle();
    glBegin(GL_TRIANGLES);
    glColor4f(0.1f, 0.2f, 0.3f, 0.4f);
    for (int i = 0; i < 3; ++i) {
        glVertex2f(static_cast<float>(i % 2), static_cast<float>(i / 2));
    }
    glEnd();
    const auto drawn = corners();
    ASSERT_EQ(drawn.size(), 6u);
    EXPECT_EQ(drawn[3].color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
}

TEST_F(Vertices, ARestoredColorKeepsItsAlphaWhateverTheLastBatchHad)
{
    glColor4f(0.1f, 0.2f, 0.3f, 0.4f);
    glPushAttrib(GL_CURRENT_BIT);
    draw_colored_triangle();
    glPopAttrib();
    triangle();
    const auto drawn = corners();
    ASSERT_EQ(drawn.size(), 6u);
    EXPECT_EQ(drawn[5].color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
}

TEST_F(Vertices, WhatIsCurrentIsThatOfTheLastVertexAndOfWhatCameAfterIt)
{
    draw_colored_triangle();
    glBegin(GL_POINTS);
    glColor3f(0.5f, 0, 0);
    glVertex2f(0, 0);
    glColor4f(0, 0.5f, 0, 0.25f);
    glVertex2f(1, 0);
    glColor3f(0, 0, 0.5f);
    glEnd();
    std::array<GLfloat, 4> color{};
    glGetFloatv(GL_CURRENT_COLOR, color.data());
    EXPECT_EQ(color, (std::array<GLfloat, 4>{0, 0, 0.5f, 1}));
}

} // namespace
