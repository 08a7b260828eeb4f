#pragma once

#include <GL/gl.h>

namespace scene {

// Between two drawings of a frame OpenGL is at rest: depth is tested and written, GL_NORMALIZE and the lights
// are on, and everything else is off or at its default. Each drawing switches what it needs for the scope it
// needs it in, so that none has to know what was drawn before.

/// Turns a capability on that is off at rest, and off again at the end of the scope.
class Enabled
{
public:
    explicit Enabled(GLenum capability) : capability_(capability) { glEnable(capability); }
    ~Enabled() { glDisable(capability_); }
    Enabled(const Enabled&) = delete;
    Enabled& operator=(const Enabled&) = delete;

private:
    GLenum capability_;
};

/// Turns a capability off that is on around it, and on again at the end of the scope.
class Disabled
{
public:
    explicit Disabled(GLenum capability) : capability_(capability) { glDisable(capability); }
    ~Disabled() { glEnable(capability_); }
    Disabled(const Disabled&) = delete;
    Disabled& operator=(const Disabled&) = delete;

private:
    GLenum capability_;
};

/// Blends what is drawn in the scope, and lets it write no depth: what is seen through hides nothing.
class Blended
{
public:
    explicit Blended(GLenum destination = GL_ONE_MINUS_SRC_ALPHA) : blend_(GL_BLEND)
    {
        glBlendFunc(GL_SRC_ALPHA, destination);
        glDepthMask(GL_FALSE);
    }
    ~Blended()
    {
        glDepthMask(GL_TRUE);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }
    Blended(const Blended&) = delete;
    Blended& operator=(const Blended&) = delete;

private:
    Enabled blend_;
};

/// Draws lines of a width in pixels in the scope; 1 at rest.
class LineWidth
{
public:
    explicit LineWidth(float pixels) { glLineWidth(pixels); }
    ~LineWidth() { glLineWidth(1.0f); }
    LineWidth(const LineWidth&) = delete;
    LineWidth& operator=(const LineWidth&) = delete;
};

/// Draws polygons by their edges in the scope, if asked to.
class Edges
{
public:
    explicit Edges(bool are_drawn) { glPolygonMode(GL_FRONT_AND_BACK, are_drawn ? GL_LINE : GL_FILL); }
    ~Edges() { glPolygonMode(GL_FRONT_AND_BACK, GL_FILL); }
    Edges(const Edges&) = delete;
    Edges& operator=(const Edges&) = delete;
};

/// Keeps the matrix of the scope around it.
class PushedMatrix
{
public:
    PushedMatrix() { glPushMatrix(); }
    ~PushedMatrix() { glPopMatrix(); }
    PushedMatrix(const PushedMatrix&) = delete;
    PushedMatrix& operator=(const PushedMatrix&) = delete;
};

} // namespace scene
