// Wrap modes that show a border, borders of images, and levels that are left out (OpenGL 1.5, 3.8.7
// and 3.8.8).

#define GL_GLEXT_PROTOTYPES
#include "scenes/texture_images.h"

#include "scenes/common.h"

#include <vector>

using namespace oracle;

SCENE(texture_clamp_shows_the_border_colour)
{
    two_dimensions();
    glEnable(GL_TEXTURE_2D);
    const GLfloat border[] = {0.9f, 0.1f, 0.3f, 0.6f};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    int i = 0;
    for (GLint format : {GL_RGBA, GL_LUMINANCE, GL_RGB}) {
        glTexImage2D(GL_TEXTURE_2D, 0, format, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, noise(64).data());
        for (GLenum wrap : {GL_CLAMP, GL_CLAMP_TO_BORDER}) {
            for (GLenum filter : {GL_NEAREST, GL_LINEAR}) {
                parameters(filter, wrap);
                quad(4 * static_cast<float>(i % 4) + 0.1f, 4 * static_cast<float>(i / 4) + 0.1f, 3.8f, 3.8f,
                     -0.4f, 1.4f);
                ++i;
            }
        }
    }
}

SCENE(texture_clamp_in_one_coordinate_and_dimension)
{
    two_dimensions();
    glEnable(GL_TEXTURE_2D);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, noise(64).data());
    parameters(GL_LINEAR, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    quad(0.2f, 0.2f, 7, 5, -0.5f, 1.5f);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);
    quad(8, 0.2f, 7, 5, -0.5f, 1.5f);
    glDisable(GL_TEXTURE_2D);
    glEnable(GL_TEXTURE_1D);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, noise(16).data());
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    quad(0.2f, 6, 7, 5, -0.5f, 1.5f);
}

SCENE(texture_clamp_with_mipmaps, {4, "the border's weight at the change of levels"})
{
    three_dimensions();
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    std::vector<GLubyte> pixels(64 * 64 * 3);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i] = static_cast<GLubyte>(i / 3 % 64 * 2 + i / 192 * 2);
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    glRotatef(30, 1, 1, 0);
    cube();
}

SCENE(texture_borders_are_dropped)
{
    two_dimensions();
    glEnable(GL_TEXTURE_2D);
    parameters(GL_LINEAR, GL_CLAMP);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 10, 6, 1, GL_RGB, GL_UNSIGNED_BYTE, noise(400).data());
    tell_level(GL_TEXTURE_2D, 0);
    quad(0.2f, 0.2f, 7, 5, -0.2f, 1.2f);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 10, 1, GL_RGB, GL_UNSIGNED_BYTE, noise(30).data());
    tell_level(GL_TEXTURE_1D, 0);
    glDisable(GL_TEXTURE_2D);
    glEnable(GL_TEXTURE_1D);
    quad(8, 0.2f, 7, 5);
    glDisable(GL_TEXTURE_1D);
    glEnable(GL_TEXTURE_2D);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 10, 10, 34, 18, 1);
    tell_level(GL_TEXTURE_2D, 0);
    quad(0.2f, 6, 7, 5);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 10, 6, 2, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    tell_error("border of 2");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 6, 1, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    tell_error("nothing but border");
}

SCENE(texture_levels_between_base_and_maximum)
{
    three_dimensions();
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 3);
    for (int level = 1, size = 32; level < 4; ++level, size /= 2) {
        const std::vector<GLubyte> pixels(static_cast<std::size_t>(size) * size,
                                          static_cast<GLubyte>(60 * level));
        glTexImage2D(GL_TEXTURE_2D, level, GL_LUMINANCE, size, size, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                     pixels.data());
    }
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glTexCoord2f(i % 2 ? 6.0f : 0.0f, i / 2 ? 9.0f : 0.0f);
        glVertex3f(i % 2 ? 3.0f : -3.0f, -0.8f, i / 2 ? -12.0f : 3.0f);
    }
    glEnd();
}
