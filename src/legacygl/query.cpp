#include "legacygl/query.h"

#include "legacygl/capabilities.h"
#include "legacygl/context.h"

#include <span>

namespace legacygl {
namespace {

QueryValue make(QueryValue::Kind kind, std::span<const float> values)
{
    QueryValue out{kind, static_cast<int>(values.size()), {}};
    for (std::size_t i = 0; i < values.size(); ++i)
        out.values[i] = static_cast<double>(values[i]);
    return out;
}

QueryValue integer(double value)
{
    return {QueryValue::Kind::integer, 1, {value}};
}

QueryValue boolean(bool value)
{
    return {QueryValue::Kind::boolean, 1, {value ? 1.0 : 0.0}};
}

QueryValue real(float value)
{
    return make(QueryValue::Kind::real, {&value, 1});
}

QueryValue color(const glm::vec4& v)
{
    return make(QueryValue::Kind::normalized, {&v.x, 4});
}

QueryValue matrix(const MatrixStack& stack)
{
    return make(QueryValue::Kind::real, {stack.top().values(), 16});
}

} // namespace

QueryValue query(const Context& gl, GLenum name)
{
    using Kind = QueryValue::Kind;
    const State& s = gl.state;
    switch (name) {
    case GL_MODELVIEW_MATRIX:
        return matrix(s.transform.modelview);
    case GL_PROJECTION_MATRIX:
        return matrix(s.transform.projection);
    case GL_TEXTURE_MATRIX:
        return matrix(s.transform.texture[s.texturing.active]);
    case GL_MODELVIEW_STACK_DEPTH:
        return integer(static_cast<double>(s.transform.modelview.depth()));
    case GL_PROJECTION_STACK_DEPTH:
        return integer(static_cast<double>(s.transform.projection.depth()));
    case GL_TEXTURE_STACK_DEPTH:
        return integer(static_cast<double>(s.transform.texture[s.texturing.active].depth()));
    case GL_MAX_MODELVIEW_STACK_DEPTH:
        return integer(static_cast<double>(s.transform.modelview.capacity()));
    case GL_MAX_PROJECTION_STACK_DEPTH:
        return integer(static_cast<double>(s.transform.projection.capacity()));
    case GL_MAX_TEXTURE_STACK_DEPTH:
        return integer(static_cast<double>(s.transform.texture[0].capacity()));
    case GL_MATRIX_MODE:
        return integer(s.transform.matrix_mode);
    case GL_VIEWPORT: {
        QueryValue out{Kind::integer, 4, {}};
        for (int i = 0; i < 4; ++i)
            out.values[i] = s.transform.viewport[i];
        return out;
    }
    case GL_DEPTH_RANGE:
        return make(Kind::normalized, s.transform.depth_range);
    case GL_CURRENT_COLOR:
        return color(s.current[index_of(Attribute::color)]);
    case GL_CURRENT_NORMAL:
        return make(Kind::normalized, {&s.current[index_of(Attribute::normal)].x, 3});
    case GL_CURRENT_TEXTURE_COORDS:
        return make(Kind::real, {&s.current[index_of(texture_coordinate(s.texturing.active))].x, 4});
    case GL_SHADE_MODEL:
        return integer(s.lighting.shade_model);
    case GL_LIGHT_MODEL_AMBIENT:
        return color(s.lighting.model_ambient);
    case GL_LIGHT_MODEL_LOCAL_VIEWER:
        return boolean(s.lighting.local_viewer);
    case GL_LIGHT_MODEL_TWO_SIDE:
        return boolean(s.lighting.two_side);
    case GL_LIGHT_MODEL_COLOR_CONTROL:
        return integer(s.lighting.separate_specular ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    case GL_COLOR_MATERIAL_FACE:
        return integer(s.lighting.color_material_face);
    case GL_COLOR_MATERIAL_PARAMETER:
        return integer(s.lighting.color_material_mode);
    case GL_MAX_LIGHTS:
        return integer(LIGHT_COUNT);
    case GL_TEXTURE_BINDING_2D:
        return integer(s.texturing.unit().bound[1]);
    case GL_MAX_TEXTURE_SIZE:
        return integer(2048);
    case GL_CULL_FACE_MODE:
        return integer(s.raster.cull_face_mode);
    case GL_FRONT_FACE:
        return integer(s.raster.front_face);
    case GL_LINE_WIDTH:
        return real(s.raster.line_width);
    case GL_POINT_SIZE:
        return real(s.raster.point_size);
    case GL_DEPTH_FUNC:
        return integer(s.fragment.depth_func);
    case GL_DEPTH_WRITEMASK:
        return boolean(s.fragment.depth_mask);
    case GL_DEPTH_CLEAR_VALUE:
        return make(Kind::normalized, {&s.fragment.clear_depth, 1});
    case GL_STENCIL_CLEAR_VALUE:
        return integer(s.fragment.clear_stencil);
    case GL_COLOR_CLEAR_VALUE:
        return color(s.fragment.clear_color);
    case GL_BLEND_SRC:
        return integer(s.fragment.blend.source_rgb);
    case GL_BLEND_DST:
        return integer(s.fragment.blend.destination_rgb);
    case GL_COLOR_WRITEMASK: {
        QueryValue out{Kind::boolean, 4, {}};
        for (int i = 0; i < 4; ++i)
            out.values[i] = s.fragment.color_mask[i] ? 1 : 0;
        return out;
    }
    case GL_LIST_MODE:
        return integer(gl.compiler ? (gl.compiler->executes() ? GL_COMPILE_AND_EXECUTE : GL_COMPILE) : 0);
    case GL_LIST_INDEX:
        return integer(gl.compiler ? gl.compiler->name() : 0);
    case GL_LIST_BASE:
        return integer(gl.list_base);
    case GL_MAX_LIST_NESTING:
        return integer(64);
    case GL_PACK_SWAP_BYTES:
        return boolean(s.pack.swap_bytes);
    case GL_PACK_LSB_FIRST:
        return boolean(s.pack.lsb_first);
    case GL_PACK_ROW_LENGTH:
        return integer(s.pack.row_length);
    case GL_PACK_SKIP_ROWS:
        return integer(s.pack.skip_rows);
    case GL_PACK_SKIP_PIXELS:
        return integer(s.pack.skip_pixels);
    case GL_UNPACK_SWAP_BYTES:
        return boolean(s.unpack.swap_bytes);
    case GL_UNPACK_LSB_FIRST:
        return boolean(s.unpack.lsb_first);
    case GL_UNPACK_ROW_LENGTH:
        return integer(s.unpack.row_length);
    case GL_UNPACK_SKIP_ROWS:
        return integer(s.unpack.skip_rows);
    case GL_UNPACK_SKIP_PIXELS:
        return integer(s.unpack.skip_pixels);
    case GL_PACK_ALIGNMENT:
        return integer(s.pack.alignment);
    case GL_UNPACK_ALIGNMENT:
        return integer(s.unpack.alignment);
    default:
        break;
    }
    // The table of capabilities serves reading and writing; nothing is written here.
    const Capability found = find_capability(const_cast<State&>(s), name);
    return found.flag ? boolean(*found.flag) : QueryValue{};
}

} // namespace legacygl
