// Pixel storage and reading back (OpenGL 1.5, 3.6.1 and 4.3.2).

#include "legacygl/context/dispatch.h"
#include "legacygl/pixel/pixel_conversion.h"
#include "legacygl/pixel/read_back.h"

#include <vector>

using namespace legacygl;

namespace {

void set_store(Context& gl, GLenum name, GLint value)
{
    const bool packs = name >= GL_PACK_SWAP_BYTES && name <= GL_PACK_ALIGNMENT;
    PixelStore& store = packs ? gl.state.pack : gl.state.unpack;
    const auto set = [&](GLint& member) {
        if (value < 0) {
            return gl.set_error(GL_INVALID_VALUE);
        }
        member = value;
    };
    switch (name) {
    case GL_PACK_SWAP_BYTES:
    case GL_UNPACK_SWAP_BYTES:
        store.swap_bytes = value != 0;
        return;
    case GL_PACK_LSB_FIRST:
    case GL_UNPACK_LSB_FIRST:
        store.lsb_first = value != 0;
        return;
    case GL_PACK_ROW_LENGTH:
    case GL_UNPACK_ROW_LENGTH:
        return set(store.row_length);
    case GL_PACK_SKIP_ROWS:
    case GL_UNPACK_SKIP_ROWS:
        return set(store.skip_rows);
    case GL_PACK_SKIP_PIXELS:
    case GL_UNPACK_SKIP_PIXELS:
        return set(store.skip_pixels);
    case GL_PACK_ALIGNMENT:
    case GL_UNPACK_ALIGNMENT:
        if (value != 1 && value != 2 && value != 4 && value != 8) {
            return gl.set_error(GL_INVALID_VALUE);
        }
        store.alignment = value;
        return;
    default:
        gl.set_error(GL_INVALID_ENUM);
    }
}

/// Reads what lies beside the colours. Returns false when that is impossible here.
bool read_depths_or_stencils(Context& gl, const PixelRectangle& r, const PixelStore& store, GLenum format,
                             GLenum type, std::uint8_t* out)
{
    const auto count = static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height);
    if (format == GL_DEPTH_COMPONENT) {
        std::vector<std::uint32_t> depths(count);
        if (!gl.backend->read_depths(r.x, r.y, r.width, r.height, depths)) {
            return false;
        }
        pack_depths(store, r.width, r.height, type, depths, out);
        return true;
    }
    std::vector<std::uint8_t> values(count);
    if (!gl.backend->read_stencils(r.x, r.y, r.width, r.height, values)) {
        return false;
    }
    pack_stencils(store, r.width, r.height, type, values, out);
    return true;
}

} // namespace

extern "C" {

void glPixelStorei(GLenum pname, GLint param)
{
    dispatch_now(__func__, set_store, pname, param);
}

void glPixelStoref(GLenum pname, GLfloat param)
{
    dispatch_now(__func__, set_store, pname, static_cast<GLint>(param));
}

void glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, GLvoid* pixels)
{
    dispatch_now(
        __func__,
        [pixels](Context& gl, GLint left, GLint bottom, GLsizei w, GLsizei h, GLenum f, GLenum t) {
            if (w < 0 || h < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            const bool colors = f != GL_DEPTH_COMPONENT && f != GL_STENCIL_INDEX;
            // Depths and stencil values are one number a pixel, as a luminance is; the latter also one bit.
            const bool bits = f == GL_STENCIL_INDEX && t == GL_BITMAP;
            if (const GLenum error = format_type_error(colors ? f : GLenum{GL_LUMINANCE}, t);
                error != GL_NO_ERROR && !bits) {
                return gl.set_error(error);
            }
            const PixelRectangle r = clip_to_frame(gl, left, bottom, w, h);
            if (r.empty()) {
                return;
            }
            PixelStore store = gl.state.pack;
            store.row_length = store.row_length > 0 ? store.row_length : w;
            store.skip_pixels += r.skipped_left;
            store.skip_rows += r.skipped_below;
            auto* out = static_cast<std::uint8_t*>(pixels);
            if (colors) {
                pack_pixels(store, r.width, r.height, f, t, read_frame(gl, r), ToLuminance::sum, out);
            } else if (!read_depths_or_stencils(gl, r, store, f, t, out)) {
                gl.refuse_unsupported();
            }
        },
        x, y, width, height, format, type);
}

} // extern "C"
