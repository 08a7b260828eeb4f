// GLU's mipmaps and scaled images (GLU 1.3, chapter 3).
//
// libGLU 9.0.2 gives levels one or two texels wide to OpenGL without the padding that the alignment asks for
// (and OpenGL reads beyond them); here the alignment is 1, as in every program that looks right with it.

#include "scenes/common.h"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

using namespace oracle;

namespace {

/// Gives values that differ everywhere, with sharp edges.
std::vector<GLubyte> picture(int width, int height, int components)
{
    std::vector<GLubyte> pixels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < components; ++c) {
                pixels.push_back(static_cast<GLubyte>((x / 3 + y / 5) % 2 == 0
                                                          ? 40 + (17 * x + 29 * y + 61 * c) % 200
                                                          : 60 * c + 5 * ((x + y) % 12)));
            }
        }
    }
    return pixels;
}

/// Draws a floor that goes into the distance, so that every level shows.
void floor_of_levels()
{
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        const float x = i % 2 == 0 ? -6.0f : 6.0f, z = i < 2 ? 3.0f : -14.0f;
        glTexCoord2f(x, z);
        glVertex3f(x, -0.6f, z);
    }
    glEnd();
}

/// Draws the levels of the bound texture beside each other, each texel a pixel, so that no pixel lies between
/// two.
void every_level(int width, int height)
{
    two_dimensions();
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    float x = 0.2f;
    for (; width >= 1 || height >= 1; width /= 2, height /= 2) {
        const float w = static_cast<float>(width > 0 ? width : 1) / 10;
        const float h = static_cast<float>(height > 0 ? height : 1) / 10;
        glBegin(GL_TRIANGLE_STRIP);
        for (int corner = 0; corner < 4; ++corner) {
            const float s = corner % 2 == 0 ? 0.0f : 1.0f, t = corner < 2 ? 0.0f : 1.0f;
            glTexCoord2f(s, t);
            glVertex2f(x + s * w, 0.2f + t * h);
        }
        glEnd();
        x += w + 0.2f;
    }
}

void build(GLint internal_format, int width, int height, GLenum format, int components)
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const std::vector<GLubyte> pixels = picture(width, height, components);
    tell(std::to_string(gluBuild2DMipmaps(GL_TEXTURE_2D, internal_format, width, height, format,
                                          GL_UNSIGNED_BYTE, pixels.data())));
}

template <class T> std::string text_of(const std::vector<T>& values)
{
    std::string text;
    for (const T value : values) {
        char number[32];
        std::snprintf(number, sizeof number, " %.9g", static_cast<double>(value));
        text += number;
    }
    return text;
}

template <class Out, class In>
void scale(const char* what, GLenum format, int components, GLenum in_type, GLenum out_type, int width,
           int height, int new_width, int new_height)
{
    std::vector<In> in;
    for (const GLubyte value : picture(width, height, components)) {
        in.push_back(in_type == GL_FLOAT ? static_cast<In>(value) / 255
                                         : static_cast<In>(static_cast<double>(value) / 255 *
                                                           (sizeof(In) == 1   ? 127
                                                            : sizeof(In) == 2 ? 32767
                                                                              : 2147483647)));
    }
    std::vector<Out> out(static_cast<std::size_t>(new_width) * new_height * components);
    const GLint result =
        gluScaleImage(format, width, height, in_type, in.data(), new_width, new_height, out_type, out.data());
    tell(std::string(what) + " " + std::to_string(result) + ":" + text_of(out));
}

} // namespace

SCENE(glu_mipmaps_of_a_power_of_two)
{
    three_dimensions();
    build(GL_RGB, 64, 64, GL_RGB, 3);
    floor_of_levels();
}

SCENE(glu_mipmaps_of_no_power_of_two)
{
    three_dimensions();
    build(GL_RGBA, 100, 75, GL_RGBA, 4);
    floor_of_levels();
}

SCENE(glu_mipmaps_level_by_level)
{
    build(GL_RGB, 64, 16, GL_RGB, 3);
    every_level(64, 16);
}

SCENE(glu_mipmaps_level_by_level_of_no_power_of_two)
{
    build(GL_RGB, 57, 39, GL_RGB, 3);
    every_level(64, 32);
}

SCENE(glu_mipmaps_enlarged)
{
    build(GL_LUMINANCE, 13, 7, GL_LUMINANCE, 1);
    every_level(16, 8);
}

SCENE(glu_mipmaps_of_one_power_of_two)
{
    // libGLU 9.0.2 leaves the last row of the first level black here, and so do we.
    build(GL_RGB, 50, 32, GL_RGB, 3);
    every_level(64, 32);
}

SCENE(glu_mipmaps_one_texel_high)
{
    build(GL_RGBA, 64, 1, GL_RGBA, 4);
    every_level(64, 1);
}

SCENE(glu_mipmaps_of_a_part_of_an_image)
{
    const std::vector<GLubyte> pixels = picture(80, 70, 3);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 80);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 7);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 5);
    tell(std::to_string(
        gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 60, 60, GL_RGB, GL_UNSIGNED_BYTE, pixels.data())));
    // The unpacking state is as it was.
    for (const GLenum name : {GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS,
                              GL_UNPACK_SKIP_ROWS, GL_UNPACK_SWAP_BYTES}) {
        GLint value = -1;
        glGetIntegerv(name, &value);
        tell(std::to_string(value));
    }
    every_level(64, 64);
}

SCENE(glu_mipmaps_of_floats_and_shorts)
{
    std::vector<GLfloat> floats;
    std::vector<GLushort> shorts;
    for (const GLubyte value : picture(45, 30, 3)) {
        floats.push_back(static_cast<float>(value) / 255);
        shorts.push_back(static_cast<GLushort>(value * 257));
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    GLuint names[2];
    glGenTextures(2, names);
    glBindTexture(GL_TEXTURE_2D, names[0]);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 45, 30, GL_RGB, GL_FLOAT, floats.data());
    glBindTexture(GL_TEXTURE_2D, names[1]);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 45, 30, GL_RGB, GL_UNSIGNED_SHORT, shorts.data());
    glBindTexture(GL_TEXTURE_2D, names[0]);
    every_level(32, 32);
    glBindTexture(GL_TEXTURE_2D, names[1]);
    glScissor(0, 40, WIDTH, HEIGHT - 40);
    glEnable(GL_SCISSOR_TEST);
    glClear(GL_COLOR_BUFFER_BIT);
    glTranslatef(0, 5, 0);
    glDisable(GL_SCISSOR_TEST);
    glBegin(GL_TRIANGLE_STRIP);
    for (int corner = 0; corner < 4; ++corner) {
        const float s = corner % 2 == 0 ? 0.0f : 1.0f, t = corner < 2 ? 0.0f : 1.0f;
        glTexCoord2f(s, t);
        glVertex2f(1 + 3.2f * s, 1 + 3.2f * t);
    }
    glEnd();
}

SCENE(glu_mipmaps_of_some_levels)
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const std::vector<GLubyte> base = picture(32, 32, 3), other = picture(16, 16, 3);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 32, 32, GL_RGB, GL_UNSIGNED_BYTE, base.data());
    // Another image takes the place of levels 2 and 3; it is level 1 itself.
    tell(std::to_string(gluBuild2DMipmapLevels(GL_TEXTURE_2D, GL_RGB, 16, 16, GL_RGB, GL_UNSIGNED_BYTE, 1, 2,
                                               3, other.data())));
    const int bad[][3] = {{1, 0, 3}, {0, -1, 3}, {1, 3, 2}, {1, 2, 6}, {-1, 0, 0}};
    for (const int* levels : bad) {
        tell(std::to_string(gluBuild2DMipmapLevels(GL_TEXTURE_2D, GL_RGB, 16, 16, GL_RGB, GL_UNSIGNED_BYTE,
                                                   levels[0], levels[1], levels[2], other.data())));
    }
    tell(std::to_string(gluBuild2DMipmapLevels(GL_TEXTURE_2D, GL_RGB, 15, 15, GL_RGB, GL_UNSIGNED_BYTE, 0, 0,
                                               0, other.data())));
    every_level(32, 32);
}

SCENE(glu_mipmaps_of_one_dimension)
{
    two_dimensions();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const std::vector<GLubyte> pixels = picture(50, 1, 3);
    tell(std::to_string(
        gluBuild1DMipmaps(GL_TEXTURE_1D, GL_RGB, 50, GL_RGB, GL_UNSIGNED_BYTE, pixels.data())));
    glEnable(GL_TEXTURE_1D);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    float width = 12.8f;
    for (int level = 0; level < 7; ++level, width /= 2) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int corner = 0; corner < 4; ++corner) {
            const float s = corner % 2 == 0 ? 0.0f : 1.0f;
            glTexCoord1f(s);
            glVertex2f(1 + s * width, 0.5f + 1.5f * static_cast<float>(level) + (corner < 2 ? 0.0f : 1.0f));
        }
        glEnd();
    }
}

SCENE(glu_image_errors)
{
    two_dimensions();
    const std::vector<GLubyte> pixels(64 * 64 * 4, 100);
    std::vector<GLubyte> out(64 * 64 * 4);
    const auto two = [&](int w, int h, GLenum format, GLenum type) {
        tell(std::to_string(gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, w, h, format, type, pixels.data())));
    };
    two(0, 4, GL_RGB, GL_UNSIGNED_BYTE);
    two(4, -1, GL_RGB, GL_UNSIGNED_BYTE);
    two(4, 4, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
    two(4, 4, GL_MODULATE, GL_UNSIGNED_BYTE);
    two(4, 4, GL_RGB, GL_DOUBLE);
    two(4, 4, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5);
    two(4, 4, GL_RGB, GL_UNSIGNED_INT_8_8_8_8);
    tell(
        std::to_string(gluBuild1DMipmaps(GL_TEXTURE_1D, GL_RGB, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels.data())));
    tell(std::to_string(gluBuild1DMipmaps(GL_TEXTURE_1D, GL_RGB, 4, GL_RGB, GL_2D, pixels.data())));
    const auto scaled = [&](GLenum format, int w, int h, GLenum in, int new_w, int new_h, GLenum type) {
        tell(std::to_string(gluScaleImage(format, w, h, in, pixels.data(), new_w, new_h, type, out.data())));
    };
    scaled(GL_RGB, 0, 4, GL_UNSIGNED_BYTE, 4, 4, GL_UNSIGNED_BYTE);
    scaled(GL_RGB, 4, 4, GL_UNSIGNED_BYTE, 4, 0, GL_UNSIGNED_BYTE);
    scaled(GL_RGB, -4, 4, GL_UNSIGNED_BYTE, 4, 4, GL_UNSIGNED_BYTE);
    scaled(GL_RGB, 4, 4, GL_UNSIGNED_BYTE, 4, -4, GL_UNSIGNED_BYTE);
    scaled(GL_FILL, 4, 4, GL_UNSIGNED_BYTE, 4, 4, GL_UNSIGNED_BYTE);
    scaled(GL_RGB, 4, 4, GL_DOUBLE, 4, 4, GL_UNSIGNED_BYTE);
    scaled(GL_RGB, 4, 4, GL_UNSIGNED_BYTE, 4, 4, GL_UNSIGNED_SHORT_4_4_4_4);
}

SCENE(glu_scaled_images)
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    scale<GLubyte, GLubyte>("smaller", GL_RGB, 3, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, 13, 9, 5, 4);
    scale<GLubyte, GLubyte>("larger", GL_RGB, 3, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, 5, 3, 9, 7);
    scale<GLubyte, GLubyte>("halved", GL_LUMINANCE, 1, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, 16, 12, 8, 6);
    scale<GLubyte, GLubyte>("same", GL_RGBA, 4, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, 4, 4, 4, 4);
    scale<GLubyte, GLubyte>("one way", GL_LUMINANCE_ALPHA, 2, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, 7, 6, 7,
                            11);
    scale<GLubyte, GLubyte>("to one", GL_RGB, 3, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, 21, 17, 1, 1);
    scale<GLubyte, GLubyte>("from one", GL_RGB, 3, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, 1, 1, 3, 2);
    scale<GLushort, GLubyte>("to shorts", GL_BGRA, 4, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, 6, 5, 4, 3);
    scale<GLfloat, GLubyte>("to floats", GL_ALPHA, 1, GL_UNSIGNED_BYTE, GL_FLOAT, 10, 10, 3, 4);
    scale<GLint, GLubyte>("to ints", GL_RED, 1, GL_UNSIGNED_BYTE, GL_INT, 10, 10, 3, 4);
    scale<GLuint, GLubyte>("to uints", GL_BGR, 3, GL_UNSIGNED_BYTE, GL_UNSIGNED_INT, 5, 5, 3, 4);
    scale<GLbyte, GLfloat>("floats to bytes", GL_RGB, 3, GL_FLOAT, GL_BYTE, 9, 5, 4, 8);
    scale<GLshort, GLint>("ints to shorts", GL_GREEN, 1, GL_INT, GL_SHORT, 9, 5, 4, 8);
    scale<GLfloat, GLshort>("shorts to floats", GL_RGB, 3, GL_SHORT, GL_FLOAT, 6, 6, 4, 4);
    scale<GLubyte, GLbyte>("indices", GL_COLOR_INDEX, 1, GL_BYTE, GL_UNSIGNED_BYTE, 8, 8, 5, 5);
    scale<GLfloat, GLuint>("depths", GL_DEPTH_COMPONENT, 1, GL_UNSIGNED_INT, GL_FLOAT, 8, 3, 5, 5);
}

SCENE(glu_scaled_images_of_packed_types)
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    const struct
    {
        GLenum type, format;
    } types[] = {{GL_UNSIGNED_BYTE_3_3_2, GL_RGB},      {GL_UNSIGNED_BYTE_2_3_3_REV, GL_RGB},
                 {GL_UNSIGNED_SHORT_5_6_5, GL_RGB},     {GL_UNSIGNED_SHORT_5_6_5_REV, GL_RGB},
                 {GL_UNSIGNED_SHORT_4_4_4_4, GL_RGBA},  {GL_UNSIGNED_SHORT_4_4_4_4_REV, GL_BGRA},
                 {GL_UNSIGNED_SHORT_5_5_5_1, GL_RGBA},  {GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_BGRA},
                 {GL_UNSIGNED_INT_8_8_8_8, GL_RGBA},    {GL_UNSIGNED_INT_8_8_8_8_REV, GL_BGRA},
                 {GL_UNSIGNED_INT_10_10_10_2, GL_RGBA}, {GL_UNSIGNED_INT_2_10_10_10_REV, GL_RGBA}};
    for (const auto& [type, format] : types) {
        const std::vector<GLubyte> in = picture(9, 7, 4);
        std::vector<GLubyte> out(6 * 5 * 4);
        const GLint result = gluScaleImage(format, 9, 7, type, in.data(), 6, 5, type, out.data());
        tell(std::to_string(result) + text_of(out));
    }
}

SCENE(glu_scaled_part_into_a_part)
{
    std::vector<GLubyte> in = picture(20, 20, 3), out(30 * 30 * 3, 7);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 17);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 2);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPixelStorei(GL_PACK_ROW_LENGTH, 15);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 3);
    glPixelStorei(GL_PACK_SKIP_ROWS, 1);
    tell(std::to_string(
        gluScaleImage(GL_RGB, 11, 9, GL_UNSIGNED_BYTE, in.data(), 7, 12, GL_UNSIGNED_BYTE, out.data())));
    tell(text_of(out));
    for (const GLenum name : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS}) {
        glPixelStorei(name, 0);
    }
}
