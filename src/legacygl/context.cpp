#include "legacygl/context.h"

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
    if (immediate.inside())
        return set_error(GL_INVALID_OPERATION);
    if (mode > GL_POLYGON)
        return set_error(GL_INVALID_ENUM);
    if (immediate.set_between(Attribute::color) && !state.lighting.enabled)
        begin_varying_colors();
    if (!immediate.has_vertices())
        immediate.set_wanted(renderer.attributes_read(state));
    immediate.begin(mode);
}

void Context::end()
{
    if (!immediate.inside())
        return set_error(GL_INVALID_OPERATION);
    immediate.end();
}

void Context::begin_varying_colors()
{
    if (immediate.batch().varies(Attribute::color))
        return;
    draw_vertices();
    immediate.set_varying(Attribute::color);
}

void Context::draw_vertices()
{
    renderer.draw(state, immediate.batch());
    immediate.clear();
}

void Context::call_list(GLuint name)
{
    if (list_depth >= MAXIMUM_LIST_NESTING)
        return;
    if (DisplayList* list = lists.find(name)) {
        ++list_depth;
        list->run(*this);
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
    for (int face = 0; face < 2; ++face)
        for (int p = 0; p < MATERIAL_PROPERTY_COUNT; ++p)
            if (lighting.follows_color(face, static_cast<MaterialProperty>(p)))
                lighting.materials[face].colors[p] = color;
}

} // namespace legacygl
