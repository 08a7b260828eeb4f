// Queries of every kind (OpenGL 1.5, 6.1): initial values, conversions, and the objects that have queries of
// their own.

#define GL_GLEXT_PROTOTYPES
#include "scenes/queries.h"

#include "scenes/common.h"

#include <vector>

using namespace oracle;

namespace {

template <class T> std::string joined(const std::vector<T>& values)
{
    std::string text;
    for (const T& v : values) {
        text += " " + std::to_string(v);
    }
    return text;
}

/// Asks a light, material … for a parameter with floats and integers and tells both.
template <class GetFloats, class GetIntegers>
void tell_parameter(const std::string& what, int count, GetFloats floats, GetIntegers integers)
{
    std::vector<GLfloat> f(static_cast<std::size_t>(count), -7.0f);
    std::vector<GLint> i(static_cast<std::size_t>(count), -7);
    floats(f.data());
    integers(i.data());
    tell_error(what + joined(f) + " |" + joined(i));
}

/// As floats only: Mesa spreads a matrix's values over all integers, as if they were colours; the
/// specification rounds them (OpenGL 1.5, 6.1.2).
void tell_matrix(GLenum name)
{
    GLfloat m[16] = {};
    GLdouble d[16] = {};
    glGetFloatv(name, m);
    glGetDoublev(name, d);
    tell(joined(std::vector<GLfloat>(m, m + 16)) + joined(std::vector<GLdouble>(d, d + 16)));
}

void tell_light(GLenum light)
{
    const GLenum names[] = {GL_AMBIENT,
                            GL_DIFFUSE,
                            GL_SPECULAR,
                            GL_POSITION,
                            GL_SPOT_DIRECTION,
                            GL_SPOT_CUTOFF,
                            GL_SPOT_EXPONENT,
                            GL_CONSTANT_ATTENUATION,
                            GL_LINEAR_ATTENUATION,
                            GL_QUADRATIC_ATTENUATION};
    const int counts[] = {4, 4, 4, 4, 3, 1, 1, 1, 1, 1};
    for (int n = 0; n < 10; ++n) {
        tell_parameter(
            "light " + std::to_string(names[n]), counts[n],
            [&](GLfloat* v) { glGetLightfv(light, names[n], v); },
            [&](GLint* v) { glGetLightiv(light, names[n], v); });
    }
}

void tell_material(GLenum face)
{
    for (GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES}) {
        tell_parameter(
            "material " + std::to_string(name),
            name == GL_SHININESS       ? 1
            : name == GL_COLOR_INDEXES ? 3
                                       : 4,
            [&](GLfloat* v) { glGetMaterialfv(face, name, v); },
            [&](GLint* v) { glGetMaterialiv(face, name, v); });
    }
}

void tell_environment()
{
    for (GLenum name : {GL_TEXTURE_ENV_MODE, GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SOURCE0_RGB, GL_SOURCE1_RGB,
                        GL_SOURCE2_RGB, GL_SOURCE0_ALPHA, GL_SOURCE1_ALPHA, GL_SOURCE2_ALPHA, GL_OPERAND0_RGB,
                        GL_OPERAND1_RGB, GL_OPERAND2_RGB, GL_OPERAND0_ALPHA, GL_OPERAND1_ALPHA,
                        GL_OPERAND2_ALPHA, GL_RGB_SCALE, GL_ALPHA_SCALE, GL_TEXTURE_ENV_COLOR}) {
        tell_parameter(
            "environment " + std::to_string(name), name == GL_TEXTURE_ENV_COLOR ? 4 : 1,
            [&](GLfloat* v) { glGetTexEnvfv(GL_TEXTURE_ENV, static_cast<GLenum>(name), v); },
            [&](GLint* v) { glGetTexEnviv(GL_TEXTURE_ENV, static_cast<GLenum>(name), v); });
    }
}

void tell_generation()
{
    for (GLenum coordinate : {GL_S, GL_T, GL_R, GL_Q}) {
        for (GLenum name : {GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE, GL_EYE_PLANE}) {
            const int count = name == GL_TEXTURE_GEN_MODE ? 1 : 4;
            tell_parameter(
                "generation " + std::to_string(coordinate) + " " + std::to_string(name), count,
                [&](GLfloat* v) { glGetTexGenfv(coordinate, name, v); },
                [&](GLint* v) { glGetTexGeniv(coordinate, name, v); });
            GLdouble doubles[4] = {};
            glGetTexGendv(coordinate, name, doubles);
            tell(joined(std::vector<GLdouble>(doubles, doubles + count)));
        }
    }
}

} // namespace

SCENE(queries_of_initial_state)
{
    TELL_STATE(GL_CURRENT_COLOR, 4);
    TELL_STATE(GL_CURRENT_NORMAL, 3);
    TELL_STATE(GL_CURRENT_TEXTURE_COORDS, 4);
    TELL_STATE(GL_CURRENT_SECONDARY_COLOR, 4);
    TELL_STATE(GL_CURRENT_FOG_COORDINATE, 1);
    TELL_STATE(GL_CURRENT_INDEX, 1);
    tell_matrix(GL_MODELVIEW_MATRIX);
    tell_matrix(GL_PROJECTION_MATRIX);
    tell_matrix(GL_TEXTURE_MATRIX);
    tell_matrix(GL_TRANSPOSE_MODELVIEW_MATRIX);
    TELL_STATE(GL_MODELVIEW_STACK_DEPTH, 1);
    TELL_STATE(GL_PROJECTION_STACK_DEPTH, 1);
    TELL_STATE(GL_TEXTURE_STACK_DEPTH, 1);
    TELL_STATE(GL_MATRIX_MODE, 1);
    TELL_STATE(GL_DEPTH_RANGE, 2);
    TELL_STATE(GL_NORMALIZE, 1);
    TELL_STATE(GL_FOG, 1);
    TELL_STATE(GL_FOG_COLOR, 4);
    TELL_STATE(GL_FOG_INDEX, 1);
    TELL_STATE(GL_FOG_DENSITY, 1);
    TELL_STATE(GL_FOG_START, 1);
    TELL_STATE(GL_FOG_END, 1);
    TELL_STATE(GL_FOG_MODE, 1);
    TELL_STATE(GL_FOG_COORDINATE_SOURCE, 1);
    TELL_STATE(GL_SHADE_MODEL, 1);
    TELL_STATE(GL_LIGHTING, 1);
    TELL_STATE(GL_COLOR_MATERIAL, 1);
    TELL_STATE(GL_COLOR_MATERIAL_PARAMETER, 1);
    TELL_STATE(GL_COLOR_MATERIAL_FACE, 1);
    TELL_STATE(GL_LIGHT_MODEL_AMBIENT, 4);
    TELL_STATE(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    TELL_STATE(GL_LIGHT_MODEL_TWO_SIDE, 1);
    TELL_STATE(GL_LIGHT_MODEL_COLOR_CONTROL, 1);
    TELL_STATE(GL_POINT_SIZE, 1);
    TELL_STATE(GL_LINE_WIDTH, 1);
    TELL_STATE(GL_CULL_FACE_MODE, 1);
    TELL_STATE(GL_FRONT_FACE, 1);
    TELL_STATE(GL_POLYGON_OFFSET_FACTOR, 1);
    TELL_STATE(GL_POLYGON_OFFSET_UNITS, 1);
    TELL_STATE(GL_MULTISAMPLE, 1);
    TELL_STATE(GL_SAMPLE_COVERAGE_VALUE, 1);
    TELL_STATE(GL_SAMPLE_COVERAGE_INVERT, 1);
    TELL_STATE(GL_TEXTURE_1D, 1);
    TELL_STATE(GL_TEXTURE_BINDING_1D, 1);
    TELL_STATE(GL_TEXTURE_BINDING_2D, 1);
    TELL_STATE(GL_ACTIVE_TEXTURE, 1);
    TELL_STATE(GL_CLIENT_ACTIVE_TEXTURE, 1);
    TELL_STATE(GL_SCISSOR_TEST, 1);
    TELL_STATE(GL_ALPHA_TEST, 1);
    TELL_STATE(GL_ALPHA_TEST_FUNC, 1);
    TELL_STATE(GL_ALPHA_TEST_REF, 1);
    TELL_STATE(GL_STENCIL_TEST, 1);
    TELL_STATE(GL_STENCIL_FUNC, 1);
    TELL_STATE(GL_STENCIL_REF, 1);
    TELL_STATE(GL_STENCIL_FAIL, 1);
    TELL_STATE(GL_STENCIL_PASS_DEPTH_FAIL, 1);
    TELL_STATE(GL_STENCIL_PASS_DEPTH_PASS, 1);
    TELL_STATE(GL_DEPTH_TEST, 1);
    TELL_STATE(GL_DEPTH_FUNC, 1);
    TELL_STATE(GL_BLEND, 1);
    TELL_STATE(GL_BLEND_SRC, 1);
    TELL_STATE(GL_BLEND_DST, 1);
    TELL_STATE(GL_BLEND_EQUATION, 1);
    TELL_STATE(GL_BLEND_COLOR, 4);
    TELL_STATE(GL_DITHER, 1);
    TELL_STATE(GL_COLOR_WRITEMASK, 4);
    TELL_STATE(GL_DEPTH_WRITEMASK, 1);
    TELL_STATE(GL_STENCIL_WRITEMASK, 1);
    TELL_STATE(GL_STENCIL_VALUE_MASK, 1);
    TELL_STATE(GL_COLOR_CLEAR_VALUE, 4);
    TELL_STATE(GL_DEPTH_CLEAR_VALUE, 1);
    TELL_STATE(GL_STENCIL_CLEAR_VALUE, 1);
    TELL_STATE(GL_ACCUM_CLEAR_VALUE, 4);
    TELL_STATE(GL_INDEX_CLEAR_VALUE, 1);
    TELL_STATE(GL_PERSPECTIVE_CORRECTION_HINT, 1);
    TELL_STATE(GL_UNPACK_ALIGNMENT, 1);
    TELL_STATE(GL_PACK_SWAP_BYTES, 1);
    TELL_STATE(GL_LIST_BASE, 1);
    TELL_STATE(GL_LIST_INDEX, 1);
    TELL_STATE(GL_LIST_MODE, 1);
    TELL_STATE(GL_ATTRIB_STACK_DEPTH, 1);
    TELL_STATE(GL_MAX_LIGHTS, 1);
    TELL_STATE(GL_MAX_LIST_NESTING, 1);
    TELL_STATE(GL_MAX_MODELVIEW_STACK_DEPTH, 1);
    TELL_STATE(GL_MAX_PROJECTION_STACK_DEPTH, 1);
    TELL_STATE(GL_RGBA_MODE, 1);
    TELL_STATE(GL_INDEX_MODE, 1);
    TELL_STATE(GL_RENDER_MODE, 1);
    TELL_STATE(GL_STEREO, 1);
    TELL_STATE(GL_AUX_BUFFERS, 1);
    TELL_STATE(GL_RED_BITS, 1);
    TELL_STATE(GL_ALPHA_BITS, 1);
    TELL_STATE(GL_DEPTH_BITS, 1);
    TELL_STATE(GL_STENCIL_BITS, 1);
    TELL_STATE(GL_INDEX_BITS, 1);
    TELL_STATE(GL_ACCUM_RED_BITS, 1);
    TELL_STATE(GL_SAMPLES, 1);
    TELL_STATE(GL_SAMPLE_BUFFERS, 1);
    TELL_STATE(GL_VERTEX_ARRAY, 1);
    TELL_STATE(GL_VERTEX_ARRAY_SIZE, 1);
    TELL_STATE(GL_NORMAL_ARRAY_TYPE, 1);
    TELL_STATE(GL_SECONDARY_COLOR_ARRAY_SIZE, 1);
    TELL_STATE(GL_COLOR_ARRAY_SIZE, 1);
    TELL_STATE(GL_TEXTURE_COORD_ARRAY_STRIDE, 1);
    TELL_STATE(GL_EDGE_FLAG_ARRAY_STRIDE, 1);
    TELL_STATE(GL_ARRAY_BUFFER_BINDING, 1);
    TELL_STATE(GL_MAX_ELEMENTS_VERTICES + 0x10000, 1);
}

SCENE(queries_convert)
{
    glColor4f(0.3f, -0.5f, 1, 0.123456f);
    TELL_STATE(GL_CURRENT_COLOR, 4);
    glNormal3f(-1, 0.25f, 1);
    TELL_STATE(GL_CURRENT_NORMAL, 3);
    glTexCoord4f(0.5f, -0.5f, 1.5f, 1234.56f);
    TELL_STATE(GL_CURRENT_TEXTURE_COORDS, 4);
    glClearColor(0.1f, 0.2f, 0.9f, 1);
    TELL_STATE(GL_COLOR_CLEAR_VALUE, 4);
    glClearDepth(0.1);
    TELL_STATE(GL_DEPTH_CLEAR_VALUE, 1);
    glDepthRange(0.25, 0.75);
    TELL_STATE(GL_DEPTH_RANGE, 2);
    glFogf(GL_FOG_START, 2.5f);
    TELL_STATE(GL_FOG_START, 1);
    glFogf(GL_FOG_END, -3.5f);
    TELL_STATE(GL_FOG_END, 1);
    glStencilMask(0xfffffff0);
    TELL_STATE(GL_STENCIL_WRITEMASK, 1);
    glStencilFunc(GL_LESS, -3, 0xf0f0f0f0);
    TELL_STATE(GL_STENCIL_REF, 1);
    TELL_STATE(GL_STENCIL_VALUE_MASK, 1);
    glClearStencil(-5);
    TELL_STATE(GL_STENCIL_CLEAR_VALUE, 1);
    glAlphaFunc(GL_LESS, 0.3f);
    TELL_STATE(GL_ALPHA_TEST_REF, 1);
    glTranslatef(0.4f, 0.6f, -1.5f);
    glScalef(2, 3, 0);
    tell_matrix(GL_MODELVIEW_MATRIX);
    tell_matrix(GL_TRANSPOSE_MODELVIEW_MATRIX);
    glLineWidth(2.5f);
    TELL_STATE(GL_LINE_WIDTH, 1);
}

SCENE(queries_of_lights_and_materials)
{
    tell_light(GL_LIGHT0);
    tell_light(GL_LIGHT7);
    tell_material(GL_FRONT);
    const GLfloat color[] = {0.25f, -0.5f, 1, 0.75f};
    const GLint integers[] = {2147483647, 0, -2147483647, 1000000000};
    // Whole numbers where they are asked as integers: Mesa cuts off what the specification rounds.
    const GLfloat place[] = {2, -3, 4, 1};
    glTranslatef(1, 2, 3);
    glRotatef(90, 0, 0, 1);
    glLightfv(GL_LIGHT3, GL_AMBIENT, color);
    glLightiv(GL_LIGHT3, GL_DIFFUSE, integers);
    glLightfv(GL_LIGHT3, GL_POSITION, place);
    glLightfv(GL_LIGHT3, GL_SPOT_DIRECTION, place);
    glLightf(GL_LIGHT3, GL_SPOT_CUTOFF, 45);
    glLighti(GL_LIGHT3, GL_SPOT_EXPONENT, 12);
    glLightf(GL_LIGHT3, GL_LINEAR_ATTENUATION, 3);
    tell_light(GL_LIGHT3);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, color);
    glMaterialiv(GL_BACK, GL_SPECULAR, integers);
    glMaterialf(GL_BACK, GL_SHININESS, 12.5f);
    tell_material(GL_FRONT);
    tell_material(GL_BACK);
    glColorMaterial(GL_FRONT, GL_EMISSION);
    glEnable(GL_COLOR_MATERIAL);
    glColor4f(0.5f, 0.25f, 0.125f, 1);
    tell_material(GL_FRONT);
    GLfloat none[4] = {};
    glGetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, none);
    tell_error("both faces");
    glGetMaterialfv(GL_FRONT, GL_POSITION, none);
    tell_error("no material's");
    glGetLightfv(GL_LIGHT0 + 100, GL_AMBIENT, none);
    tell_error("no light");
    glGetLightfv(GL_LIGHT0, GL_SHININESS, none);
    tell_error("no light's");
}

SCENE(queries_of_texture_units)
{
    tell_environment();
    tell_generation();
    glActiveTexture(GL_TEXTURE1);
    const GLfloat color[] = {0.25f, -0.5f, 1, 0.75f};
    const GLint plane[] = {1, -2, 3, 4};
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_ALPHA, GL_TEXTURE0);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGeniv(GL_T, GL_OBJECT_PLANE, plane);
    glTranslatef(1, 2, 3);
    glTexGeniv(GL_R, GL_EYE_PLANE, plane);
    tell_environment();
    tell_generation();
    GLfloat none[4] = {};
    glGetTexEnvfv(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, none);
    tell_error("no environment");
    glGetTexEnvfv(GL_TEXTURE_ENV, GL_AMBIENT, none);
    tell_error("no environment's");
    glGetTexGenfv(GL_TEXTURE_2D, GL_EYE_PLANE, none);
    tell_error("no coordinate");
    glGetTexGenfv(GL_S, GL_AMBIENT, none);
    tell_error("no generation's");
}

SCENE(queries_inside_begin_and_end_are_errors)
{
    GLfloat v[16] = {5};
    GLint i[4] = {6};
    glBegin(GL_TRIANGLES);
    glGetFloatv(GL_LINE_WIDTH, v);
    glGetIntegerv(GL_MATRIX_MODE, i);
    glGetLightfv(GL_LIGHT0, GL_AMBIENT, v);
    glIsEnabled(GL_LIGHTING);
    glEnd();
    tell(std::to_string(v[0]) + " " + std::to_string(i[0]));
    tell_error("inside");
}
