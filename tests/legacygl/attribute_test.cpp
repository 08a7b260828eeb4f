// The attribute stacks: state after glPopAttrib is what it was before glPushAttrib.

#define GL_GLEXT_PROTOTYPES
#include "legacygl/state/capabilities.h"
#include "legacygl/state/state_variables.h"
#include "recorded_gl.h"

#include <functional>
#include <map>
#include <random>
#include <string>

namespace {

using Attributes = RecordedGl;
using Snapshot = std::map<std::string, std::vector<GLfloat>>;

std::vector<GLenum> capability_names(legacygl::State& state)
{
    std::vector<GLenum> names;
    const auto add = [&names](GLenum name, GLbitfield, std::uint32_t, bool&) { names.push_back(name); };
    legacygl::visit_capabilities(state, add);
    legacygl::visit_unit_capabilities(state.texturing.unit(), add);
    return names;
}

void ask_units(Snapshot& out)
{
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLenum unit = GL_TEXTURE0; unit < GL_TEXTURE0 + legacygl::TEXTURE_UNIT_COUNT; ++unit) {
        const auto ask = [&](const std::string& what, int count, auto get) {
            std::vector<GLfloat>& values = out[std::to_string(unit) + what];
            values.resize(static_cast<std::size_t>(count));
            get(values.data());
        };
        glActiveTexture(unit);
        for (GLenum name : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T,
                            GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D}) {
            ask(" state " + std::to_string(name), 1, [=](GLfloat* v) { glGetFloatv(name, v); });
        }
        ask(" mode", 1, [](GLfloat* v) { glGetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, v); });
        ask(" colour", 4, [](GLfloat* v) { glGetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, v); });
        ask(" plane", 4, [](GLfloat* v) { glGetTexGenfv(GL_S, GL_OBJECT_PLANE, v); });
        for (GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D}) {
            for (GLenum name : {GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_PRIORITY}) {
                ask(" parameter " + std::to_string(target) + " " + std::to_string(name), 1,
                    [=](GLfloat* v) { glGetTexParameterfv(target, name, v); });
            }
        }
    }
    glActiveTexture(static_cast<GLenum>(active));
}

/// Returns the answers of all queries about what a stack of attributes can save.
Snapshot snapshot(legacygl::State& state)
{
    Snapshot out;
    const auto ask = [&out](GLenum name) {
        std::vector<GLfloat>& values = out["state " + std::to_string(name)];
        values.resize(16);
        glGetFloatv(name, values.data());
    };
    legacygl::visit_variables(state, [&](GLenum name, GLbitfield group, const legacygl::StateField&) {
        if (name != 0 && group != 0) {
            ask(name);
        }
    });
    for (GLenum name : capability_names(state)) {
        ask(name);
    }
    for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 8; ++light) {
        for (GLenum name = GL_AMBIENT; name <= GL_QUADRATIC_ATTENUATION; ++name) {
            std::vector<GLfloat>& values = out[std::to_string(light) + " " + std::to_string(name)];
            values.resize(4);
            glGetLightfv(light, name, values.data());
        }
    }
    for (GLenum face : {GL_FRONT, GL_BACK}) {
        for (GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS}) {
            std::vector<GLfloat>& values = out[std::to_string(face) + " " + std::to_string(name)];
            values.resize(4);
            glGetMaterialfv(face, name, values.data());
        }
    }
    ask_units(out);
    return out;
}

/// Changes some of the state at random, but the same for the same seed.
class RandomState
{
public:
    explicit RandomState(unsigned seed, std::vector<GLenum> capabilities)
        : random_(seed), capabilities_(std::move(capabilities))
    {}

    void change(int count)
    {
        for (int i = 0; i < count; ++i) {
            one();
        }
    }

private:
    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    float number() { return static_cast<float>(pick(9)) / 8; }
    std::array<GLfloat, 4> color()
    {
        std::array<GLfloat, 4> values;
        for (GLfloat& v : values) {
            v = number();
        }
        return values;
    }

    void one()
    {
        const std::array<GLfloat, 4> c = color();
        switch (pick(28)) {
        case 0:
        case 1:
        case 2: {
            const GLenum name =
                capabilities_[static_cast<std::size_t>(pick(static_cast<int>(capabilities_.size())))];
            return pick(2) ? glEnable(name) : glDisable(name);
        }
        case 3:
            return glColor4fv(c.data());
        case 4:
            return glNormal3fv(c.data());
        case 5:
            return glTexCoord4fv(c.data());
        case 6:
            return glLightfv(GL_LIGHT0 + static_cast<GLenum>(pick(8)),
                             GL_AMBIENT + static_cast<GLenum>(pick(4)), c.data());
        case 7:
            return glMaterialfv(pick(2) ? GL_FRONT : GL_FRONT_AND_BACK, pick(2) ? GL_DIFFUSE : GL_EMISSION,
                                c.data());
        case 8:
            return glColorMaterial(pick(2) ? GL_FRONT : GL_BACK,
                                   pick(2) ? GL_SPECULAR : GL_AMBIENT_AND_DIFFUSE);
        case 9:
            return glFogfv(GL_FOG_COLOR, c.data());
        case 10:
            return glFogf(pick(2) ? GL_FOG_START : GL_FOG_DENSITY, number());
        case 11:
            return glDepthFunc(GL_NEVER + static_cast<GLenum>(pick(8)));
        case 12:
            return glStencilFunc(GL_NEVER + static_cast<GLenum>(pick(8)), pick(9),
                                 static_cast<GLuint>(pick(256)));
        case 13:
            return glBlendFunc(pick(2) ? GL_ONE : GL_SRC_ALPHA, pick(2) ? GL_ZERO : GL_ONE_MINUS_SRC_ALPHA);
        case 14:
            return glColorMask(pick(2) == 1, pick(2) == 1, GL_TRUE, GL_FALSE);
        case 15:
            return glClearColor(c[0], c[1], c[2], c[3]);
        case 16:
            return glViewport(pick(5), pick(5), 10 + pick(5), 10);
        case 17:
            return glScissor(pick(5), pick(5), 10 + pick(5), 10);
        case 18:
            return glMatrixMode(GL_MODELVIEW + static_cast<GLenum>(pick(3)));
        case 19:
            return glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(pick(2)));
        case 20:
            return glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(pick(4)));
        case 21:
            return glTexParameteri(pick(2) ? GL_TEXTURE_1D : GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                                   pick(2) ? GL_NEAREST : GL_LINEAR);
        case 22:
            return glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, c.data());
        case 23:
            return glTexGenfv(GL_S, GL_OBJECT_PLANE, c.data());
        case 24:
            return glHint(GL_FOG_HINT, GL_DONT_CARE + static_cast<GLenum>(pick(3)));
        case 25:
            return glDrawBuffer(pick(2) ? GL_FRONT : GL_BACK);
        case 26:
            return glReadBuffer(pick(2) ? GL_FRONT : GL_BACK);
        default:
            return glListBase(static_cast<GLuint>(pick(100)));
        }
    }

    std::mt19937 random_;
    std::vector<GLenum> capabilities_;
};

TEST_F(Attributes, PoppedStateIsTheStateThatWasPushed)
{
    for (unsigned seed = 0; seed < 2000; ++seed) {
        RandomState random(seed, capability_names(context->state));
        random.change(20);
        const int depth = 1 + static_cast<int>(seed % 3);
        std::vector<Snapshot> before;
        for (int level = 0; level < depth; ++level) {
            before.push_back(snapshot(context->state));
            glPushAttrib(GL_ALL_ATTRIB_BITS);
            random.change(30);
        }
        for (; !before.empty(); before.pop_back()) {
            glPopAttrib();
            const Snapshot after = snapshot(context->state);
            for (const auto& [name, values] : before.back()) {
                ASSERT_EQ(values, after.at(name)) << "seed " << seed << ", " << name;
            }
        }
        glGetError(); // Asking lights for what only materials have is an error, on both sides.
    }
}

TEST_F(Attributes, TheSameFromAList)
{
    for (unsigned seed = 0; seed < 300; ++seed) {
        RandomState(seed, capability_names(context->state)).change(20);
        const Snapshot before = snapshot(context->state);
        glNewList(1, GL_COMPILE);
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        RandomState(seed + 1000, capability_names(context->state)).change(30);
        glPopAttrib();
        glEndList();
        EXPECT_EQ(before, snapshot(context->state)) << "Compiled commands wait.";
        glCallList(1);
        ASSERT_EQ(before, snapshot(context->state)) << "seed " << seed;
    }
}

/// What Mesa 22.3 leaves out of these groups (tests/oracle/scenes/attribute_groups.cpp) and the specification
/// has in them (OpenGL 1.5, tables 6.10, 6.11 and 6.24).
TEST_F(Attributes, GroupsHaveWhatMesaForgets)
{
    glPushAttrib(GL_ENABLE_BIT);
    glEnable(GL_LIGHT3);
    glEnable(GL_COLOR_SUM);
    glPopAttrib();
    EXPECT_FALSE(glIsEnabled(GL_LIGHT3));
    EXPECT_FALSE(glIsEnabled(GL_COLOR_SUM));
    glPushAttrib(GL_FOG_BIT | GL_HINT_BIT);
    glEnable(GL_COLOR_SUM);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    glHint(GL_GENERATE_MIPMAP_HINT, GL_NICEST);
    glPopAttrib();
    EXPECT_FALSE(glIsEnabled(GL_COLOR_SUM));
    GLint value = 0;
    glGetIntegerv(GL_FOG_COORDINATE_SOURCE, &value);
    EXPECT_EQ(value, GL_FRAGMENT_DEPTH);
    glGetIntegerv(GL_GENERATE_MIPMAP_HINT, &value);
    EXPECT_EQ(value, GL_DONT_CARE);
}

TEST_F(Attributes, ATextureDeletedMeanwhileIsBoundAgain)
{
    const GLuint name = 7;
    glBindTexture(GL_TEXTURE_2D, name);
    glPushAttrib(GL_TEXTURE_BIT);
    glDeleteTextures(1, &name);
    glPopAttrib();
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(bound, 7);
    EXPECT_TRUE(glIsTexture(name));
    glPushAttrib(GL_TEXTURE_BIT);
    glDeleteTextures(1, &name);
    glBindTexture(GL_TEXTURE_1D, name); // Now a texture of another kind.
    glPopAttrib();
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(bound, 0);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Attributes, ClientAttributesAreNotCompiled)
{
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glNewList(1, GL_COMPILE);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPopClientAttrib();
    glEndList();
    GLint alignment = 0;
    glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
    EXPECT_EQ(alignment, 1);
    glCallList(1);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

} // namespace
