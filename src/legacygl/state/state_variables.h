#pragma once

#include "legacygl/state/state.h"
#include "legacygl/state/state_field.h"

namespace legacygl {

/// Gives every variable of the state that is no capability to visit(name, group, field): what glGet calls it
/// (0: no one name), the group of glPushAttrib that it belongs to (0: none), and where it is (OpenGL 1.5,
/// tables 6.5 to 6.21). The one table that glGet and glPushAttrib read. What depends on a texture unit or is
/// no variable is in query.cpp; what belongs to texture objects, in attribute_stack.cpp.
template <class Visit> void visit_variables(State& s, Visit&& visit)
{
    using Field = StateField;
    const auto current = [&s](Attribute a) -> glm::vec4& { return s.current[index_of(a)]; };
    visit(GL_CURRENT_COLOR, GL_CURRENT_BIT, Field::fraction(current(Attribute::color)));
    visit(GL_CURRENT_NORMAL, GL_CURRENT_BIT, Field::normal(current(Attribute::normal)));
    visit(GL_CURRENT_SECONDARY_COLOR, GL_CURRENT_BIT, Field::fraction(current(Attribute::secondary_color)));
    visit(GL_CURRENT_FOG_COORDINATE, GL_CURRENT_BIT, Field(current(Attribute::fog_coordinate).x));
    visit(GL_CURRENT_INDEX, GL_CURRENT_BIT, Field(s.color_index.current));
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        visit(0, GL_CURRENT_BIT, Field(current(texture_coordinate(unit))));
    }

    visit(GL_EDGE_FLAG, GL_CURRENT_BIT, Field(current(Attribute::edge_flag).x));
    visit(0, GL_TRANSFORM_BIT, Field::opaque(s.transform.clip_planes));
    visit(GL_MATRIX_MODE, GL_TRANSFORM_BIT, Field(s.transform.matrix_mode));
    visit(GL_VIEWPORT, GL_VIEWPORT_BIT, Field(s.transform.viewport));
    visit(GL_DEPTH_RANGE, GL_VIEWPORT_BIT, Field::fraction(s.transform.depth_range));

    LightingState& lighting = s.lighting;
    visit(GL_SHADE_MODEL, GL_LIGHTING_BIT, Field(lighting.shade_model));
    visit(GL_COLOR_MATERIAL_FACE, GL_LIGHTING_BIT, Field(lighting.color_material_face));
    visit(GL_COLOR_MATERIAL_PARAMETER, GL_LIGHTING_BIT, Field(lighting.color_material_mode));
    visit(GL_LIGHT_MODEL_AMBIENT, GL_LIGHTING_BIT, Field::fraction(lighting.model_ambient));
    visit(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHTING_BIT, Field(lighting.local_viewer));
    visit(GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHTING_BIT, Field(lighting.two_side));
    visit(0, GL_LIGHTING_BIT, Field(lighting.separate_specular));
    visit(0, GL_LIGHTING_BIT, Field::opaque(lighting.materials));
    visit(0, GL_LIGHTING_BIT, Field::opaque(lighting.lights));

    visit(GL_FOG_MODE, GL_FOG_BIT, Field(s.fog.mode));
    visit(GL_FOG_COORDINATE_SOURCE, GL_FOG_BIT, Field(s.fog.coordinate_source));
    visit(GL_FOG_COLOR, GL_FOG_BIT, Field::fraction(s.fog.color));
    visit(GL_FOG_DENSITY, GL_FOG_BIT, Field(s.fog.density));
    visit(GL_FOG_START, GL_FOG_BIT, Field(s.fog.start));
    visit(GL_FOG_END, GL_FOG_BIT, Field(s.fog.end));
    visit(GL_FOG_INDEX, GL_FOG_BIT, Field(s.fog.index));

    RasterState& raster = s.raster;
    visit(GL_POINT_SIZE, GL_POINT_BIT, Field(raster.point_size));
    visit(GL_POINT_SIZE_MIN, GL_POINT_BIT, Field(raster.point_parameters.minimum));
    visit(GL_POINT_SIZE_MAX, GL_POINT_BIT, Field(raster.point_parameters.maximum));
    visit(GL_POINT_FADE_THRESHOLD_SIZE, GL_POINT_BIT, Field(raster.point_parameters.fade_threshold));
    visit(GL_POINT_DISTANCE_ATTENUATION, GL_POINT_BIT, Field(raster.point_parameters.attenuation));
    visit(GL_LINE_WIDTH, GL_LINE_BIT, Field(raster.line_width));
    visit(GL_LINE_STIPPLE_REPEAT, GL_LINE_BIT, Field(raster.line_stipple.factor));
    visit(GL_LINE_STIPPLE_PATTERN, GL_LINE_BIT, Field(raster.line_stipple.pattern));
    visit(GL_POLYGON_MODE, GL_POLYGON_BIT, Field(raster.polygon_mode));
    visit(0, GL_POLYGON_STIPPLE_BIT, Field::opaque(raster.polygon_stipple.rows));
    visit(GL_PROVOKING_VERTEX, GL_LIGHTING_BIT, Field(raster.provoking_vertex));
    visit(GL_CULL_FACE_MODE, GL_POLYGON_BIT, Field(raster.cull_face_mode));
    visit(GL_FRONT_FACE, GL_POLYGON_BIT, Field(raster.front_face));
    visit(GL_POLYGON_OFFSET_FACTOR, GL_POLYGON_BIT, Field(raster.polygon_offset_factor));
    visit(GL_POLYGON_OFFSET_UNITS, GL_POLYGON_BIT, Field(raster.polygon_offset_units));

    FragmentState& fragment = s.fragment;
    visit(GL_SCISSOR_BOX, GL_SCISSOR_BIT, Field(fragment.scissor_box));
    visit(GL_ALPHA_TEST_FUNC, GL_COLOR_BUFFER_BIT, Field(fragment.alpha_func));
    visit(GL_ALPHA_TEST_REF, GL_COLOR_BUFFER_BIT, Field::fraction(fragment.alpha_reference));
    visit(GL_STENCIL_FUNC, GL_STENCIL_BUFFER_BIT, Field(fragment.stencil.func));
    visit(GL_STENCIL_REF, GL_STENCIL_BUFFER_BIT, Field(fragment.stencil.reference));
    visit(GL_STENCIL_VALUE_MASK, GL_STENCIL_BUFFER_BIT, Field(fragment.stencil.value_mask));
    visit(GL_STENCIL_FAIL, GL_STENCIL_BUFFER_BIT, Field(fragment.stencil.fail));
    visit(GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_BUFFER_BIT, Field(fragment.stencil.depth_fail));
    visit(GL_STENCIL_PASS_DEPTH_PASS, GL_STENCIL_BUFFER_BIT, Field(fragment.stencil.depth_pass));
    visit(GL_STENCIL_WRITEMASK, GL_STENCIL_BUFFER_BIT, Field(fragment.stencil.write_mask));
    visit(GL_STENCIL_CLEAR_VALUE, GL_STENCIL_BUFFER_BIT, Field(fragment.clear_stencil));
    visit(GL_DEPTH_FUNC, GL_DEPTH_BUFFER_BIT, Field(fragment.depth_func));
    visit(GL_DEPTH_WRITEMASK, GL_DEPTH_BUFFER_BIT, Field(fragment.depth_mask));
    visit(GL_DEPTH_CLEAR_VALUE, GL_DEPTH_BUFFER_BIT, Field::fraction(fragment.clear_depth));
    visit(GL_LOGIC_OP_MODE, GL_COLOR_BUFFER_BIT, Field(fragment.logic_op));
    visit(GL_BLEND_SRC_RGB, GL_COLOR_BUFFER_BIT, Field(fragment.blend.source_rgb));
    visit(GL_BLEND_DST_RGB, GL_COLOR_BUFFER_BIT, Field(fragment.blend.destination_rgb));
    visit(GL_BLEND_SRC_ALPHA, GL_COLOR_BUFFER_BIT, Field(fragment.blend.source_alpha));
    visit(GL_BLEND_DST_ALPHA, GL_COLOR_BUFFER_BIT, Field(fragment.blend.destination_alpha));
    visit(GL_BLEND_EQUATION, GL_COLOR_BUFFER_BIT, Field(fragment.blend.equation));
    visit(GL_BLEND_EQUATION_ALPHA, GL_COLOR_BUFFER_BIT, Field(fragment.blend.equation_alpha));
    visit(GL_BLEND_COLOR, GL_COLOR_BUFFER_BIT, Field::fraction(fragment.blend.color));
    visit(GL_COLOR_WRITEMASK, GL_COLOR_BUFFER_BIT, Field(fragment.color_mask));
    visit(GL_COLOR_CLEAR_VALUE, GL_COLOR_BUFFER_BIT, Field::fraction(fragment.clear_color));
    visit(GL_DRAW_BUFFER, GL_COLOR_BUFFER_BIT, Field(fragment.draw_buffer));
    visit(GL_READ_BUFFER, GL_PIXEL_MODE_BIT, Field(fragment.read_buffer));
    visit(GL_INDEX_WRITEMASK, GL_COLOR_BUFFER_BIT, Field(s.color_index.write_mask));
    visit(GL_INDEX_CLEAR_VALUE, GL_COLOR_BUFFER_BIT, Field(s.color_index.clear));
    visit(GL_ACCUM_CLEAR_VALUE, GL_ACCUM_BUFFER_BIT, Field::fraction(fragment.clear_accumulation));
    visit(GL_SAMPLE_COVERAGE_VALUE, GL_MULTISAMPLE_BIT, Field(s.multisample.coverage_value));
    visit(GL_SAMPLE_COVERAGE_INVERT, GL_MULTISAMPLE_BIT, Field(s.multisample.coverage_invert));

    visit(GL_PERSPECTIVE_CORRECTION_HINT, GL_HINT_BIT, Field(s.hints.perspective_correction));
    visit(GL_POINT_SMOOTH_HINT, GL_HINT_BIT, Field(s.hints.point_smooth));
    visit(GL_LINE_SMOOTH_HINT, GL_HINT_BIT, Field(s.hints.line_smooth));
    visit(GL_POLYGON_SMOOTH_HINT, GL_HINT_BIT, Field(s.hints.polygon_smooth));
    visit(GL_FOG_HINT, GL_HINT_BIT, Field(s.hints.fog));
    visit(GL_GENERATE_MIPMAP_HINT, GL_HINT_BIT, Field(s.hints.generate_mipmap));
    visit(GL_TEXTURE_COMPRESSION_HINT, GL_HINT_BIT, Field(s.hints.texture_compression));
    visit(GL_LIST_BASE, GL_LIST_BIT, Field(s.list_base));

    visit(GL_PACK_SWAP_BYTES, 0, Field(s.pack.swap_bytes));
    visit(GL_PACK_LSB_FIRST, 0, Field(s.pack.lsb_first));
    visit(GL_PACK_ROW_LENGTH, 0, Field(s.pack.row_length));
    visit(GL_PACK_SKIP_ROWS, 0, Field(s.pack.skip_rows));
    visit(GL_PACK_SKIP_PIXELS, 0, Field(s.pack.skip_pixels));
    visit(GL_PACK_ALIGNMENT, 0, Field(s.pack.alignment));
    visit(GL_UNPACK_SWAP_BYTES, 0, Field(s.unpack.swap_bytes));
    visit(GL_UNPACK_LSB_FIRST, 0, Field(s.unpack.lsb_first));
    visit(GL_UNPACK_ROW_LENGTH, 0, Field(s.unpack.row_length));
    visit(GL_UNPACK_SKIP_ROWS, 0, Field(s.unpack.skip_rows));
    visit(GL_UNPACK_SKIP_PIXELS, 0, Field(s.unpack.skip_pixels));
    visit(GL_UNPACK_ALIGNMENT, 0, Field(s.unpack.alignment));
}

} // namespace legacygl
