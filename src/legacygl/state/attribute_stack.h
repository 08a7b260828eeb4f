#pragma once

#include "legacygl/state/state.h"
#include "legacygl/vertex/client_arrays.h"

#include <GL/gl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace legacygl {

/// The depth of both attribute stacks, the least that OpenGL 1.5, table 6.34, allows.
constexpr std::size_t ATTRIBUTE_STACK_DEPTH = 16;

/// What glPushAttrib saved of the groups it was given (OpenGL 1.5, 6.1.14).
class SavedAttributes
{
public:
    SavedAttributes(State& state, GLbitfield groups);
    /// Puts back what was saved. A texture that was deleted meanwhile has its name again.
    void restore(State& state) const;

private:
    /// A texture that was bound, and its parameters, which belong to the group of textures too.
    struct BoundTexture
    {
        GLuint name;
        std::shared_ptr<Texture> texture; ///< It lives as long as it can be bound again.
        TextureParameters parameters;
    };
    void restore_textures(State& state) const;

    GLbitfield groups_;
    std::vector<std::uint8_t> values_; ///< Of the groups' fields, in the order of their tables.
    std::vector<BoundTexture> textures_;
};

/// What glPushClientAttrib saved; empty: a group it was not given.
struct SavedClientAttributes
{
    struct Arrays
    {
        ClientArrays arrays;
        int client_active;
    };
    struct PixelStores
    {
        PixelStore pack, unpack;
    };
    std::optional<Arrays> arrays;
    std::optional<PixelStores> pixel_stores;
};

} // namespace legacygl
