#include "random_gl/pieces.h"
#include "random_gl/random_stream.h"

namespace random_gl {

void RandomStream::make_textures()
{
    constexpr GLenum FORMATS[4] = {GL_RGBA, GL_LUMINANCE, GL_RGB, GL_LUMINANCE_ALPHA};
    for (GLuint name = 4; name >= 1; --name) {
        glBindTexture(GL_TEXTURE_2D, name);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, name == 3 ? GL_NEAREST : GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, name == 3 ? GL_NEAREST : GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, name == 2 ? GL_CLAMP : GL_REPEAT);
        texture_image(FORMATS[name - 1], name == 4 ? 32 : 8, 8, false);
    }
}

bool RandomStream::texture_state(Feature feature)
{
    const Values<float, 4> v = four();
    const auto& a = v.values;
    switch (feature) {
    case Feature::textures:
        enable(RANDOM_GL_NAME(GL_TEXTURE_2D));
        RANDOM_GL_CALL(glBindTexture, RANDOM_GL_NAME(GL_TEXTURE_2D), 1 + static_cast<GLuint>(pick(4)));
        if (pick(3) == 0) {
            const Name format = RANDOM_GL_ANY(GL_RGBA, GL_RGB, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY,
                                              GL_LUMINANCE_ALPHA, GL_RGB5_A1, GL_RGBA4);
            const int width = 1 << pick(6), height = 1 << pick(6);
            RANDOM_GL_CALL(texture_image, format, width, height, pick(3) == 0);
        }
        return true;
    case Feature::texture_parameters:
        switch (pick(5)) {
        case 0:
            RANDOM_GL_CALL(glTexParameteri, RANDOM_GL_NAME(GL_TEXTURE_2D),
                           RANDOM_GL_NAME(GL_TEXTURE_MAG_FILTER), RANDOM_GL_ANY(GL_NEAREST, GL_LINEAR));
            return true;
        case 1:
            RANDOM_GL_CALL(texture_image, RANDOM_GL_ANY(GL_RGBA, GL_RGB, GL_LUMINANCE), 16, 16, true);
            RANDOM_GL_CALL(
                glTexParameteri, RANDOM_GL_NAME(GL_TEXTURE_2D), RANDOM_GL_NAME(GL_TEXTURE_MIN_FILTER),
                RANDOM_GL_ANY(GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
                              GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR));
            return true;
        case 2:
            RANDOM_GL_CALL(glTexParameterfv, RANDOM_GL_NAME(GL_TEXTURE_2D),
                           RANDOM_GL_NAME(GL_TEXTURE_BORDER_COLOR), v);
            return true;
        default:
            RANDOM_GL_CALL(
                glTexParameteri, RANDOM_GL_NAME(GL_TEXTURE_2D),
                RANDOM_GL_ANY(GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T),
                RANDOM_GL_ANY(GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT));
            return true;
        }
    case Feature::texture_environment:
        if (pick(4) == 0) {
            RANDOM_GL_CALL(glTexEnvfv, RANDOM_GL_NAME(GL_TEXTURE_ENV), RANDOM_GL_NAME(GL_TEXTURE_ENV_COLOR),
                           v);
        } else {
            RANDOM_GL_CALL(glTexEnvi, RANDOM_GL_NAME(GL_TEXTURE_ENV), RANDOM_GL_NAME(GL_TEXTURE_ENV_MODE),
                           RANDOM_GL_ANY(GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE, GL_ADD));
        }
        return true;
    case Feature::texture_combiners:
        combiner_state();
        return true;
    case Feature::texture_generation: {
        enable(RANDOM_GL_ANY(GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T));
        const Name coordinate = RANDOM_GL_ANY(GL_S, GL_T);
        RANDOM_GL_CALL(glTexGeni, coordinate, RANDOM_GL_NAME(GL_TEXTURE_GEN_MODE),
                       RANDOM_GL_ANY(GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP));
        if (pick(2)) {
            RANDOM_GL_CALL(glTexGenfv, coordinate, RANDOM_GL_ANY(GL_OBJECT_PLANE, GL_EYE_PLANE), v);
        }
        return true;
    }
    case Feature::texture_matrix:
        RANDOM_GL_CALL(glMatrixMode, RANDOM_GL_NAME(GL_TEXTURE));
        if (pick(2)) {
            RANDOM_GL_CALL(glRotatef, a[0] * 90, 0.0f, 0.0f, 1.0f);
        } else {
            RANDOM_GL_CALL(glScalef, a[0] + 0.5f, a[1] + 0.5f, 1.0f);
        }
        RANDOM_GL_CALL(glMatrixMode, RANDOM_GL_NAME(GL_MODELVIEW));
        return true;
    case Feature::second_texture_unit:
        RANDOM_GL_CALL(glActiveTexture, RANDOM_GL_ANY(GL_TEXTURE0, GL_TEXTURE1));
        enable(RANDOM_GL_NAME(GL_TEXTURE_2D));
        RANDOM_GL_CALL(glBindTexture, RANDOM_GL_NAME(GL_TEXTURE_2D), 1 + static_cast<GLuint>(pick(4)));
        return true;
    case Feature::copied_textures: {
        const int x = pick(40), y = pick(40), width = 8 << pick(3), height = 8 << pick(3);
        enable(RANDOM_GL_NAME(GL_TEXTURE_2D));
        RANDOM_GL_CALL(copied_texture, x, y, width, height);
        return true;
    }
    default:
        return false;
    }
}

void RandomStream::combiner_state()
{
    const Name environment = RANDOM_GL_NAME(GL_TEXTURE_ENV);
    RANDOM_GL_CALL(glTexEnvi, environment, RANDOM_GL_NAME(GL_TEXTURE_ENV_MODE), RANDOM_GL_NAME(GL_COMBINE));
    switch (pick(4)) {
    case 0:
        RANDOM_GL_CALL(glTexEnvi, environment, RANDOM_GL_NAME(GL_COMBINE_RGB),
                       RANDOM_GL_ANY(GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE,
                                     GL_SUBTRACT, GL_DOT3_RGB));
        return;
    case 1:
        RANDOM_GL_CALL(glTexEnvi, environment, RANDOM_GL_ANY(GL_SOURCE0_RGB, GL_SOURCE1_RGB, GL_SOURCE2_RGB),
                       RANDOM_GL_ANY(GL_TEXTURE, GL_PREVIOUS, GL_PRIMARY_COLOR, GL_CONSTANT));
        return;
    case 2:
        RANDOM_GL_CALL(
            glTexEnvi, environment, RANDOM_GL_ANY(GL_OPERAND0_RGB, GL_OPERAND1_RGB, GL_OPERAND2_RGB),
            RANDOM_GL_ANY(GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
        return;
    default:
        RANDOM_GL_CALL(
            glTexEnvi, environment, RANDOM_GL_NAME(GL_COMBINE_ALPHA),
            RANDOM_GL_ANY(GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT));
    }
}

} // namespace random_gl
