#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>

#include <array>
#include <cstdint>
#include <random>

/// Calls GL at random, but the same for the same seed: everything that decides what a primitive looks like,
/// and primitives. All of it may stand in a list.
class RandomStream
{
public:
    explicit RandomStream(unsigned seed) : random_(seed) {}

    /// Makes the textures 1 and 2, which streams bind; not to be compiled.
    static void make_textures()
    {
        std::array<std::uint8_t, 8 * 8 * 4> texels{};
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = static_cast<std::uint8_t>(i * 37);
        for (GLuint name = 1; name <= 2; ++name) {
            glBindTexture(GL_TEXTURE_2D, name);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, name == 1 ? GL_REPEAT : GL_CLAMP);
            glTexImage2D(GL_TEXTURE_2D, 0, name == 1 ? GL_RGBA : GL_LUMINANCE, 8, 8, 0, GL_RGBA,
                         GL_UNSIGNED_BYTE, texels.data());
        }
    }

    void make(int count)
    {
        for (int i = 0; i < count; ++i)
            pick(3) == 0 ? primitive() : state();
    }

    /// Changes states and draws, between glPushAttrib(groups) and glPopAttrib at the will of the caller.
    void state() { pick(2) ? fragment_state() : vertex_state(); }

    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

private:
    float number() { return static_cast<float>(pick(33)) / 16.0f - 1.0f; }
    float part() { return static_cast<float>(pick(17)) / 16.0f; }
    template <class... Names> GLenum any(Names... names)
    {
        const GLenum all[] = {static_cast<GLenum>(names)...};
        return all[pick(sizeof...(names))];
    }
    void enable(GLenum name) { pick(3) ? glEnable(name) : glDisable(name); }
    std::array<float, 4> four()
    {
        std::array<float, 4> v{};
        for (float& value : v)
            value = part();
        return v;
    }

    /// No quads: a list cuts them along another diagonal, as Mesa does.
    void primitive()
    {
        const GLenum mode = any(GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES,
                                GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUAD_STRIP, GL_POLYGON);
        const bool varies = pick(2) != 0;
        glBegin(mode);
        for (int i = 1 + pick(9); i > 0; --i) {
            if (varies && pick(3))
                attribute();
            const float x = number() * 1.25f, y = number() * 1.25f, z = number(), w = pick(12) ? 1 : part();
            pick(4) ? glVertex3f(x, y, z) : glVertex4f(x, y, z, w);
        }
        glEnd();
    }

    void attribute()
    {
        const std::array<float, 4> v = four();
        switch (pick(8)) {
        case 0:
            return glColor3fv(v.data());
        case 1:
            return glColor4fv(v.data());
        case 2:
            return glNormal3f(v[0] - 0.5f, v[1] - 0.5f, 1);
        case 3:
            return glTexCoord2f(v[0] * 2, v[1] * 2);
        case 4:
            return glEdgeFlag(v[0] < 0.7f);
        case 5:
            return glFogCoordf(v[0]);
        case 6:
            return glSecondaryColor3fv(v.data());
        default:
            return glMaterialfv(GL_FRONT_AND_BACK, v[0] < 0.5f ? GL_EMISSION : GL_DIFFUSE, v.data());
        }
    }

    void vertex_state()
    {
        const std::array<float, 4> v = four();
        switch (pick(17)) {
        case 0:
            return enable(any(GL_LIGHTING, GL_LIGHT0, GL_LIGHT1, GL_COLOR_MATERIAL, GL_NORMALIZE));
        case 1:
            return glLightfv(GL_LIGHT0 + static_cast<GLenum>(pick(2)),
                             any(GL_POSITION, GL_DIFFUSE, GL_AMBIENT, GL_SPECULAR), v.data());
        case 2:
            return glLightModeli(any(GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_LOCAL_VIEWER), pick(2));
        case 3:
            return glMaterialf(any(GL_FRONT, GL_BACK), GL_SHININESS, v[0] * 64);
        case 4:
            return glShadeModel(any(GL_FLAT, GL_SMOOTH));
        case 5:
            return glPolygonMode(any(GL_FRONT, GL_BACK, GL_FRONT_AND_BACK), any(GL_POINT, GL_LINE, GL_FILL));
        case 6:
            return enable(any(GL_CULL_FACE, GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE));
        case 7:
            return glLineWidth(v[0] * 6 + 0.5f);
        case 8:
            return glPointSize(v[0] * 9 + 0.5f);
        case 9:
            enable(GL_LINE_STIPPLE);
            return glLineStipple(1 + pick(4), static_cast<GLushort>(pick(65536)));
        case 10: {
            const GLenum plane = GL_CLIP_PLANE0 + static_cast<GLenum>(pick(3));
            const GLdouble equation[4] = {static_cast<double>(v[0]) - 0.5, static_cast<double>(v[1]) - 0.5, 0,
                                          static_cast<double>(v[2])};
            glClipPlane(plane, equation);
            return enable(plane);
        }
        case 11:
            return enable(any(GL_LINE_SMOOTH, GL_POINT_SMOOTH));
        case 12:
            return glRotatef(v[0] * 90, v[1], v[2], v[3] + 0.1f);
        case 13:
            return glTranslatef(v[0] - 0.5f, v[1] - 0.5f, 0);
        case 14:
            return pick(2) ? glLoadIdentity() : glScalef(v[0] + 0.5f, v[1] + 0.5f, v[2] + 0.5f);
        case 15:
            return glViewport(pick(9) - 4, pick(9) - 4, pick(70), pick(60));
        default:
            return attribute();
        }
    }

    void fragment_state()
    {
        const std::array<float, 4> v = four();
        switch (pick(15)) {
        case 0:
            return enable(any(GL_DEPTH_TEST, GL_STENCIL_TEST, GL_BLEND, GL_ALPHA_TEST, GL_FOG));
        case 1:
            return glDepthFunc(GL_NEVER + static_cast<GLenum>(pick(8)));
        case 2:
            return glStencilFunc(GL_NEVER + static_cast<GLenum>(pick(8)), pick(300), 3);
        case 3:
            return glStencilOp(any(GL_KEEP, GL_ZERO, GL_REPLACE), any(GL_INCR, GL_DECR),
                               any(GL_INVERT, GL_KEEP));
        case 4:
            return glBlendFunc(any(GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR, GL_CONSTANT_COLOR),
                               any(GL_ZERO, GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_CONSTANT_ALPHA));
        case 5:
            return glBlendEquationSeparate(any(GL_FUNC_ADD, GL_FUNC_SUBTRACT),
                                           any(GL_FUNC_ADD, GL_MIN, GL_MAX));
        case 6:
            return glAlphaFunc(GL_NEVER + static_cast<GLenum>(pick(8)), v[0]);
        case 7:
            glFogi(GL_FOG_MODE, static_cast<GLint>(any(GL_LINEAR, GL_EXP, GL_EXP2)));
            return glFogfv(GL_FOG_COLOR, v.data());
        case 8:
            enable(GL_SCISSOR_TEST);
            return glScissor(pick(20) - 5, pick(20) - 5, pick(64), pick(64));
        case 9:
            enable(GL_TEXTURE_2D);
            return glBindTexture(GL_TEXTURE_2D, 1 + static_cast<GLuint>(pick(2)));
        case 10:
            return glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
                             static_cast<GLint>(any(GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE, GL_ADD)));
        case 11:
            glLogicOp(GL_CLEAR + static_cast<GLenum>(pick(16)));
            return pick(4) ? glDisable(GL_COLOR_LOGIC_OP) : glEnable(GL_COLOR_LOGIC_OP);
        case 12:
            return glColorMask(pick(8) != 0, pick(8) != 0, pick(8) != 0, pick(8) != 0);
        case 13:
            return glDepthRange(static_cast<double>(v[0]) / 2, 1 - static_cast<double>(v[1]) / 2);
        default:
            glClearColor(v[0], v[1], v[2], v[3]);
            return pick(4) ? (void)0
                           : glClear(any(GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT));
        }
    }

    std::mt19937 random_;
};
