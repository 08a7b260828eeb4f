#include "legacygl/backend/es3_fixed_state.h"

namespace legacygl {

void Es3FixedState::set_enabled(GLenum capability, bool enabled)
{
    enabled ? gl_.Enable(capability) : gl_.Disable(capability);
}

void Es3FixedState::apply(const StencilState& s)
{
    set_enabled(GL_STENCIL_TEST, s.enabled);
    gl_.StencilFunc(s.func, s.reference, s.value_mask);
    gl_.StencilOp(s.fail, s.depth_fail, s.depth_pass);
    gl_.StencilMask(s.write_mask);
}

void Es3FixedState::apply(const BlendState& b)
{
    set_enabled(GL_BLEND, b.enabled);
    gl_.BlendFuncSeparate(b.source_rgb, b.destination_rgb, b.source_alpha, b.destination_alpha);
    gl_.BlendEquationSeparate(b.equation, b.equation_alpha);
    gl_.BlendColor(b.color.r, b.color.g, b.color.b, b.color.a);
}

void Es3FixedState::apply(const Pipeline& p)
{
    if (known_ && *known_ == p) {
        return;
    }
    const bool all = !known_;
    const Pipeline& old = all ? p : *known_;
    if (all || old.draws_front != p.draws_front || old.draws_back != p.draws_back) {
        target_.draw_into(p.draws_front, p.draws_back);
    }
    if (all || old.viewport != p.viewport) {
        gl_.Viewport(p.viewport[0], p.viewport[1], p.viewport[2], p.viewport[3]);
    }
    if (all || old.depth_range != p.depth_range) {
        gl_.DepthRangef(p.depth_range[0], p.depth_range[1]);
    }
    if (all || old.depth_test != p.depth_test) {
        set_enabled(GL_DEPTH_TEST, p.depth_test);
    }
    if (all || old.depth_mask != p.depth_mask) {
        gl_.DepthMask(p.depth_mask);
    }
    if (all || old.depth_func != p.depth_func) {
        gl_.DepthFunc(p.depth_func);
    }
    if (all || old.cull_face != p.cull_face) {
        set_enabled(GL_CULL_FACE, p.cull_face);
    }
    if (all || old.cull_face_mode != p.cull_face_mode) {
        gl_.CullFace(p.cull_face_mode);
    }
    if (all || old.front_face != p.front_face) {
        gl_.FrontFace(p.front_face);
    }
    if (all || old.scissor_test != p.scissor_test) {
        set_enabled(GL_SCISSOR_TEST, p.scissor_test);
    }
    if (all || old.scissor_box != p.scissor_box) {
        gl_.Scissor(p.scissor_box[0], p.scissor_box[1], p.scissor_box[2], p.scissor_box[3]);
    }
    if (all || !(old.stencil == p.stencil)) {
        apply(p.stencil);
    }
    if (all || !(old.blend == p.blend)) {
        apply(p.blend);
    }
    if (all || old.polygon_offset != p.polygon_offset) {
        set_enabled(GL_POLYGON_OFFSET_FILL, p.polygon_offset);
    }
    if (all || old.polygon_offset_factor_units != p.polygon_offset_factor_units) {
        gl_.PolygonOffset(p.polygon_offset_factor_units[0], p.polygon_offset_factor_units[1]);
    }
    if (all || old.color_mask != p.color_mask) {
        gl_.ColorMask(p.color_mask[0], p.color_mask[1], p.color_mask[2], p.color_mask[3]);
    }
    if (all || old.dither != p.dither) {
        set_enabled(GL_DITHER, p.dither);
    }
    if (all || old.line_width != p.line_width) {
        gl_.LineWidth(p.line_width);
    }
    known_ = p;
}

} // namespace legacygl
