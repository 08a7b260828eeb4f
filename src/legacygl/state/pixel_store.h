#pragma once

#include <GL/gl.h>

namespace legacygl {

/// OpenGL 1.5, table 6.21: how client memory is read and written.
struct PixelStore
{
    bool swap_bytes = false;
    bool lsb_first = false;
    GLint alignment = 4;
    GLint row_length = 0;
    GLint skip_rows = 0;
    GLint skip_pixels = 0;
};

} // namespace legacygl
