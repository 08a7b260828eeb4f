// gluScaleImage (GLU 1.3, 3.1).

#include "legacygl/glu/short_image.h"

using namespace legacygl::glu;

GLint gluScaleImage(GLenum format, GLsizei wIn, GLsizei hIn, GLenum typeIn, const void* dataIn, GLsizei wOut,
                    GLsizei hOut, GLenum typeOut, GLvoid* dataOut)
{
    if (wIn == 0 || hIn == 0 || wOut == 0 || hOut == 0) {
        return 0;
    }
    if (wIn < 0 || hIn < 0 || wOut < 0 || hOut < 0) {
        return GLU_INVALID_VALUE;
    }
    const GLenum in = check_format_and_type(format, typeIn), out = check_format_and_type(format, typeOut);
    if (in == GLU_INVALID_ENUM || out == GLU_INVALID_ENUM) {
        return GLU_INVALID_ENUM;
    }
    if (in != 0 || out != 0) {
        return GLU_INVALID_OPERATION;
    }
    const std::vector<GLushort> image =
        read_shorts(PixelStoreModes::unpacking(), wIn, hIn, format, typeIn, dataIn);
    write_shorts(PixelStoreModes::packing(), wOut, hOut, format, typeOut,
                 scale_shorts(image, components_of(format), wIn, hIn, wOut, hOut), dataOut);
    return 0;
}
