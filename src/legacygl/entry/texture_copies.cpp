// Copies from the frame buffer into textures (OpenGL 1.5, 3.8.2).

#include "legacygl/context/dispatch.h"
#include "legacygl/pixel/pixel_format.h"
#include "legacygl/pixel/read_back.h"
#include "legacygl/pixel/texture_image.h"
#include "legacygl/pixel/texture_targets.h"
#include "legacygl/state/internal_format.h"

using namespace legacygl;

namespace {

/// The part of the frame buffer that is copied.
struct Source
{
    GLint x, y;
    GLsizei width, height;
};

bool is_copied_format(GLenum internal_format)
{
    return internal_format > 4 && base_format(static_cast<GLint>(internal_format)) != BaseFormat::none;
}

/// Copies the part of the source that is inside the frame buffer to (x, y) of a level.
void copy_part(Context& gl, Texture& texture, GLint level, int x, int y, const Source& source)
{
    const PixelRectangle r = clip_to_frame(gl, source.x, source.y, source.width, source.height);
    if (!r.empty()) {
        set_part(texture, level, {x + r.skipped_left, y + r.skipped_below, r.width, r.height},
                 read_frame(gl, r));
    }
    gl.renderer.changed(change::texturing);
}

void copy_image(Context& gl, GLenum target, GLint level, GLenum internal_format, Source source, GLint border)
{
    const int most = is_level(gl, level) ? gl.backend->maximum_texture_size >> level : 0;
    if (most == 0 || border < 0 || border > 1) {
        return gl.set_error(GL_INVALID_VALUE);
    }
    if (!is_copied_format(internal_format)) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    source.x += border;
    source.width -= 2 * border;
    if (target == GL_TEXTURE_2D) {
        source.y += border;
        source.height -= 2 * border;
    }
    if (source.width < 0 || source.height < 0 || source.width > most || source.height > most) {
        return gl.set_error(GL_INVALID_VALUE);
    }
    Texture& texture = bound_texture(gl, target);
    set_level(texture, level, static_cast<GLint>(internal_format), source.width, source.height, {});
    copy_part(gl, texture, level, 0, 0, source);
}

void copy_sub_image(Context& gl, GLenum target, GLint level, GLint x, GLint y, const Source& source)
{
    if (!is_level(gl, level) || source.width < 0 || source.height < 0) {
        return gl.set_error(GL_INVALID_VALUE);
    }
    Texture& texture = bound_texture(gl, target);
    if (static_cast<std::size_t>(level) >= texture.levels.size() || texture.levels[level].width == 0) {
        return gl.set_error(GL_INVALID_OPERATION);
    }
    const TextureImage& image = texture.levels[level];
    if (x < 0 || y < 0 || x + source.width > image.width || y + source.height > image.height) {
        return gl.set_error(GL_INVALID_VALUE);
    }
    copy_part(gl, texture, level, x, y, source);
}

} // namespace

extern "C" {

void glCopyTexImage1D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width,
                      GLint border)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum t, GLint l, GLenum f, GLint left, GLint bottom, GLsizei w, GLint b) {
            t == GL_TEXTURE_1D ? copy_image(gl, t, l, f, {left, bottom, w, 1}, b)
                               : gl.set_error(GL_INVALID_ENUM);
        },
        target, level, internalformat, x, y, width, border);
}

void glCopyTexImage2D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width,
                      GLsizei height, GLint border)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum t, GLint l, GLenum f, GLint left, GLint bottom, GLsizei w, GLsizei h,
           GLint b) {
            t == GL_TEXTURE_2D ? copy_image(gl, t, l, f, {left, bottom, w, h}, b)
                               : gl.set_error(GL_INVALID_ENUM);
        },
        target, level, internalformat, x, y, width, height, border);
}

void glCopyTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLint x, GLint y, GLsizei width)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum t, GLint l, GLint to, GLint left, GLint bottom, GLsizei w) {
            t == GL_TEXTURE_1D ? copy_sub_image(gl, t, l, to, 0, {left, bottom, w, 1})
                               : gl.set_error(GL_INVALID_ENUM);
        },
        target, level, xoffset, x, y, width);
}

void glCopyTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x, GLint y,
                         GLsizei width, GLsizei height)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum t, GLint l, GLint to_x, GLint to_y, GLint left, GLint bottom, GLsizei w,
           GLsizei h) {
            t == GL_TEXTURE_2D ? copy_sub_image(gl, t, l, to_x, to_y, {left, bottom, w, h})
                               : gl.set_error(GL_INVALID_ENUM);
        },
        target, level, xoffset, yoffset, x, y, width, height);
}

} // extern "C"
