// Images of textures: formats, types, parts, copies, borders and what is told of them
// (OpenGL 1.5, 3.6.4, 3.8.1 to 3.8.8 and 6.1.4).

#define GL_GLEXT_PROTOTYPES
#include "scenes/texture_images.h"

#include "scenes/common.h"

#include <algorithm>
#include <array>
#include <vector>

using namespace oracle;

namespace {
void tell_texels(GLenum target, GLint level, GLenum format, GLenum type, std::size_t bytes)
{
    std::vector<GLubyte> out(bytes, 77);
    glGetTexImage(target, level, format, type, out.data());
    std::string line = "texels";
    for (GLubyte b : out) {
        line += " " + std::to_string(b);
    }
    tell(line);
    tell_error("texels");
}

constexpr GLenum PACKED[] = {
    GL_UNSIGNED_BYTE_3_3_2,      GL_UNSIGNED_BYTE_2_3_3_REV,    GL_UNSIGNED_SHORT_5_6_5,
    GL_UNSIGNED_SHORT_5_6_5_REV, GL_UNSIGNED_SHORT_4_4_4_4,     GL_UNSIGNED_SHORT_4_4_4_4_REV,
    GL_UNSIGNED_SHORT_5_5_5_1,   GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_UNSIGNED_INT_8_8_8_8,
    GL_UNSIGNED_INT_8_8_8_8_REV, GL_UNSIGNED_INT_10_10_10_2,    GL_UNSIGNED_INT_2_10_10_10_REV};

} // namespace

SCENE(texture_client_formats_and_types)
{
    two_dimensions();
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    parameters(GL_NEAREST, GL_CLAMP_TO_EDGE);
    const std::vector<GLubyte> bytes = noise(4096);
    const GLenum formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                              GL_RGB, GL_RGBA,  GL_BGR,  GL_BGRA};
    const GLenum types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT};
    for (int f = 0; f < 10; ++f) {
        for (int t = 0; t < 3; ++t) {
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, formats[f], types[t], bytes.data());
            quad(1.5f * static_cast<float>(f) + 0.2f, 3 * static_cast<float>(t) + 0.2f, 1.4f, 2.5f);
        }
    }
    std::vector<GLfloat> floats(256);
    for (std::size_t i = 0; i < 256; ++i) {
        floats[i] = static_cast<GLfloat>(bytes[i]) / 200 - 0.1f;
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_FLOAT, floats.data());
    quad(0.2f, 9.3f, 5, 2.5f);
    glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_SHORT, bytes.data());
    quad(5.5f, 9.3f, 5, 2.5f);
}

SCENE(texture_packed_types)
{
    two_dimensions();
    glEnable(GL_TEXTURE_2D);
    parameters(GL_NEAREST, GL_REPEAT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const std::vector<GLubyte> bytes = noise(256);
    for (int swapped = 0; swapped < 2; ++swapped) {
        glPixelStorei(GL_UNPACK_SWAP_BYTES, swapped);
        for (int i = 0; i < 12; ++i) {
            const GLenum format = i < 4 ? GL_RGB : i % 2 ? GL_BGRA : GL_RGBA;
            glTexImage2D(GL_TEXTURE_2D, 0, i < 4 ? GL_RGB8 : GL_RGBA8, 8, 8, 0, format, PACKED[i],
                         bytes.data());
            quad(2.6f * static_cast<float>(i % 6) + 0.2f, 3 * static_cast<float>(2 * swapped + i / 6) + 0.2f,
                 2.4f, 2.6f);
        }
    }
    for (GLenum type : PACKED) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, type, bytes.data());
        tell_error("rgb " + std::to_string(type));
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGBA, type, bytes.data());
        tell_error("rgba " + std::to_string(type));
    }
}

SCENE(texture_internal_formats)
{
    two_dimensions();
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    parameters(GL_NEAREST, GL_REPEAT);
    const std::vector<GLubyte> bytes = noise(256);
    const GLint formats[] = {1,
                             2,
                             3,
                             4,
                             GL_ALPHA4,
                             GL_ALPHA8,
                             GL_LUMINANCE4,
                             GL_LUMINANCE8,
                             GL_LUMINANCE4_ALPHA4,
                             GL_LUMINANCE6_ALPHA2,
                             GL_LUMINANCE8_ALPHA8,
                             GL_INTENSITY,
                             GL_INTENSITY4,
                             GL_INTENSITY8,
                             GL_R3_G3_B2,
                             GL_RGB4,
                             GL_RGB5,
                             GL_RGB8,
                             GL_RGBA2,
                             GL_RGBA4,
                             GL_RGB5_A1,
                             GL_RGBA8};
    int i = 0;
    for (GLint format : formats) {
        glTexImage2D(GL_TEXTURE_2D, 0, format, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        quad(2 * static_cast<float>(i % 8) + 0.1f, 4 * static_cast<float>(i / 8) + 0.1f, 1.8f, 3.8f);
        tell("format " + std::to_string(format));
        tell_level(GL_TEXTURE_2D, 0);
        ++i;
    }
}

SCENE(texture_sub_images)
{
    two_dimensions();
    glEnable(GL_TEXTURE_2D);
    parameters(GL_NEAREST, GL_REPEAT);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, noise(768).data());
    quad(0.2f, 0.2f, 5, 5);
    const std::vector<GLubyte> red(300, 200);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 3, 5, 10, 7, GL_LUMINANCE, GL_UNSIGNED_BYTE, red.data());
    quad(5.4f, 0.2f, 5, 5);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 9);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
    glNewList(1, GL_COMPILE);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 5, 5, GL_RGB, GL_UNSIGNED_BYTE, noise(400).data());
    glEndList();
    quad(10.6f, 0.2f, 5, 5);
    glCallList(1);
    quad(0.2f, 6, 5, 5);
    for (const auto& [x, y, w, h] : {std::array<GLint, 4>{-1, 0, 1, 1},
                                     {16, 0, 1, 1},
                                     {0, 0, 17, 1},
                                     {0, 15, 1, 2},
                                     {0, 0, -1, 1},
                                     {5, 5, 0, 0}}) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, w, h, GL_RGB, GL_UNSIGNED_BYTE, red.data());
        tell_error("part");
    }
    glTexSubImage2D(GL_TEXTURE_2D, 3, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, red.data());
    tell_error("no such level");
    glTexSubImage2D(GL_TEXTURE_2D, -1, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, red.data());
    tell_error("level");
    glTexSubImage2D(GL_TEXTURE_1D, 0, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, red.data());
    tell_error("target");
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_LINES, GL_UNSIGNED_BYTE, red.data());
    tell_error("format");
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, noise(24).data());
    glTexSubImage1D(GL_TEXTURE_1D, 0, 2, 3, GL_LUMINANCE, GL_UNSIGNED_BYTE, red.data());
    glDisable(GL_TEXTURE_2D);
    glEnable(GL_TEXTURE_1D);
    quad(5.4f, 6, 5, 5);
    tell_error("left");
}

SCENE(texture_copies)
{
    two_dimensions();
    for (int i = 0; i < 12; ++i) {
        glColor4f(static_cast<float>(i) / 12, static_cast<float>(i % 3) / 2, static_cast<float>(i % 4) / 3,
                  0.5f);
        glRectf(static_cast<float>(i) / 3, static_cast<float>(i % 5), static_cast<float>(i) / 3 + 1.5f,
                static_cast<float>(i % 5) + 1);
    }
    glColor3f(1, 1, 1);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    parameters(GL_NEAREST, GL_CLAMP_TO_EDGE);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 3, 2, 32, 32, 0);
    tell_error("copied");
    tell_level(GL_TEXTURE_2D, 0);
    glEnable(GL_TEXTURE_2D);
    quad(7, 0.5f, 4, 5);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE_ALPHA, 3, 2, 32, 32, 0);
    quad(11.5f, 0.5f, 4, 5);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 4, 6, 70, 10, 9, 15);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 20, 20, 155, 115, 10, 10); // Partly outside the frame buffer.
    quad(7, 6, 4, 5);
    glCopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 0, 20, 64, 0);
    glCopyTexSubImage1D(GL_TEXTURE_1D, 0, 8, 100, 20, 16);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glDisable(GL_TEXTURE_2D);
    glEnable(GL_TEXTURE_1D);
    quad(11.5f, 6, 4, 5);
    tell_error("left");
    glCopyTexImage2D(GL_TEXTURE_2D, 0, 3, 0, 0, 8, 8, 0);
    tell_error("format 3");
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, -1, 8, 0);
    tell_error("width");
    glCopyTexImage2D(GL_TEXTURE_2D, -1, GL_RGB, 0, 0, 8, 8, 0);
    tell_error("level");
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 8, 8, 2);
    tell_error("border");
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 30, 0, 0, 0, 8, 8);
    tell_error("beyond");
    glCopyTexSubImage2D(GL_TEXTURE_2D, 5, 0, 0, 0, 0, 1, 1);
    tell_error("no such level");
}

// Which level ES samples is not told to the shader that weighs the border: along the line where the level
// changes a few pixels take the border's width from the next one.
SCENE(texture_proxies)
{
    for (GLsizei size : {64, 63, 1 << 20}) {
        glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        tell_level(GL_PROXY_TEXTURE_2D, 0);
        glTexImage1D(GL_PROXY_TEXTURE_1D, 1, GL_LUMINANCE8, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        tell_level(GL_PROXY_TEXTURE_1D, 1);
    }
    tell_level(GL_TEXTURE_2D, 0); // The texture itself is untouched.
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, 77, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    tell_error("format");
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, -1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    tell_error("width");
    glTexImage1D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    tell_error("dimensions");
}

SCENE(texture_generated_levels_read_back,
      {0, "OpenGL 1.5, 3.8.8: no particular filter is required. This Mesa rounds otherwise.", {26}, 3})
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    std::vector<GLubyte> texels;
    for (unsigned i = 0, noise = 1; i < 63 * 35 * 4; ++i, noise = noise * 1664525 + 1013904223) {
        texels.push_back(static_cast<GLubyte>(noise >> 24));
    }
    for (const auto& [width, height] : {std::array{32, 16}, {63, 35}, {5, 9}, {31, 1}, {1, 6}}) {
        for (const auto& [format, components] :
             {std::array{GL_RGBA, 4}, {GL_RGB, 3}, {GL_LUMINANCE_ALPHA, 2}}) {
            glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, static_cast<GLenum>(format),
                         GL_UNSIGNED_BYTE, texels.data());
            for (int level = 1; (width >> level | height >> level) != 0; ++level) {
                const int size = std::max(1, width >> level) * std::max(1, height >> level) * components;
                std::vector<GLubyte> read(static_cast<std::size_t>(size));
                glGetTexImage(GL_TEXTURE_2D, level, static_cast<GLenum>(format), GL_UNSIGNED_BYTE,
                              read.data());
                std::string line = std::to_string(width) + " x " + std::to_string(height) + " level " +
                                   std::to_string(level) + ":";
                for (const GLubyte component : read) {
                    line += " " + std::to_string(component);
                }
                tell(line);
            }
        }
    }
}

SCENE(texture_parameters_and_their_errors)
{
    const auto all = [](GLenum target) {
        for (GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S,
                            GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R, GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL,
                            GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD, GL_TEXTURE_BORDER_COLOR,
                            GL_TEXTURE_PRIORITY, GL_TEXTURE_RESIDENT, GL_GENERATE_MIPMAP}) {
            GLfloat reals[4] = {};
            GLint integers[4] = {};
            glGetTexParameterfv(target, name, reals);
            glGetTexParameteriv(target, name, integers);
            std::string line = std::to_string(name);
            for (int i = 0; i < 4; ++i) {
                line += " " + std::to_string(reals[i]) + " " + std::to_string(integers[i]);
            }
            tell_error(line);
        }
    };
    all(GL_TEXTURE_2D);
    all(GL_TEXTURE_1D);
    const GLfloat color[] = {0.25f, 0.5f, 0.75f, 1};
    const GLint integers[] = {2147483647, 0, 1000000000, 5};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, color);
    glTexParameteriv(GL_TEXTURE_1D, GL_TEXTURE_BORDER_COLOR, integers);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, 0.25f);
    glTexParameterf(GL_TEXTURE_1D, GL_TEXTURE_PRIORITY, 7);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_R, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 2);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, 3.5f);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 5);
    all(GL_TEXTURE_2D);
    all(GL_TEXTURE_1D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    tell_error("magnify");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_REPEAT);
    tell_error("minify");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_LINEAR);
    tell_error("wrap");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1);
    tell_error("one colour");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_RESIDENT, 1);
    tell_error("resident");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, -1);
    tell_error("level");
    glTexParameteri(GL_PROXY_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    tell_error("target");
    glTexParameteri(GL_TEXTURE_2D, GL_AMBIENT, GL_LINEAR);
    tell_error("name");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, -1);
    tell_error("negative");
}

SCENE(texture_texels_come_back)
{
    const std::vector<GLubyte> bytes = noise(64);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (GLint internal : {GL_RGBA, GL_RGB, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ALPHA, GL_INTENSITY}) {
        glTexImage2D(GL_TEXTURE_2D, 0, internal, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        for (GLenum format : {GL_RGBA, GL_RGB, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ALPHA, GL_RED, GL_BGRA}) {
            tell_texels(GL_TEXTURE_2D, 0, format, GL_UNSIGNED_BYTE, 16);
        }
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    for (GLenum type : {GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_FLOAT}) {
        tell_texels(GL_TEXTURE_2D, 0, GL_RGBA, type, 64);
    }
    glPixelStorei(GL_PACK_ROW_LENGTH, 3);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 1);
    glPixelStorei(GL_PACK_SKIP_ROWS, 1);
    tell_texels(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, 40);
    tell_texels(GL_TEXTURE_2D, 5, GL_RGB, GL_UNSIGNED_BYTE, 4);
    tell_texels(GL_TEXTURE_2D, -1, GL_RGB, GL_UNSIGNED_BYTE, 4);
    tell_texels(GL_PROXY_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, 4);
    tell_texels(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, 4);
    tell_texels(GL_TEXTURE_2D, 0, GL_LINES, GL_UNSIGNED_BYTE, 4);
}

SCENE(texture_names_and_residence)
{
    GLuint names[3] = {};
    glGenTextures(3, names);
    tell(std::to_string(glIsTexture(names[0])) + std::to_string(glIsTexture(0)));
    for (GLuint name : names) {
        glBindTexture(GL_TEXTURE_2D, name);
    }
    glBindTexture(GL_TEXTURE_1D, names[0]);
    tell_error("another target");
    tell(std::to_string(glIsTexture(names[0])) + std::to_string(glIsTexture(names[2])));
    GLboolean resident[3] = {9, 9, 9};
    tell(std::to_string(glAreTexturesResident(3, names, resident)));
    const GLclampf priorities[] = {0.25f, -1, 3};
    glPrioritizeTextures(3, names, priorities);
    for (GLuint name : names) {
        glBindTexture(GL_TEXTURE_2D, name);
        GLfloat priority = 9;
        glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, &priority);
        tell(std::to_string(priority));
    }
    glDeleteTextures(1, &names[2]);
    TELL_STATE(GL_TEXTURE_BINDING_2D, 1);
    tell(std::to_string(glIsTexture(names[2])));
    tell(std::to_string(glAreTexturesResident(3, names, resident)));
    tell_error("a deleted one");
    glPrioritizeTextures(3, names, priorities);
    tell_error("priorities");
    glPrioritizeTextures(-1, names, priorities);
    tell_error("fewer");
    glDeleteTextures(-1, names);
    tell_error("fewer deleted");
    glBindTexture(GL_TEXTURE_2D, names[1]);
    glPushAttrib(GL_TEXTURE_BIT);
    glDeleteTextures(1, &names[1]);
    glPopAttrib();
    tell_state("bound again", GL_TEXTURE_BINDING_2D, 1);
    tell(std::to_string(glIsTexture(names[1])));
}
