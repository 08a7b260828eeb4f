#include "legacygl/state/attribute_stack.h"

#include "legacygl/state/capabilities.h"
#include "legacygl/state/state_variables.h"

#include <cstring>

namespace legacygl {
namespace {

/// Gives every field of the groups to visit, always in the same order.
template <class Visit> void visit_fields(State& state, GLbitfield groups, Visit visit)
{
    visit_variables(state, [&](GLenum, GLbitfield group, const StateField& field) {
        if (group & groups) {
            visit(field);
        }
    });
    // After the whole lights and texture units, which hold their capabilities too.
    if (groups & GL_TEXTURE_BIT) {
        visit(StateField::opaque(state.texturing.units));
        visit(StateField(state.texturing.active));
    }
    const auto visit_flag = [&](GLenum, GLbitfield group, std::uint32_t, bool& flag) {
        if ((group | GL_ENABLE_BIT) & groups) {
            visit(StateField(flag));
        }
    };
    visit_capabilities(state, visit_flag);
    for (TextureUnit& unit : state.texturing.units) {
        visit_unit_capabilities(unit, visit_flag);
    }
}

/// Gives the binding of every target of every unit to visit(target, name).
template <class Visit> void visit_bindings(TexturingState& texturing, Visit visit)
{
    for (TextureUnit& unit : texturing.units) {
        for (int target = 0; target < TEXTURE_TARGET_COUNT; ++target) {
            visit(target, unit.bound[target]);
        }
    }
}

} // namespace

SavedAttributes::SavedAttributes(State& state, GLbitfield groups) : groups_(groups)
{
    visit_fields(state, groups, [this](const StateField& field) {
        const auto* bytes = static_cast<const std::uint8_t*>(field.data);
        values_.insert(values_.end(), bytes, bytes + field.size);
    });
    if (groups & GL_TEXTURE_BIT) {
        visit_bindings(state.texturing, [&](int target, GLuint name) {
            const std::shared_ptr<Texture> texture = state.texturing.named(target, name);
            textures_.push_back({name, texture, texture->parameters});
        });
    }
}

void SavedAttributes::restore(State& state) const
{
    const std::uint8_t* from = values_.data();
    visit_fields(state, groups_, [&from](const StateField& field) {
        std::memcpy(field.data, from, field.size);
        from += field.size;
    });
    if (groups_ & GL_TEXTURE_BIT) {
        restore_textures(state);
    }
}

void SavedAttributes::restore_textures(State& state) const
{
    auto saved = textures_.begin();
    visit_bindings(state.texturing, [&](int target, GLuint& name) {
        std::shared_ptr<Texture> texture = state.texturing.named(target, name);
        if (!texture && !state.texturing.textures[name]) {
            texture = state.texturing.textures[name] = saved->texture;
        }
        if (texture) {
            texture->parameters = saved->parameters;
            texture->sampling_changed = true;
        } else {
            name = 0; // The name is now one of another target.
        }
        ++saved;
    });
}

} // namespace legacygl
