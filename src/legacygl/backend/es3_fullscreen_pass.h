#pragma once

#include "legacygl/backend/es3_functions.h"

#include <vector>

namespace legacygl {

/// Draws over all of the viewport, with fragment shaders that are linked at their first use.
class Es3FullscreenPass
{
public:
    explicit Es3FullscreenPass(const Es3Functions& gl) : gl_(gl) {}

    /// Returns the program of a fragment shader's text, which is told apart by its address; in use.
    GLuint use(const char* fragment);
    /// Draws with the program in use. Binds a vertex array of its own.
    void draw();

    /// Frees the objects. The context is current.
    void destroy();
    /// Forgets the objects, which went with their context.
    void forget();

private:
    struct Program
    {
        const char* fragment;
        GLuint name;
    };

    const Es3Functions& gl_;
    std::vector<Program> programs_;
    GLuint vertex_array_ = 0;
};

} // namespace legacygl
