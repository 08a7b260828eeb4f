// Textures by name (OpenGL 1.5, 3.8.12).

#include "legacygl/context/dispatch.h"
#include "legacygl/pixel/texture_targets.h"

#include <algorithm>

using namespace legacygl;

namespace {

/// Returns the texture of a name, or null; names that are only reserved have none.
Texture* find_texture(Context& gl, GLuint name)
{
    const auto found = gl.state.texturing.textures.find(name);
    return found == gl.state.texturing.textures.end() ? nullptr : found->second.get();
}

} // namespace

extern "C" {

void glGenTextures(GLsizei n, GLuint* textures)
{
    dispatch_now(
        __func__,
        [textures](Context& gl, GLsizei count) {
            if (count < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            auto& all = gl.state.texturing.textures;
            GLuint name = 1;
            for (GLsizei i = 0; i < count; ++i, ++name) {
                while (all.contains(name)) {
                    ++name;
                }
                all[name] = nullptr; // Reserved; a texture from its first binding on.
                textures[i] = name;
            }
        },
        n);
}

void glDeleteTextures(GLsizei n, const GLuint* textures)
{
    dispatch_now(
        __func__,
        [textures](Context& gl, GLsizei count) {
            if (count < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            TexturingState& state = gl.state.texturing;
            for (GLsizei i = 0; i < count; ++i) {
                if (textures[i] == 0) {
                    continue;
                }
                for (TextureUnit& unit : state.units) {
                    for (GLuint& name : unit.bound) {
                        if (name == textures[i]) {
                            name = 0;
                        }
                    }
                }
                state.textures.erase(textures[i]);
            }
            gl.renderer.changed(change::texturing);
        },
        n);
}

GLboolean glIsTexture(GLuint texture)
{
    bool is_texture = false;
    dispatch_now(
        __func__,
        [&is_texture](Context& gl, GLuint name) {
            const auto found = gl.state.texturing.textures.find(name);
            is_texture = name != 0 && found != gl.state.texturing.textures.end() && found->second;
        },
        texture);
    return is_texture;
}

void glBindTexture(GLenum target, GLuint texture)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum t, GLuint name) {
            if (!is_texture_target(t)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            if (name != 0) {
                std::shared_ptr<Texture>& object = gl.state.texturing.textures[name];
                if (!object) {
                    object = std::make_shared<Texture>();
                    object->target = t;
                }
                if (object->target != t) {
                    return gl.set_error(GL_INVALID_OPERATION);
                }
            }
            gl.state.texturing.unit().bound[t - GL_TEXTURE_1D] = name;
            gl.renderer.changed(change::texturing);
        },
        target, texture);
}

void glPrioritizeTextures(GLsizei n, const GLuint* textures, const GLclampf* priorities)
{
    const std::size_t count = n > 0 ? static_cast<std::size_t>(n) : 0;
    dispatch(
        __func__,
        [](Context& gl, GLsizei size, const Blob& names, const Blob& values) {
            if (size < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            for (GLsizei i = 0; i < size; ++i) {
                if (Texture* texture = find_texture(gl, static_cast<const GLuint*>(names.data)[i])) {
                    texture->parameters.priority =
                        std::clamp(static_cast<const GLclampf*>(values.data)[i], 0.0f, 1.0f);
                }
            }
        },
        n, Blob{textures, count * sizeof(GLuint)}, Blob{priorities, count * sizeof(GLclampf)});
}

/// All textures are resident: where they lie is the ES implementation's.
GLboolean glAreTexturesResident(GLsizei n, const GLuint* textures, GLboolean*)
{
    bool resident = false;
    dispatch_now(
        __func__,
        [&resident, textures](Context& gl, GLsizei count) {
            for (GLsizei i = 0; i < count; ++i) {
                if (!find_texture(gl, textures[i])) {
                    return gl.set_error(GL_INVALID_VALUE);
                }
            }
            if (count < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            resident = true;
        },
        n);
    return resident;
}

} // extern "C"
