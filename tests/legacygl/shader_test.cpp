#include "legacygl/shader/shader_text.h"
#include "recorded_gl.h"

#include <unordered_set>

namespace {

using namespace legacygl;

class Shader : public RecordedGl
{
protected:
    ShaderKey key() const { return make_shader_key(context->state, PrimitiveClass::triangles, ~0u); }
};

TEST_F(Shader, LightsInObjectSpaceWhereThatIsTheSame)
{
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glRotatef(30, 1, 0, 0);
    EXPECT_FALSE(key().eye_space);
    const GLfloat near_light[] = {0, 0, 1, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, near_light);
    EXPECT_TRUE(key().eye_space) << "a positional light needs the vertex's place";
    const GLfloat far_light[] = {0, 0, 1, 0};
    glLightfv(GL_LIGHT0, GL_POSITION, far_light);
    EXPECT_FALSE(key().eye_space);
    glScalef(2, 1, 1);
    EXPECT_TRUE(key().eye_space) << "a modelview that scales changes the angles";
}

TEST_F(Shader, ATextureThatIsNotCompleteIsOff)
{
    glEnable(GL_TEXTURE_2D);
    EXPECT_EQ(key().textures[0].format, BaseFormat::none);
    const GLubyte pixels[16] = {};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    EXPECT_EQ(key().textures[0].format, BaseFormat::none) << "the minifying filter asks for mipmaps";
    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    EXPECT_EQ(key().textures[0].format, BaseFormat::rgba);
}

TEST_F(Shader, OneKeyHasOneTextAndOtherKeysHaveOthers)
{
    std::unordered_set<std::string> texts;
    std::unordered_set<ShaderKey, ShaderKeyHash> keys;
    for (int bits = 0; bits < 512; ++bits) {
        ShaderKey k;
        k.lighting = true;
        k.eye_space = bits & 1;
        k.normalize = bits & 2;
        k.two_side = bits & 4;
        k.specular = bits & 8;
        k.flat = bits & 16;
        k.separate_specular = bits & 32;
        k.light_count = 1;
        k.lights[0].positional = (bits & 64) && k.eye_space;
        k.local_viewer = (bits & 128) && k.eye_space;
        k.follows_color = bits & 256 ? 3 : 0;
        if (!keys.insert(k).second) {
            continue;
        }
        const ProgramText text = make_program_text(k);
        EXPECT_EQ(make_program_text(k).vertex, text.vertex);
        // The half vector is unused without specular light, so a viewer close by changes nothing then.
        const bool inserted = texts.insert(text.vertex + text.fragment).second;
        EXPECT_TRUE(inserted || (k.local_viewer && !k.specular)) << bits;
    }
}

TEST_F(Shader, FragmentsCountInWholeNumbersOf32Bits)
{
    glEnable(GL_POLYGON_STIPPLE);
    const std::string text = make_program_text(key()).fragment;
    ASSERT_NE(text.find("int part"), std::string::npos) << "the stipple takes 16 bits of a row";
    EXPECT_LT(text.find("precision highp int;"), text.find("int part")) << text;
}

TEST_F(Shader, UnlitVerticesDoNotReadNormals)
{
    EXPECT_EQ(attributes_read(key()),
              (1u << index_of(Attribute::position)) | (1u << index_of(Attribute::color)));
    glEnable(GL_LIGHTING);
    EXPECT_EQ(attributes_read(key()),
              (1u << index_of(Attribute::position)) | (1u << index_of(Attribute::normal)));
}

TEST_F(Shader, UniformsAreUploadedOnlyWhenTheyChanged)
{
    triangle();
    glFlush();
    context->flush_vertices();
    const auto draws_before = backend->draws();
    glColor3f(1, 0, 0); // An attribute, not a uniform.
    triangle();
    context->flush_vertices();
    const auto draws = backend->draws();
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(draws[0].uniforms, draws[1].uniforms);
    EXPECT_EQ(backend->programs.size(), 1u);
}

} // namespace
