#include "random_gl/random_stream.h"

namespace random_gl {

bool RandomStream::vertex_state(Feature feature)
{
    const Values<float, 4> v = four();
    const auto& a = v.values;
    switch (feature) {
    case Feature::attributes:
        attribute(pick(ATTRIBUTES));
        return true;
    case Feature::matrices:
        switch (pick(4)) {
        case 0:
            RANDOM_GL_CALL(glRotatef, a[0] * 90, a[1], a[2], a[3] + 0.1f);
            return true;
        case 1:
            RANDOM_GL_CALL(glTranslatef, a[0] - 0.5f, a[1] - 0.5f, 0.0f);
            return true;
        case 2:
            RANDOM_GL_CALL(glScalef, a[0] + 0.5f, a[1] + 0.5f, a[2] + 0.5f);
            return true;
        default:
            if (!in_three_dimensions_) {
                RANDOM_GL_CALL(glLoadIdentity);
            }
            return true;
        }
    case Feature::lighting:
        light_state();
        return true;
    case Feature::materials:
        if (pick(3) == 0) {
            RANDOM_GL_CALL(glMaterialf, RANDOM_GL_ANY(GL_FRONT, GL_BACK, GL_FRONT_AND_BACK),
                           RANDOM_GL_NAME(GL_SHININESS), 1 + a[0] * 63);
        } else {
            RANDOM_GL_CALL(glMaterialfv, RANDOM_GL_ANY(GL_FRONT_AND_BACK, GL_FRONT, GL_BACK),
                           RANDOM_GL_ANY(GL_EMISSION, GL_DIFFUSE, GL_AMBIENT, GL_SPECULAR), v);
        }
        return true;
    case Feature::shade_model:
        RANDOM_GL_CALL(glShadeModel, RANDOM_GL_ANY(GL_FLAT, GL_SMOOTH));
        return true;
    case Feature::clip_planes: {
        const unsigned plane = static_cast<unsigned>(pick(3));
        const Name name{GL_CLIP_PLANE0 + plane, "GL_CLIP_PLANE" + std::to_string(plane)};
        const Values<double, 4> equation{{static_cast<double>(a[0]) - 0.5, static_cast<double>(a[1]) - 0.5,
                                          pick(2) ? 0 : static_cast<double>(a[3]) - 0.5,
                                          static_cast<double>(a[2])}};
        RANDOM_GL_CALL(glClipPlane, name, equation);
        enable(name);
        return true;
    }
    case Feature::viewport: {
        const int x = pick(41) - 20, y = pick(41) - 20, width = 20 + pick(100), height = 20 + pick(100);
        RANDOM_GL_CALL(glViewport, x, y, width, height);
        return true;
    }
    case Feature::depth_range:
        RANDOM_GL_CALL(glDepthRange, static_cast<double>(a[0]) / 2, 1 - static_cast<double>(a[1]) / 2);
        return true;
    case Feature::flushes:
        if (pick(2)) {
            RANDOM_GL_CALL(glFlush);
        } else {
            RANDOM_GL_CALL(glFinish);
        }
        return true;
    default:
        return false;
    }
}

void RandomStream::light_state()
{
    const Values<float, 4> v = four();
    const auto& a = v.values;
    const unsigned number = static_cast<unsigned>(pick(3));
    const Name light{GL_LIGHT0 + number, "GL_LIGHT" + std::to_string(number)};
    switch (pick(9)) {
    case 0:
        return enable(RANDOM_GL_ANY(GL_LIGHTING, GL_COLOR_MATERIAL, GL_NORMALIZE, GL_RESCALE_NORMAL));
    case 1:
        return enable(light);
    case 2:
        RANDOM_GL_CALL(glLightfv, light, RANDOM_GL_ANY(GL_DIFFUSE, GL_AMBIENT, GL_SPECULAR), v);
        return;
    case 3:
        RANDOM_GL_CALL(glLightfv, light, RANDOM_GL_NAME(GL_POSITION),
                       Values<float, 4>{{a[0] * 4 - 2, a[1] * 4 - 2, a[2] * 4, pick(2) ? 1.0f : 0.0f}});
        return;
    case 4:
        RANDOM_GL_CALL(glLightModeli, RANDOM_GL_ANY(GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_LOCAL_VIEWER),
                       pick(2));
        return;
    case 5:
        RANDOM_GL_CALL(
            glLightf, light,
            RANDOM_GL_ANY(GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION),
            a[0] + 0.25f);
        return;
    case 6:
        RANDOM_GL_CALL(glLightf, light, RANDOM_GL_NAME(GL_SPOT_CUTOFF), pick(3) ? 10 + a[0] * 80 : 180.0f);
        RANDOM_GL_CALL(glLightf, light, RANDOM_GL_NAME(GL_SPOT_EXPONENT), a[1] * 16);
        return;
    case 7:
        RANDOM_GL_CALL(
            glColorMaterial, RANDOM_GL_ANY(GL_FRONT_AND_BACK, GL_FRONT, GL_BACK),
            RANDOM_GL_ANY(GL_AMBIENT_AND_DIFFUSE, GL_DIFFUSE, GL_AMBIENT, GL_SPECULAR, GL_EMISSION));
        return;
    default:
        if (pick(2)) {
            RANDOM_GL_CALL(glLightModelfv, RANDOM_GL_NAME(GL_LIGHT_MODEL_AMBIENT), v);
        } else {
            RANDOM_GL_CALL(glLightModeli, RANDOM_GL_NAME(GL_LIGHT_MODEL_COLOR_CONTROL),
                           RANDOM_GL_ANY(GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR));
        }
    }
}

bool RandomStream::raster_state(Feature feature)
{
    const Values<float, 4> v = four();
    const auto& a = v.values;
    switch (feature) {
    case Feature::faces:
        enable(RANDOM_GL_NAME(GL_CULL_FACE));
        if (pick(2)) {
            RANDOM_GL_CALL(glCullFace, RANDOM_GL_ANY(GL_FRONT, GL_BACK));
        } else {
            RANDOM_GL_CALL(glFrontFace, RANDOM_GL_ANY(GL_CW, GL_CCW));
        }
        return true;
    case Feature::polygon_mode:
        // With both, Mesa draws one face with what is meant for the smooth lines or the stipple of the other.
        if (uses(Feature::smooth_lines_and_points) || uses(Feature::polygon_stipple)) {
            RANDOM_GL_CALL(glPolygonMode, RANDOM_GL_NAME(GL_FRONT_AND_BACK),
                           RANDOM_GL_ANY(GL_POINT, GL_LINE, GL_LINE, GL_FILL));
        } else {
            RANDOM_GL_CALL(glPolygonMode,
                           RANDOM_GL_ANY(GL_FRONT, GL_BACK, GL_FRONT_AND_BACK, GL_FRONT_AND_BACK),
                           RANDOM_GL_ANY(GL_POINT, GL_LINE, GL_LINE, GL_FILL));
        }
        return true;
    case Feature::polygon_offset:
        // All at once: if one of them is on, Mesa offsets all.
        for (const bool on = pick(3) != 0; const Name& name : {RANDOM_GL_NAME(GL_POLYGON_OFFSET_FILL),
                                                               RANDOM_GL_NAME(GL_POLYGON_OFFSET_LINE),
                                                               RANDOM_GL_NAME(GL_POLYGON_OFFSET_POINT)}) {
            if (on) {
                RANDOM_GL_CALL(glEnable, name);
            } else {
                RANDOM_GL_CALL(glDisable, name);
            }
        }
        RANDOM_GL_CALL(glPolygonOffset, a[0] * 4 - 2, a[1] * 4 - 2);
        return true;
    case Feature::polygon_stipple: {
        Values<GLubyte, 128> pattern{};
        const int kind = pick(4);
        for (std::size_t i = 0; i < 128; ++i) {
            pattern.values[i] = static_cast<GLubyte>(kind == 0   ? (i / 4 % 2 ? 0x55 : 0xaa)
                                                     : kind == 1 ? 0x0f
                                                                 : i * 37);
        }
        enable(RANDOM_GL_NAME(GL_POLYGON_STIPPLE));
        RANDOM_GL_CALL(glPolygonStipple, pattern);
        return true;
    }
    case Feature::line_stipple: {
        enable(RANDOM_GL_NAME(GL_LINE_STIPPLE));
        const int factor = 1 + pick(4);
        RANDOM_GL_CALL(glLineStipple, factor,
                       static_cast<GLushort>(pick(2)   ? pick(65536)
                                             : pick(2) ? 0x00ff
                                                       : 0x1c47));
        return true;
    }
    case Feature::line_width:
        RANDOM_GL_CALL(glLineWidth, a[0] * 6 + 0.5f);
        return true;
    case Feature::point_size:
        RANDOM_GL_CALL(glPointSize, a[0] * 9 + 0.5f);
        return true;
    case Feature::point_parameters:
        if (pick(2)) {
            RANDOM_GL_CALL(glPointParameterfv, RANDOM_GL_NAME(GL_POINT_DISTANCE_ATTENUATION), v);
        } else {
            RANDOM_GL_CALL(glPointParameterf, RANDOM_GL_ANY(GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX), a[0] * 8);
        }
        return true;
    case Feature::smooth_lines_and_points:
        enable(RANDOM_GL_ANY(GL_LINE_SMOOTH, GL_POINT_SMOOTH));
        RANDOM_GL_CALL(glEnable, RANDOM_GL_NAME(GL_BLEND));
        RANDOM_GL_CALL(glBlendFunc, RANDOM_GL_NAME(GL_SRC_ALPHA), RANDOM_GL_NAME(GL_ONE_MINUS_SRC_ALPHA));
        return true;
    case Feature::provoking_vertex:
        RANDOM_GL_CALL(glProvokingVertex,
                       RANDOM_GL_ANY(GL_FIRST_VERTEX_CONVENTION, GL_LAST_VERTEX_CONVENTION));
        return true;
    default:
        return false;
    }
}

bool RandomStream::fragment_state(Feature feature)
{
    const Values<float, 4> v = four();
    const auto& a = v.values;
    const auto comparison = [this] {
        return RANDOM_GL_ANY(GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL,
                             GL_ALWAYS);
    };
    switch (feature) {
    case Feature::depth_test:
        enable(RANDOM_GL_NAME(GL_DEPTH_TEST));
        RANDOM_GL_CALL(glDepthFunc, comparison());
        if (pick(6) == 0) {
            RANDOM_GL_CALL(glDepthMask, static_cast<GLboolean>(pick(2)));
        }
        return true;
    case Feature::stencil_test: {
        enable(RANDOM_GL_NAME(GL_STENCIL_TEST));
        const Name function = comparison();
        RANDOM_GL_CALL(glStencilFunc, function, pick(300), 3u);
        const Name fail = RANDOM_GL_ANY(GL_KEEP, GL_ZERO, GL_REPLACE),
                   depth_fail = RANDOM_GL_ANY(GL_INCR, GL_DECR),
                   pass = RANDOM_GL_ANY(GL_INVERT, GL_KEEP, GL_INCR, GL_REPLACE);
        RANDOM_GL_CALL(glStencilOp, fail, depth_fail, pass);
        if (pick(6) == 0) {
            RANDOM_GL_CALL(glStencilMask, static_cast<GLuint>(pick(256)));
        }
        return true;
    }
    case Feature::alpha_test: {
        enable(RANDOM_GL_NAME(GL_ALPHA_TEST));
        RANDOM_GL_CALL(glAlphaFunc, comparison(), a[0]);
        return true;
    }
    case Feature::scissor: {
        enable(RANDOM_GL_NAME(GL_SCISSOR_TEST));
        const int x = pick(40) - 10, y = pick(40) - 10, width = pick(96), height = pick(96);
        RANDOM_GL_CALL(glScissor, x, y, width, height);
        return true;
    }
    case Feature::blend: {
        enable(RANDOM_GL_NAME(GL_BLEND));
        const Name source = RANDOM_GL_ANY(GL_ONE, GL_SRC_ALPHA, GL_SRC_ALPHA, GL_DST_COLOR, GL_CONSTANT_COLOR,
                                          GL_SRC_ALPHA_SATURATE, GL_ONE_MINUS_DST_COLOR);
        const Name destination = RANDOM_GL_ANY(GL_ZERO, GL_ONE, GL_ONE_MINUS_SRC_ALPHA,
                                               GL_ONE_MINUS_SRC_ALPHA, GL_CONSTANT_ALPHA, GL_SRC_COLOR);
        RANDOM_GL_CALL(glBlendFunc, source, destination);
        if (pick(5) == 0) {
            RANDOM_GL_CALL(glBlendEquation, RANDOM_GL_ANY(GL_FUNC_ADD, GL_FUNC_SUBTRACT,
                                                          GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX));
        }
        if (pick(5) == 0) {
            RANDOM_GL_CALL(glBlendColor, a[0], a[1], a[2], a[3]);
        }
        return true;
    }
    case Feature::logic_op:
        RANDOM_GL_CALL(glLogicOp,
                       RANDOM_GL_ANY(GL_CLEAR, GL_AND, GL_AND_REVERSE, GL_COPY, GL_AND_INVERTED, GL_NOOP,
                                     GL_XOR, GL_OR, GL_NOR, GL_EQUIV, GL_INVERT, GL_OR_REVERSE,
                                     GL_COPY_INVERTED, GL_OR_INVERTED, GL_NAND, GL_SET));
        enable(RANDOM_GL_NAME(GL_COLOR_LOGIC_OP));
        return true;
    case Feature::color_mask: {
        const auto bit = [this] { return static_cast<GLboolean>(pick(4) != 0); };
        const GLboolean r = bit(), g = bit(), b = bit(), alpha = bit();
        RANDOM_GL_CALL(glColorMask, r, g, b, alpha);
        return true;
    }
    case Feature::fog:
        enable(RANDOM_GL_NAME(GL_FOG));
        switch (pick(4)) {
        case 0:
            RANDOM_GL_CALL(glFogi, RANDOM_GL_NAME(GL_FOG_MODE), RANDOM_GL_ANY(GL_LINEAR, GL_EXP, GL_EXP2));
            return true;
        case 1:
            RANDOM_GL_CALL(glFogfv, RANDOM_GL_NAME(GL_FOG_COLOR), v);
            return true;
        case 2:
            RANDOM_GL_CALL(glFogf, RANDOM_GL_ANY(GL_FOG_DENSITY, GL_FOG_START), a[0]);
            return true;
        default:
            RANDOM_GL_CALL(glFogf, RANDOM_GL_NAME(GL_FOG_END), 1 + a[0] * 4);
            return true;
        }
    case Feature::fog_coordinates:
        RANDOM_GL_CALL(glFogi, RANDOM_GL_NAME(GL_FOG_COORDINATE_SOURCE),
                       RANDOM_GL_ANY(GL_FOG_COORDINATE, GL_FRAGMENT_DEPTH));
        return true;
    case Feature::secondary_colors:
        enable(RANDOM_GL_NAME(GL_COLOR_SUM));
        return true;
    case Feature::clears:
        RANDOM_GL_CALL(glClearColor, a[0], a[1], a[2], a[3]);
        if (pick(4) == 0) {
            RANDOM_GL_CALL(glClear,
                           RANDOM_GL_ANY(GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT));
        }
        return true;
    default:
        return false;
    }
}

} // namespace random_gl
