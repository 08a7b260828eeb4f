// Names from the time of extensions do what the functions of today do.

#define GL_GLEXT_PROTOTYPES
#include "recorded_gl.h"

#include <GL/glext.h>

#include <string>

namespace {

using Aliases = RecordedGl;

TEST_F(Aliases, ReachTheSameState)
{
    glActiveTextureARB(GL_TEXTURE1);
    glBindTextureEXT(GL_TEXTURE_2D, 3);
    glBlendEquationEXT(GL_FUNC_SUBTRACT);
    glPolygonOffsetEXT(2, 1.0f / 16777215.0f);
    const GLfloat rows[] = {1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1};
    glLoadTransposeMatrixfARB(rows);
    const auto get = [](GLenum name) {
        std::array<GLfloat, 16> v{};
        glGetFloatv(name, v.data());
        return v;
    };
    EXPECT_EQ(get(GL_ACTIVE_TEXTURE)[0], static_cast<float>(GL_TEXTURE1));
    EXPECT_EQ(get(GL_TEXTURE_BINDING_2D)[0], 3.0f);
    EXPECT_EQ(get(GL_BLEND_EQUATION)[0], static_cast<float>(GL_FUNC_SUBTRACT));
    EXPECT_EQ(get(GL_POLYGON_OFFSET_FACTOR)[0], 2.0f);
    EXPECT_EQ(get(GL_POLYGON_OFFSET_UNITS)[0], 1.0f) << "A bias of one step of 24 bits is one unit.";
    EXPECT_EQ(get(GL_MODELVIEW_MATRIX)[13], 6.0f);
    glMultiTexCoord3dARB(GL_TEXTURE1, 1, 2, 3);
    EXPECT_EQ(get(GL_CURRENT_TEXTURE_COORDS)[2], 3.0f);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Aliases, AreListedAsExtensions)
{
    const std::string extensions = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    for (const char* name : {"GL_ARB_multitexture", "GL_ARB_transpose_matrix", "GL_EXT_texture_object"}) {
        EXPECT_NE((extensions + " ").find(name + std::string(" ")), std::string::npos) << name;
    }
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(glGetString(GL_RENDERER))), "legacygl");
}

} // namespace
