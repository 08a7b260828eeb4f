// Generated texture coordinates, several units, combined environments and 1D textures
// (OpenGL 1.5, 2.11.4, 3.8).

#define GL_GLEXT_PROTOTYPES
#include "scenes/common.h"

#include <vector>

using namespace oracle;

namespace {

void filters(GLenum target)
{
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

/// Binds a new checker of two colours, with alpha.
void checker(GLubyte r, GLubyte g, GLubyte b, int cells)
{
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    filters(GL_TEXTURE_2D);
    std::vector<GLubyte> pixels;
    for (int i = 0; i < 16 * 16; ++i) {
        const bool dark = (i % 16 / cells + i / 16 / cells) % 2 != 0;
        for (GLubyte c : {r, g, b}) {
            pixels.push_back(dark ? static_cast<GLubyte>(c / 4) : c);
        }
        pixels.push_back(dark ? 90 : 230);
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glEnable(GL_TEXTURE_2D);
}

void square(float x, float y)
{
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glMultiTexCoord2f(GL_TEXTURE0, i % 2 ? 2.0f : 0.0f, i / 2 ? 2.0f : 0.0f);
        glMultiTexCoord2f(GL_TEXTURE1, i % 2 ? 1.0f : 0.3f, i / 2 ? 0.9f : 0.1f);
        glVertex2f(x + (i % 2 ? 3.5f : 0), y + (i / 2 ? 3.5f : 0));
    }
    glEnd();
}

void generate(GLenum coordinate, GLenum capability, GLenum mode)
{
    glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, static_cast<GLint>(mode));
    glEnable(capability);
}

} // namespace

SCENE(texgen_object_linear)
{
    three_dimensions();
    checker(250, 200, 60, 4);
    generate(GL_S, GL_TEXTURE_GEN_S, GL_OBJECT_LINEAR);
    generate(GL_T, GL_TEXTURE_GEN_T, GL_OBJECT_LINEAR);
    const GLfloat plane[] = {0.5f, 1, 0.3f, 0.1f};
    glTexGenfv(GL_S, GL_OBJECT_PLANE, plane);
    glRotatef(40, 1, 0.3f, 0);
    torus(1.3f, 0.5f, 12, 24);
}

SCENE(texgen_eye_linear)
{
    three_dimensions();
    checker(60, 200, 250, 4);
    generate(GL_S, GL_TEXTURE_GEN_S, GL_EYE_LINEAR);
    generate(GL_T, GL_TEXTURE_GEN_T, GL_EYE_LINEAR);
    const GLdouble plane[] = {0.7, 0, 0.7, 0};
    glTexGendv(GL_T, GL_EYE_PLANE, plane);
    glRotatef(40, 1, 0.3f, 0);
    torus(1.3f, 0.5f, 12, 24);
}

SCENE(texgen_sphere_map_lit)
{
    three_dimensions();
    checker(220, 220, 220, 8);
    generate(GL_S, GL_TEXTURE_GEN_S, GL_SPHERE_MAP);
    generate(GL_T, GL_TEXTURE_GEN_T, GL_SPHERE_MAP);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glRotatef(40, 1, 0.3f, 0);
    torus(1.3f, 0.5f, 12, 24);
}

SCENE(texgen_sphere_map_unlit_normalized)
{
    three_dimensions();
    checker(220, 120, 220, 8);
    glEnable(GL_NORMALIZE);
    generate(GL_S, GL_TEXTURE_GEN_S, GL_SPHERE_MAP);
    generate(GL_T, GL_TEXTURE_GEN_T, GL_SPHERE_MAP);
    glRotatef(70, 1, 0.3f, 0);
    glScalef(1, 2, 1);
    torus(1.1f, 0.4f, 12, 24);
}

SCENE(two_units)
{
    two_dimensions();
    checker(250, 120, 60, 4);
    glActiveTexture(GL_TEXTURE1);
    checker(80, 250, 200, 8);
    const GLenum modes[] = {GL_MODULATE, GL_ADD, GL_REPLACE, GL_DECAL, GL_BLEND};
    for (int i = 0; i < 5; ++i) {
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(modes[i]));
        square(0.2f + 4 * static_cast<float>(i % 4), 0.2f + 4 * static_cast<float>(i / 4));
    }
    glMatrixMode(GL_TEXTURE);
    glScalef(3, 1, 1);
    glMatrixMode(GL_MODELVIEW);
    square(4.2f, 4.2f);
    glActiveTexture(GL_TEXTURE0);
    glDisable(GL_TEXTURE_2D);
    square(8.2f, 4.2f);
}

SCENE(combine_functions)
{
    two_dimensions();
    checker(250, 120, 60, 4);
    const GLenum functions[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                                GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
    const GLfloat constant[] = {0.3f, 0.7f, 0.5f, 0.4f};
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
    glColor4f(0.8f, 0.5f, 0.9f, 0.7f);
    for (int i = 0; i < 8; ++i) {
        glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, static_cast<GLint>(functions[i]));
        square(0.2f + 4 * static_cast<float>(i % 4), 0.2f + 4 * static_cast<float>(i / 4));
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_PRIMARY_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, GL_ONE_MINUS_SRC_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE2_RGB, GL_TEXTURE);
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);
    square(0.2f, 8.2f);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_SUBTRACT);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    square(4.2f, 8.2f);
}

SCENE(one_dimensional_texture)
{
    two_dimensions();
    filters(GL_TEXTURE_1D);
    GLubyte pixels[32][3];
    for (int i = 0; i < 32; ++i) {
        pixels[i][0] = static_cast<GLubyte>(8 * i);
        pixels[i][1] = i % 4 < 2 ? 200 : 60;
        pixels[i][2] = static_cast<GLubyte>(255 - 8 * i);
    }
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    glEnable(GL_TEXTURE_1D);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glTexCoord2f(i % 2 ? 1.7f : -0.4f, i / 2 ? 5.0f : 0.0f);
        glVertex2f(i % 2 ? 15.0f : 1.0f, i / 2 ? 11.0f : 1.0f);
    }
    glEnd();
}

// The alpha that GL_DOT3_RGBA makes has the scale of alpha, not that of the colours.
SCENE(texture_environment_dot_product_scales)
{
    two_dimensions();
    checker(250, 120, 200, 4);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glColor4f(0.7f, 0.6f, 0.65f, 0.7f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < 8; ++i) {
        glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, i < 4 ? GL_DOT3_RGBA : GL_DOT3_RGB);
        glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, i & 1 ? 4 : 1);
        glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, i & 2 ? 2 : 1);
        square(0.2f + 4 * static_cast<float>(i % 4), 0.2f + 4 * static_cast<float>(i / 4));
    }
}
