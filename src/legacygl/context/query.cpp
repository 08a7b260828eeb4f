#include "legacygl/context/query.h"

#include "legacygl/context/client_array_names.h"
#include "legacygl/context/context.h"
#include "legacygl/state/capabilities.h"
#include "legacygl/state/state_variables.h"

namespace legacygl {
namespace {

using Kind = QueryValue::Kind;

/// What never changes (OpenGL 1.5, tables 6.31 to 6.36).
struct Constant
{
    GLenum name;
    QueryValue::Kind kind;
    double value;
};

constexpr Constant CONSTANTS[] = {
    {GL_MAX_LIGHTS, Kind::integer, LIGHT_COUNT},
    {GL_MAX_LIST_NESTING, Kind::integer, MAX_LIST_NESTING_DEPTH},
    {GL_MAX_ATTRIB_STACK_DEPTH, Kind::integer, ATTRIBUTE_STACK_DEPTH},
    {GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, Kind::integer, ATTRIBUTE_STACK_DEPTH},
    {GL_MAX_TEXTURE_UNITS, Kind::integer, TEXTURE_UNIT_COUNT},
    {GL_MAX_TEXTURE_LOD_BIAS, Kind::real, static_cast<double>(MAX_LOD_BIAS)},
    {GL_MAX_ELEMENTS_INDICES, Kind::integer, 3000},
    {GL_MAX_ELEMENTS_VERTICES, Kind::integer, 3000},
    {GL_NUM_COMPRESSED_TEXTURE_FORMATS, Kind::integer, 0},
    {GL_MAX_CLIP_PLANES, Kind::integer, CLIP_PLANE_COUNT},
    {GL_MAX_NAME_STACK_DEPTH, Kind::integer, 64},
    {GL_NAME_STACK_DEPTH, Kind::integer, 0}, // Outside selection, which is not implemented.
    {GL_POINT_SIZE_GRANULARITY, Kind::real, static_cast<double>(SIZE_GRANULARITY)},
    {GL_LINE_WIDTH_GRANULARITY, Kind::real, static_cast<double>(SIZE_GRANULARITY)},
    {GL_SUBPIXEL_BITS, Kind::integer, 8},
    {GL_AUX_BUFFERS, Kind::integer, 0},
    {GL_RGBA_MODE, Kind::boolean, 1},
    {GL_INDEX_MODE, Kind::boolean, 0},
    {GL_STEREO, Kind::boolean, 0},
    {GL_SAMPLE_BUFFERS, Kind::integer, 0},
    {GL_SAMPLES, Kind::integer, 0},
    {GL_INDEX_BITS, Kind::integer, 0},
    {GL_RED_BITS, Kind::integer, 8},
    {GL_GREEN_BITS, Kind::integer, 8},
    {GL_BLUE_BITS, Kind::integer, 8},
    {GL_ALPHA_BITS, Kind::integer, 8},
    {GL_DEPTH_BITS, Kind::integer, 24},
    {GL_STENCIL_BITS, Kind::integer, 8},
    {GL_ACCUM_RED_BITS, Kind::integer, 0},
    {GL_ACCUM_GREEN_BITS, Kind::integer, 0},
    {GL_ACCUM_BLUE_BITS, Kind::integer, 0},
    {GL_ACCUM_ALPHA_BITS, Kind::integer, 0},
    {GL_RENDER_MODE, Kind::integer, GL_RENDER},
};

QueryValue matrix(const MatrixStack& stack, bool transposed = false)
{
    QueryValue out{Kind::real, 0};
    out.count = 16;
    for (int i = 0; i < 16; ++i) {
        out.values[i] = static_cast<double>(stack.top().values()[transposed ? i % 4 * 4 + i / 4 : i]);
    }
    return out;
}

QueryValue query_transform(const State& s, GLenum name)
{
    const TransformState& transform = s.transform;
    const MatrixStack& texture = transform.texture[s.texturing.active];
    const auto size = [](std::size_t n) { return QueryValue::integer(static_cast<double>(n)); };
    switch (name) {
    case GL_MODELVIEW_MATRIX:
        return matrix(transform.modelview);
    case GL_PROJECTION_MATRIX:
        return matrix(transform.projection);
    case GL_TEXTURE_MATRIX:
        return matrix(texture);
    case GL_TRANSPOSE_MODELVIEW_MATRIX:
        return matrix(transform.modelview, true);
    case GL_TRANSPOSE_PROJECTION_MATRIX:
        return matrix(transform.projection, true);
    case GL_TRANSPOSE_TEXTURE_MATRIX:
        return matrix(texture, true);
    case GL_MODELVIEW_STACK_DEPTH:
        return size(transform.modelview.depth());
    case GL_PROJECTION_STACK_DEPTH:
        return size(transform.projection.depth());
    case GL_TEXTURE_STACK_DEPTH:
        return size(texture.depth());
    case GL_MAX_MODELVIEW_STACK_DEPTH:
        return size(transform.modelview.capacity());
    case GL_MAX_PROJECTION_STACK_DEPTH:
        return size(transform.projection.capacity());
    case GL_MAX_TEXTURE_STACK_DEPTH:
        return size(texture.capacity());
    default:
        return {};
    }
}

QueryValue query_variable(State& s, GLenum name)
{
    QueryValue out;
    visit_variables(s, [&](GLenum n, GLbitfield, const StateField& field) {
        if (n == name && n != 0) {
            out = QueryValue(field);
        }
    });
    return out;
}

QueryValue query_array(const Context& gl, GLenum name)
{
    for (const ClientArrayNames& names : CLIENT_ARRAY_NAMES) {
        const ClientArray& array = *gl.client_arrays.find(names.array, gl.state.texturing.client_active);
        if (name == names.array) {
            return QueryValue::boolean(array.enabled);
        }
        if (name == names.size) {
            return QueryValue::integer(array.size);
        }
        if (name == names.type) {
            return QueryValue::integer(array.type);
        }
        if (name == names.stride) {
            return QueryValue::integer(array.stride);
        }
        if (name == names.buffer) {
            return QueryValue::integer(array.buffer_name);
        }
    }
    return {};
}

/// What is computed, or depends on a selector.
QueryValue query_other(const Context& gl, GLenum name)
{
    const State& s = gl.state;
    const auto integer = [](auto value) { return QueryValue::integer(static_cast<double>(value)); };
    switch (name) {
    case GL_CURRENT_TEXTURE_COORDS: {
        glm::vec4 coordinates = s.current[index_of(texture_coordinate(s.texturing.active))];
        return QueryValue(StateField(coordinates));
    }
    case GL_LIGHT_MODEL_COLOR_CONTROL:
        return integer(s.lighting.separate_specular ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    case GL_BLEND_SRC:
        return integer(s.fragment.blend.source_rgb);
    case GL_BLEND_DST:
        return integer(s.fragment.blend.destination_rgb);
    case GL_ACTIVE_TEXTURE:
        return integer(GL_TEXTURE0 + s.texturing.active);
    case GL_CLIENT_ACTIVE_TEXTURE:
        return integer(GL_TEXTURE0 + s.texturing.client_active);
    case GL_TEXTURE_BINDING_1D:
        return integer(s.texturing.unit().bound[0]);
    case GL_TEXTURE_BINDING_2D:
        return integer(s.texturing.unit().bound[1]);
    case GL_ARRAY_BUFFER_BINDING:
        return integer(gl.client_arrays.bound_array_buffer);
    case GL_ELEMENT_ARRAY_BUFFER_BINDING:
        return integer(gl.client_arrays.bound_element_buffer);
    case GL_LIST_MODE:
        return integer(gl.compiler ? (gl.compiler->executes() ? GL_COMPILE_AND_EXECUTE : GL_COMPILE) : 0);
    case GL_LIST_INDEX:
        return integer(gl.compiler ? gl.compiler->name() : 0);
    case GL_DOUBLEBUFFER:
        return QueryValue::boolean(gl.double_buffered);
    case GL_MAX_TEXTURE_SIZE:
        return integer(gl.backend->maximum_texture_size);
    case GL_POINT_SIZE_RANGE:
    case GL_ALIASED_POINT_SIZE_RANGE: {
        std::array<GLfloat, 2> sizes{1, MAX_POINT_SIZE};
        return QueryValue(StateField(sizes));
    }
    case GL_LINE_WIDTH_RANGE:
    case GL_ALIASED_LINE_WIDTH_RANGE: {
        std::array<GLfloat, 2> widths{1, MAX_LINE_WIDTH};
        return QueryValue(StateField(widths));
    }
    case GL_MAX_VIEWPORT_DIMS: {
        std::array<GLint, 2> sizes{gl.backend->maximum_viewport_size, gl.backend->maximum_viewport_size};
        return QueryValue(StateField(sizes));
    }
    case GL_ATTRIB_STACK_DEPTH:
        return integer(gl.attributes.size());
    case GL_CLIENT_ATTRIB_STACK_DEPTH:
        return integer(gl.client_attributes.size());
    default:
        break;
    }
    for (const Constant& constant : CONSTANTS) {
        if (constant.name == name) {
            return {constant.kind, constant.value};
        }
    }
    return {};
}

} // namespace

QueryValue::QueryValue(const StateField& field) : count(field.count)
{
    const auto take = [&](auto type, Kind k) {
        kind = k;
        for (int i = 0; i < count; ++i) {
            values[i] = static_cast<double>(static_cast<const decltype(type)*>(field.data)[i]);
        }
    };
    switch (field.kind) {
    case StateField::Kind::boolean:
        take(bool{}, Kind::boolean);
        break;
    case StateField::Kind::signed_integer:
        take(GLint{}, Kind::integer);
        break;
    case StateField::Kind::unsigned_integer:
        take(GLuint{}, Kind::integer);
        break;
    case StateField::Kind::unsigned_short:
        take(GLushort{}, Kind::integer);
        break;
    case StateField::Kind::real:
        take(GLfloat{}, Kind::real);
        break;
    case StateField::Kind::fraction:
        take(GLfloat{}, Kind::fraction);
        break;
    case StateField::Kind::double_fraction:
        take(GLdouble{}, Kind::fraction);
        break;
    case StateField::Kind::opaque:
        break;
    }
}

QueryValue query(const Context& gl, GLenum name)
{
    // The tables serve reading and writing; nothing is written here.
    State& state = const_cast<State&>(gl.state);
    if (const QueryValue value = query_transform(state, name); value.count != 0) {
        return value;
    }
    if (const QueryValue value = query_variable(state, name); value.count != 0) {
        return value;
    }
    if (const Capability found = find_capability(state, name); found.flag) {
        return QueryValue::boolean(*found.flag);
    }
    if (const QueryValue value = query_array(gl, name); value.count != 0) {
        return value;
    }
    return query_other(gl, name);
}

} // namespace legacygl
