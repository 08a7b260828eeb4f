// 2D textures (OpenGL 1.5, 3.8).

#include "scenes/common.h"

#include <vector>

using namespace oracle;

namespace {

/// Gives an image of coloured stripes and a checker, different in every texel.
std::vector<GLubyte> picture(int width, int height, int channels)
{
    std::vector<GLubyte> pixels(static_cast<std::size_t>(width) * height * channels);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < channels; ++c) {
                const int checker = (x / 4 + y / 4) % 2 ? 180 : 40;
                const int value = c == 0   ? checker + x
                                  : c == 1 ? 255 * x / width
                                  : c == 2 ? 255 * y / height
                                           : 128 + checker / 2;
                pixels[(static_cast<std::size_t>(y) * width + x) * channels + c] =
                    static_cast<GLubyte>(value & 255);
            }
        }
    }
    return pixels;
}

void texture(GLenum format, int channels, int width, int height, GLenum minify, GLenum magnify)
{
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minify));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magnify));
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, format, GL_UNSIGNED_BYTE,
                 picture(width, height, channels).data());
    glEnable(GL_TEXTURE_2D);
}

void receding_floor()
{
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glTexCoord2f(i % 2 ? 6.0f : 0.0f, i / 2 ? 9.0f : 0.0f);
        glVertex3f(i % 2 ? 3.0f : -3.0f, -0.8f, i / 2 ? -12.0f : 3.0f);
    }
    glEnd();
}

} // namespace

SCENE(texture_nearest)
{
    three_dimensions();
    texture(GL_RGB, 3, 16, 16, GL_NEAREST, GL_NEAREST);
    glRotatef(30, 1, 1, 0);
    cube();
}

SCENE(texture_linear)
{
    three_dimensions();
    texture(GL_RGBA, 4, 16, 16, GL_LINEAR, GL_LINEAR);
    glRotatef(30, 1, 1, 0);
    cube();
}

SCENE(texture_generated_mipmaps)
{
    three_dimensions();
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, picture(64, 64, 3).data());
    glEnable(GL_TEXTURE_2D);
    receding_floor();
}

SCENE(texture_given_mipmaps)
{
    three_dimensions();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    for (int level = 0, size = 32; size > 0; ++level, size /= 2) {
        std::vector<GLubyte> pixels(static_cast<std::size_t>(size) * size * 3);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            pixels[i] = static_cast<GLubyte>(i % 3 == static_cast<std::size_t>(level) % 3 ? 230 : 30 * level);
        }
        glTexImage2D(GL_TEXTURE_2D, level, 3, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    }
    glEnable(GL_TEXTURE_2D);
    receding_floor();
}

SCENE(texture_incomplete_is_off)
{
    three_dimensions();
    texture(GL_RGB, 3, 16, 16, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    glRotatef(30, 1, 1, 0);
    cube();
}

SCENE(texture_environments_and_formats)
{
    two_dimensions();
    const GLenum formats[] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA};
    const int channels[] = {1, 1, 2, 3, 4};
    const GLenum modes[] = {GL_MODULATE, GL_REPLACE, GL_BLEND};
    const GLfloat environment[] = {0.2f, 0.9f, 0.4f, 0.7f};
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, environment);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int f = 0; f < 5; ++f) {
        texture(formats[f], channels[f], 16, 16, GL_LINEAR, GL_LINEAR);
        for (int m = 0; m < 3; ++m) {
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(modes[m]));
            glColor4f(0.9f, 0.6f, 0.3f, 0.8f);
            glBegin(GL_TRIANGLE_STRIP);
            for (int i = 0; i < 4; ++i) {
                glTexCoord2i(i % 2, i / 2);
                glVertex2f(3.1f * static_cast<float>(f) + 0.2f + (i % 2 ? 2.7f : 0),
                           4 * static_cast<float>(m) + 0.2f + (i / 2 ? 3.5f : 0));
            }
            glEnd();
        }
    }
}

SCENE(texture_decal)
{
    two_dimensions();
    texture(GL_RGBA, 4, 16, 16, GL_LINEAR, GL_LINEAR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glColor3f(0.9f, 0.1f, 0.1f);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glTexCoord2i(2 * (i % 2), i / 2);
        glVertex2i(1 + 13 * (i % 2), 1 + 10 * (i / 2));
    }
    glEnd();
}

SCENE(texture_matrix_and_projection)
{
    three_dimensions();
    texture(GL_RGB, 3, 32, 32, GL_LINEAR, GL_LINEAR);
    glMatrixMode(GL_TEXTURE);
    glTranslatef(0.5f, 0.5f, 0);
    glRotatef(30, 0, 0, 1);
    glScalef(2, 3, 1);
    glMatrixMode(GL_MODELVIEW);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        const float q = i / 2 ? 0.4f : 1.0f;
        glTexCoord4f(i % 2 ? q : 0, i / 2 ? q : 0, 0, q);
        glVertex3f((i % 2 ? 1.5f : -1.5f) * q, i / 2 ? 1.2f : -1.2f, 0);
    }
    glEnd();
}

SCENE(texture_with_lighting)
{
    three_dimensions();
    texture(GL_RGB, 3, 32, 32, GL_LINEAR, GL_LINEAR);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    const GLfloat specular[] = {1, 1, 1, 1};
    glMaterialfv(GL_FRONT, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT, GL_SHININESS, 40);
    glRotatef(50, 1, 0, 0);
    torus(1.3f, 0.5f, 12, 24);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glTranslatef(0, 1, 0);
    torus(0.5f, 0.3f, 12, 24);
}

SCENE(texture_wrap_modes)
{
    two_dimensions();
    const GLenum modes[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
    texture(GL_RGB, 3, 16, 16, GL_LINEAR, GL_LINEAR);
    for (int s = 0; s < 3; ++s) {
        for (int t = 0; t < 3; ++t) {
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(modes[s]));
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(modes[t]));
            glBegin(GL_TRIANGLE_STRIP);
            for (int i = 0; i < 4; ++i) {
                glTexCoord2f(i % 2 ? 2.3f : -1.2f, i / 2 ? 2.1f : -1.1f);
                glVertex2f(5.2f * static_cast<float>(s) + (i % 2 ? 5.0f : 0.2f),
                           4 * static_cast<float>(t) + (i / 2 ? 3.8f : 0.2f));
            }
            glEnd();
        }
    }
}

SCENE(texture_unpacking)
{
    two_dimensions();
    const std::vector<GLubyte> pixels = picture(37, 20, 3);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 37);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 2);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glTexCoord2i(i % 2, i / 2);
        glVertex2i(2 + 12 * (i % 2), 1 + 10 * (i / 2));
    }
    glEnd();
}

SCENE(texture_changed_between_draws)
{
    two_dimensions();
    texture(GL_RGB, 3, 16, 16, GL_NEAREST, GL_NEAREST);
    for (int turn = 0; turn < 2; ++turn) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int i = 0; i < 4; ++i) {
            glTexCoord2i(i % 2, i / 2);
            glVertex2i(1 + 7 * (i % 2) + 7 * turn, 1 + 10 * (i / 2));
        }
        glEnd();
        const std::vector<GLubyte> red(16 * 16 * 3, 200);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, red.data());
    }
}

// Primitives that take the texture coordinates left by others, which lie on a texel's edge: a mesh drawn with
// the texture still on. Interpolated, they would end in one texel here and in its neighbour there.
SCENE(texture_coordinates_of_no_vertex)
{
    three_dimensions();
    texture(GL_RGB, 3, 4, 4, GL_NEAREST, GL_NEAREST);
    glMatrixMode(GL_PROJECTION);
    glTranslatef(-1, 0.3f, 0.2f);
    glMatrixMode(GL_MODELVIEW);
    for (int i = 0; i < 24; ++i) {
        glTexCoord2f(0.25f * static_cast<float>(i), 1 - 0.25f * static_cast<float>(i / 5));
        glPushMatrix();
        glRotatef(15.0f * static_cast<float>(i), 0, 0.2f, 1);
        glBegin(GL_TRIANGLES);
        glVertex3f(0.1f, 0, 0);
        glVertex3f(2.3f, -0.2f, -3);
        glVertex3f(1.4f, 0.3f, 1);
        glEnd();
        glPopMatrix();
    }
    glTranslatef(2.5f, 0, 0);
    for (int i = 0; i < 12; ++i) { // With nothing between: vertices have the coordinates from the second on.
        glTexCoord2f(0.75f, 0.25f * static_cast<float>(i));
        const float y = 0.25f * static_cast<float>(i) - 1.7f;
        glBegin(GL_TRIANGLES);
        glVertex3f(-0.3f, y, 1);
        glVertex3f(1, y, -2);
        glVertex3f(-0.1f, y + 0.4f, -1);
        glEnd();
    }
}
