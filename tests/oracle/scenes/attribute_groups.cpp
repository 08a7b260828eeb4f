// glPushAttrib and glPopAttrib: what each group saves (OpenGL 1.5, 6.1.14 and tables 6.5 to 6.21).

#define GL_GLEXT_PROTOTYPES
#include "scenes/queries.h"

#include "scenes/common.h"

#include <vector>

using namespace oracle;

namespace {

/// GL_ALL_ATTRIB_BITS of OpenGL 1.3 and newer; Emscripten's <GL/gl.h> has that of 1.2, without
/// GL_MULTISAMPLE_BIT.
constexpr GLbitfield ALL_GROUPS = 0xffffffff;

struct Variable
{
    GLenum name;
    int count;
};

/// What a group may save, by the names of glGet.
const std::vector<Variable>& variables()
{
    static const std::vector<Variable> all = {{GL_CURRENT_COLOR, 4},
                                              {GL_CURRENT_NORMAL, 3},
                                              {GL_CURRENT_TEXTURE_COORDS, 4},
                                              {GL_CURRENT_SECONDARY_COLOR, 4},
                                              {GL_CURRENT_FOG_COORDINATE, 1},
                                              {GL_CURRENT_INDEX, 1},
                                              {GL_POINT_SIZE, 1},
                                              {GL_LINE_WIDTH, 1},
                                              {GL_CULL_FACE, 1},
                                              {GL_CULL_FACE_MODE, 1},
                                              {GL_FRONT_FACE, 1},
                                              {GL_POLYGON_OFFSET_FACTOR, 1},
                                              {GL_POLYGON_OFFSET_UNITS, 1},
                                              {GL_POLYGON_OFFSET_FILL, 1},
                                              {GL_POLYGON_OFFSET_LINE, 1},
                                              {GL_POLYGON_OFFSET_POINT, 1},
                                              {GL_SHADE_MODEL, 1},
                                              {GL_LIGHTING, 1},
                                              {GL_COLOR_MATERIAL, 1},
                                              {GL_COLOR_MATERIAL_FACE, 1},
                                              {GL_COLOR_MATERIAL_PARAMETER, 1},
                                              {GL_LIGHT_MODEL_AMBIENT, 4},
                                              {GL_LIGHT_MODEL_LOCAL_VIEWER, 1},
                                              {GL_LIGHT_MODEL_TWO_SIDE, 1},
                                              {GL_LIGHT_MODEL_COLOR_CONTROL, 1},
                                              {GL_LIGHT0, 1},
                                              {GL_LIGHT5, 1},
                                              {GL_FOG, 1},
                                              {GL_FOG_MODE, 1},
                                              {GL_FOG_COLOR, 4},
                                              {GL_FOG_DENSITY, 1},
                                              {GL_FOG_START, 1},
                                              {GL_FOG_END, 1},
                                              {GL_FOG_INDEX, 1},
                                              {GL_FOG_COORDINATE_SOURCE, 1},
                                              {GL_COLOR_SUM, 1},
                                              {GL_DEPTH_TEST, 1},
                                              {GL_DEPTH_FUNC, 1},
                                              {GL_DEPTH_WRITEMASK, 1},
                                              {GL_DEPTH_CLEAR_VALUE, 1},
                                              {GL_ACCUM_CLEAR_VALUE, 4},
                                              {GL_STENCIL_TEST, 1},
                                              {GL_STENCIL_FUNC, 1},
                                              {GL_STENCIL_REF, 1},
                                              {GL_STENCIL_VALUE_MASK, 1},
                                              {GL_STENCIL_WRITEMASK, 1},
                                              {GL_STENCIL_FAIL, 1},
                                              {GL_STENCIL_PASS_DEPTH_FAIL, 1},
                                              {GL_STENCIL_PASS_DEPTH_PASS, 1},
                                              {GL_STENCIL_CLEAR_VALUE, 1},
                                              {GL_VIEWPORT, 4},
                                              {GL_DEPTH_RANGE, 2},
                                              {GL_MATRIX_MODE, 1},
                                              {GL_NORMALIZE, 1},
                                              {GL_RESCALE_NORMAL, 1},
                                              {GL_ALPHA_TEST, 1},
                                              {GL_ALPHA_TEST_FUNC, 1},
                                              {GL_ALPHA_TEST_REF, 1},
                                              {GL_BLEND, 1},
                                              {GL_BLEND_SRC, 1},
                                              {GL_BLEND_DST, 1},
                                              {GL_BLEND_SRC_RGB, 1},
                                              {GL_BLEND_DST_RGB, 1},
                                              {GL_BLEND_SRC_ALPHA, 1},
                                              {GL_BLEND_DST_ALPHA, 1},
                                              {GL_BLEND_EQUATION, 1},
                                              {GL_BLEND_COLOR, 4},
                                              {GL_DITHER, 1},
                                              {GL_COLOR_WRITEMASK, 4},
                                              {GL_COLOR_CLEAR_VALUE, 4},
                                              {GL_INDEX_WRITEMASK, 1},
                                              {GL_INDEX_CLEAR_VALUE, 1},
                                              {GL_PERSPECTIVE_CORRECTION_HINT, 1},
                                              {GL_POINT_SMOOTH_HINT, 1},
                                              {GL_LINE_SMOOTH_HINT, 1},
                                              {GL_POLYGON_SMOOTH_HINT, 1},
                                              {GL_FOG_HINT, 1},
                                              {GL_GENERATE_MIPMAP_HINT, 1},
                                              {GL_TEXTURE_COMPRESSION_HINT, 1},
                                              {GL_LIST_BASE, 1},
                                              {GL_TEXTURE_1D, 1},
                                              {GL_TEXTURE_2D, 1},
                                              {GL_TEXTURE_GEN_S, 1},
                                              {GL_TEXTURE_GEN_Q, 1},
                                              {GL_TEXTURE_BINDING_2D, 1},
                                              {GL_ACTIVE_TEXTURE, 1},
                                              {GL_SCISSOR_TEST, 1},
                                              {GL_SCISSOR_BOX, 4},
                                              {GL_MULTISAMPLE, 1},
                                              {GL_SAMPLE_ALPHA_TO_COVERAGE, 1},
                                              {GL_SAMPLE_ALPHA_TO_ONE, 1},
                                              {GL_SAMPLE_COVERAGE, 1},
                                              {GL_SAMPLE_COVERAGE_VALUE, 1},
                                              {GL_SAMPLE_COVERAGE_INVERT, 1}};
    return all;
}

/// Capabilities that set_everything() switches.
constexpr GLenum CAPABILITIES[] = {GL_CULL_FACE,
                                   GL_POLYGON_OFFSET_FILL,
                                   GL_POLYGON_OFFSET_LINE,
                                   GL_POLYGON_OFFSET_POINT,
                                   GL_LIGHTING,
                                   GL_LIGHT0,
                                   GL_LIGHT5,
                                   GL_FOG,
                                   GL_COLOR_SUM,
                                   GL_DEPTH_TEST,
                                   GL_STENCIL_TEST,
                                   GL_NORMALIZE,
                                   GL_RESCALE_NORMAL,
                                   GL_ALPHA_TEST,
                                   GL_BLEND,
                                   GL_DITHER,
                                   GL_SCISSOR_TEST,
                                   GL_MULTISAMPLE,
                                   GL_SAMPLE_ALPHA_TO_COVERAGE,
                                   GL_SAMPLE_ALPHA_TO_ONE,
                                   GL_SAMPLE_COVERAGE};

void set_units(bool b)
{
    for (int unit = 0; unit < 2; ++unit) {
        const bool on = b != (unit == 1);
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (GLenum capability : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_Q}) {
            on ? glEnable(capability) : glDisable(capability);
        }
        glBindTexture(GL_TEXTURE_2D, on ? 2 : 1);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, on ? GL_NEAREST : GL_LINEAR);
    }
    glActiveTexture(b ? GL_TEXTURE1 : GL_TEXTURE0);
}

void set_fragments(bool b)
{
    glDepthFunc(b ? GL_GREATER : GL_LEQUAL);
    glDepthMask(b);
    glClearDepth(b ? 0.1 : 0.7);
    glClearAccum(b ? 0.25f : -0.5f, 0.5f, 0.75f, b ? 1.0f : 0.0f);
    glStencilFunc(b ? GL_LESS : GL_EQUAL, b ? 3 : 5, b ? 0xff : 0x0f);
    glStencilMask(b ? 0x33 : 0xcc);
    glStencilOp(b ? GL_ZERO : GL_INCR, b ? GL_REPLACE : GL_DECR, b ? GL_INVERT : GL_KEEP);
    glClearStencil(b ? 7 : 9);
    glAlphaFunc(b ? GL_LESS : GL_GREATER, b ? 0.25f : 0.75f);
    glBlendFuncSeparate(b ? GL_ONE : GL_ZERO, b ? GL_SRC_COLOR : GL_DST_ALPHA, b ? GL_ZERO : GL_ONE,
                        b ? GL_SRC_ALPHA : GL_ZERO);
    glBlendEquation(b ? GL_FUNC_SUBTRACT : GL_MAX);
    glBlendColor(b, 0.5f, 0.25f, !b);
    glColorMask(b, !b, b, GL_TRUE);
    glClearColor(b ? 0.5f : 0.75f, b, 0.25f, 1);
    glClearIndex(b ? 3.0f : 5.0f);
    glIndexMask(b ? 0x5 : 0xa);
    glScissor(b, 2, b ? 30 : 40, 50);
    glSampleCoverage(b ? 0.5f : 0.25f, b);
}

void set_lighting(bool b)
{
    const GLfloat ambient[] = {b ? 0.5f : 0.25f, 0.5f, 1, b ? 0.0f : 1.0f};
    glShadeModel(b ? GL_FLAT : GL_SMOOTH);
    glDisable(GL_COLOR_MATERIAL);
    glColorMaterial(b ? GL_FRONT : GL_BACK, b ? GL_SPECULAR : GL_EMISSION);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, b);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, !b);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, b ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    glLightfv(GL_LIGHT5, GL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT, GL_SPECULAR, ambient);
    glFogi(GL_FOG_MODE, b ? GL_LINEAR : GL_EXP2);
    glFogfv(GL_FOG_COLOR, ambient);
    glFogf(GL_FOG_DENSITY, b ? 0.5f : 2.5f);
    glFogf(GL_FOG_START, b ? 3.0f : 4.0f);
    glFogf(GL_FOG_END, b ? 5.0f : 6.0f);
    glFogf(GL_FOG_INDEX, b ? 7.0f : 8.0f);
    glFogi(GL_FOG_COORDINATE_SOURCE, b ? GL_FOG_COORDINATE : GL_FRAGMENT_DEPTH);
}

/// Sets all of it to one of two sets of values, the same or not as before in no variable.
void set_everything(bool b)
{
    for (GLenum capability : CAPABILITIES) {
        b ? glEnable(capability) : glDisable(capability);
    }
    set_lighting(b);
    set_fragments(b);
    set_units(b);
    glColor4f(b ? 1.0f : 0.5f, 0.25f, b ? 0.0f : 2.0f, 1);
    glNormal3f(b, 0.5f, -1);
    glMultiTexCoord4f(GL_TEXTURE0, b, 2, 3, 4);
    glMultiTexCoord4f(GL_TEXTURE1, 5, b, 7, 8);
    glSecondaryColor3f(b, 0.5f, 0.75f);
    glFogCoordf(b ? 2.5f : 3.5f);
    glIndexi(b ? 3 : 4);
    glPointSize(b ? 3.0f : 5.5f);
    glLineWidth(b ? 2.0f : 4.5f);
    glCullFace(b ? GL_FRONT : GL_BACK);
    glFrontFace(b ? GL_CW : GL_CCW);
    glPolygonOffset(b ? 1.5f : 2.0f, b ? 3.0f : 4.0f);
    glMatrixMode(b ? GL_TEXTURE : GL_MODELVIEW);
    glViewport(b, 1, b ? 60 : 70, 80);
    glDepthRange(b ? 0.25 : 0.5, b ? 1.0 : 0.75);
    for (GLenum hint :
         {GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT,
          GL_FOG_HINT, GL_GENERATE_MIPMAP_HINT, GL_TEXTURE_COMPRESSION_HINT}) {
        glHint(hint, b ? GL_NICEST : GL_FASTEST);
    }
    glListBase(b ? 100 : 200);
}

std::string values(const Variable& variable)
{
    GLfloat v[4] = {};
    glGetFloatv(variable.name, v);
    std::string text;
    for (int i = 0; i < variable.count; ++i) {
        text += " " + std::to_string(v[i]);
    }
    return text;
}

/// Whether Mesa 22.3 does not restore what the specification's tables put into the group: lights and the
/// colour sum with GL_ENABLE_BIT, the colour sum and the source of the fog coordinate with GL_FOG_BIT, the
/// hint about mipmaps with GL_HINT_BIT. tests/legacygl/attribute_test.cpp holds those.
bool mesa_forgets(GLbitfield group, GLenum name)
{
    switch (name) {
    case GL_LIGHT0:
    case GL_LIGHT5:
        return group == GL_ENABLE_BIT;
    case GL_COLOR_SUM:
        return group & (GL_ENABLE_BIT | GL_FOG_BIT);
    case GL_FOG_COORDINATE_SOURCE:
        return group & GL_FOG_BIT;
    case GL_GENERATE_MIPMAP_HINT:
        return group & GL_HINT_BIT;
    default:
        return false;
    }
}

void tell_everything(GLbitfield group)
{
    for (const Variable& variable : variables()) {
        if (!mesa_forgets(group, variable.name)) {
            tell(std::to_string(variable.name) + values(variable));
        }
    }
    tell_error("all asked");
}

} // namespace

SCENE(attribute_groups_save_what_the_tables_say)
{
    for (int bit = 0; bit < 20; ++bit) {
        tell("group " + std::to_string(bit));
        set_everything(false);
        glPushAttrib(1u << bit);
        set_everything(true);
        glPopAttrib();
        tell_everything(1u << bit);
    }
    tell("all groups");
    set_everything(false);
    glPushAttrib(ALL_GROUPS);
    set_everything(true);
    glPopAttrib();
    tell_everything(ALL_GROUPS);
    tell_error("left");
}

SCENE(attribute_stack_depth_and_errors)
{
    glPopAttrib();
    tell_error("pop of none");
    for (int i = 0; i < 17; ++i) {
        glFogf(GL_FOG_DENSITY, static_cast<float>(i) / 16);
        glPushAttrib(GL_FOG_BIT);
        tell_error("push " + std::to_string(i));
    }
    TELL_STATE(GL_ATTRIB_STACK_DEPTH, 1);
    TELL_STATE(GL_MAX_ATTRIB_STACK_DEPTH, 1);
    for (int i = 0; i < 17; ++i) {
        glPopAttrib();
        TELL_STATE(GL_FOG_DENSITY, 1);
    }
    glBegin(GL_TRIANGLES);
    glPushAttrib(ALL_GROUPS);
    glPopAttrib();
    glEnd();
    tell_error("inside");
    TELL_STATE(GL_ATTRIB_STACK_DEPTH, 1);
    glPushAttrib(0);
    TELL_STATE(GL_ATTRIB_STACK_DEPTH, 1);
    glPopAttrib();
    glPopClientAttrib();
    tell_error("client pop of none");
    for (int i = 0; i < 17; ++i) {
        glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    }
    tell_error("client pushes");
    TELL_STATE(GL_CLIENT_ATTRIB_STACK_DEPTH, 1);
    TELL_STATE(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, 1);
}

SCENE(attributes_in_a_list)
{
    two_dimensions();
    glNewList(1, GL_COMPILE);
    glPushAttrib(GL_CURRENT_BIT | GL_ENABLE_BIT | GL_LIGHTING_BIT);
    glShadeModel(GL_FLAT);
    glColor3f(1, 0.5f, 0);
    glRecti(1, 1, 5, 5);
    glPopAttrib();
    glRecti(6, 1, 10, 5);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS); // Never compiled: it happens now, without a pop.
    glEndList();
    TELL_STATE(GL_CLIENT_ATTRIB_STACK_DEPTH, 1);
    glColor3f(0, 0.5f, 1);
    glCallList(1);
    TELL_STATE(GL_CURRENT_COLOR, 4);
    TELL_STATE(GL_SHADE_MODEL, 1);
    TELL_STATE(GL_ATTRIB_STACK_DEPTH, 1);
    TELL_STATE(GL_CLIENT_ATTRIB_STACK_DEPTH, 1);
}

SCENE(client_attributes)
{
    const GLfloat positions[] = {1, 2, 3}, colors[] = {4, 5, 6};
    glVertexPointer(3, GL_FLOAT, 12, positions);
    glEnableClientState(GL_VERTEX_ARRAY);
    glPixelStorei(GL_PACK_ALIGNMENT, 2);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 7);
    for (GLbitfield groups : {GLbitfield{GL_CLIENT_PIXEL_STORE_BIT}, GLbitfield{GL_CLIENT_VERTEX_ARRAY_BIT},
                              GLbitfield{GL_CLIENT_ALL_ATTRIB_BITS}}) {
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glPushClientAttrib(groups);
        glPixelStorei(GL_PACK_ALIGNMENT, 8);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 3);
        glColorPointer(4, GL_FLOAT, 16, colors);
        glEnableClientState(GL_COLOR_ARRAY);
        glDisableClientState(GL_VERTEX_ARRAY);
        glClientActiveTexture(GL_TEXTURE1);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glVertexPointer(2, GL_SHORT, 8, nullptr);
        glPopClientAttrib();
        TELL_STATE(GL_PACK_ALIGNMENT, 1);
        TELL_STATE(GL_UNPACK_ROW_LENGTH, 1);
        TELL_STATE(GL_COLOR_ARRAY, 1);
        TELL_STATE(GL_COLOR_ARRAY_SIZE, 1);
        TELL_STATE(GL_VERTEX_ARRAY, 1);
        TELL_STATE(GL_VERTEX_ARRAY_SIZE, 1);
        TELL_STATE(GL_VERTEX_ARRAY_TYPE, 1);
        TELL_STATE(GL_VERTEX_ARRAY_STRIDE, 1);
        TELL_STATE(GL_CLIENT_ACTIVE_TEXTURE, 1);
        GLvoid* pointer = nullptr;
        glGetPointerv(GL_VERTEX_ARRAY_POINTER, &pointer);
        tell(pointer == positions ? "the pointer is back" : "another pointer");
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glClientActiveTexture(GL_TEXTURE0);
    }
}

SCENE(popped_state_draws)
{
    three_dimensions();
    glRotatef(30, 1, 1, 0);
    glEnable(GL_LIGHT0);
    glPushAttrib(ALL_GROUPS);
    set_everything(true);
    glPopAttrib();
    glEnable(GL_LIGHTING);
    glEnable(GL_COLOR_MATERIAL);
    glPushAttrib(GL_LIGHTING_BIT | GL_CURRENT_BIT);
    glColor3f(0, 0, 1);
    glDisable(GL_COLOR_MATERIAL);
    glPopAttrib();
    cube();
}
