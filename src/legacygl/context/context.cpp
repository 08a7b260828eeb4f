#include "legacygl/context/context.h"

#include "legacygl/context/list_replay.h"

namespace legacygl {
Context* current_context = nullptr;

Context::Context(std::unique_ptr<Backend> made, int w, int h, bool doubled)
    : backend(std::move(made)), renderer(*backend), double_buffered(doubled)
{
    backend->target_width = w;
    backend->target_height = h;
    state.fragment.draw_buffer = state.fragment.read_buffer = doubled ? GL_BACK : GL_FRONT;
    state.transform.viewport = state.fragment.scissor_box = {0, 0, w, h};
}

void Context::begin(GLenum mode)
{
    if (immediate.inside()) {
        return set_error(GL_INVALID_OPERATION);
    }
    if (mode > GL_POLYGON) {
        return set_error(GL_INVALID_ENUM);
    }
    if (const std::uint32_t set = immediate.set_between()) {
        begin_varying(set);
    }
    if (!immediate.has_vertices()) {
        immediate.set_wanted(renderer.attributes_read(state));
    }
    immediate.begin(mode);
}

void Context::end()
{
    if (!immediate.inside()) {
        return set_error(GL_INVALID_OPERATION);
    }
    immediate.end();
}

void Context::begin_varying(std::uint32_t set)
{
    std::uint32_t interpolated = state.lighting.enabled ? 0 : bit_of(Attribute::color);
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        if (state.texturing.used(state.texturing.units[unit])) {
            interpolated |= bit_of(texture_coordinate(unit));
        }
    }
    if ((set & interpolated) == 0) {
        return;
    }
    const std::uint32_t varying = immediate.batch().attributes_varying | (set & interpolated);
    draw_vertices();
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i) {
        if (varying & (1u << i)) {
            immediate.set_varying(static_cast<Attribute>(i));
        }
    }
}

void Context::draw_vertices()
{
    renderer.draw(state, immediate.batch());
    immediate.clear();
}

void Context::call_list(GLuint name)
{
    if (list_depth >= MAX_LIST_NESTING_DEPTH) {
        return;
    }
    if (DisplayList* list = lists.find(name)) {
        ++list_depth;
        list->run(*this, replay);
        --list_depth;
    }
}

MatrixStack& Context::current_matrix_stack()
{
    switch (state.transform.matrix_mode) {
    case GL_PROJECTION:
        return state.transform.projection;
    case GL_TEXTURE:
        return state.transform.texture[state.texturing.active];
    default:
        return state.transform.modelview;
    }
}

void Context::store_followed_color()
{
    LightingState& lighting = state.lighting;
    const glm::vec4 color = state.current[index_of(Attribute::color)];
    for (int face = 0; face < 2; ++face) {
        for (int p = 0; p < MATERIAL_PROPERTY_COUNT; ++p) {
            if (lighting.follows_color(face, static_cast<MaterialProperty>(p))) {
                lighting.materials[face].colors[p] = color;
            }
        }
    }
}

} // namespace legacygl
