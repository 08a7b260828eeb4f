// Images of textures and of their parts (OpenGL 1.5, 3.8.1 and 3.8.2).

#include "legacygl/context/dispatch.h"
#include "legacygl/context/unimplemented.h"
#include "legacygl/pixel/pixel_conversion.h"
#include "legacygl/pixel/texture_image.h"
#include "legacygl/pixel/texture_targets.h"
#include "legacygl/state/internal_format.h"

using namespace legacygl;

namespace {

/// Colour indices become colours by pixel maps, which are not implemented yet.
void refuse_color_indices()
{
    LEGACYGL_REFUSE("a texture image of colour indices");
}

/// What glTexImage says of an image; 1D images are one texel high.
struct ImageRequest
{
    int dimensions;
    GLint level, internal_format;
    GLsizei width, height;
    GLint border;
    GLenum format, type;
};

/// Returns what is wrong with the request besides its size, or GL_NO_ERROR.
GLenum request_error(const Context& gl, const ImageRequest& r)
{
    if (!is_level(gl, r.level) || r.border < 0 || r.border > 1 || r.width < 0 || r.height < 0) {
        return GL_INVALID_VALUE;
    }
    if (const GLenum error = format_type_error(r.format, r.type); error != GL_NO_ERROR) {
        return error;
    }
    return base_format(r.internal_format) == BaseFormat::none ? GL_INVALID_VALUE : GL_NO_ERROR;
}

/// Returns whether the image, its border included, can be a level.
bool fits(const Context& gl, const ImageRequest& r)
{
    const int most = (gl.backend->maximum_texture_size >> r.level) + 2 * r.border;
    return r.width >= 2 * r.border && r.width <= most &&
           (r.dimensions == 1 || (r.height >= 2 * r.border && r.height <= most));
}

void answer_proxy(Context& gl, int target, const ImageRequest& r)
{
    if (const GLenum error = request_error(gl, r); error != GL_NO_ERROR) {
        return gl.set_error(error);
    }
    std::vector<TextureImage>& levels = gl.state.texturing.proxies[target];
    if (levels.size() <= static_cast<std::size_t>(r.level)) {
        levels.resize(r.level + 1);
    }
    levels[r.level] = fits(gl, r) ? TextureImage{r.internal_format, r.width, r.height} : TextureImage{};
}

/// A border is dropped, as Mesa drops it: ES has none.
void define_image(Context& gl, const ImageRequest& r, PixelStore store, const Blob& pixels)
{
    if (const GLenum error = request_error(gl, r); error != GL_NO_ERROR) {
        return gl.set_error(error);
    }
    if (!fits(gl, r)) {
        return gl.set_error(GL_INVALID_VALUE);
    }
    const bool flat = r.dimensions == 1;
    const int width = r.width - 2 * r.border, height = flat ? 1 : r.height - 2 * r.border;
    if (r.border != 0) {
        store.row_length = store.row_length > 0 ? store.row_length : r.width;
        store.skip_pixels += 1;
        store.skip_rows += flat ? 0 : 1;
    }
    std::vector<std::uint8_t> rgba;
    if (pixels.data) {
        rgba = unpack_pixels(store, width, height, r.format, r.type,
                             static_cast<const std::uint8_t*>(pixels.data));
    }
    Texture& texture = bound_texture(gl, flat ? GL_TEXTURE_1D : GL_TEXTURE_2D);
    set_level(texture, r.level, r.internal_format, width, height, rgba);
    gl.renderer.changed(change::texturing);
}

void image(const char* entry, GLenum target, const ImageRequest& request, const void* pixels)
{
    if (!current_context) {
        return;
    }
    if (request.format == GL_COLOR_INDEX) {
        return refuse_color_indices();
    }
    const std::optional<ImageTarget> found = find_image_target(target, request.dimensions);
    if (found && found->proxy) {
        return dispatch_now(
            entry, [](Context& gl, int t, const ImageRequest& r) { answer_proxy(gl, t, r); }, found->index,
            request);
    }
    const PixelStore store = current_context->state.unpack;
    const ImageRequest& r = request;
    const std::size_t size = pixels ? client_image_bytes(store, r.width, r.height, r.format, r.type) : 0;
    dispatch(
        entry,
        [](Context& gl, bool good, const ImageRequest& req, const PixelStore& s, const Blob& data) {
            good ? define_image(gl, req, s, data) : gl.set_error(GL_INVALID_ENUM);
        },
        found.has_value(), request, store, Blob{size ? pixels : nullptr, size});
}

/// What glTexSubImage says of a part.
struct PartRequest
{
    GLint level;
    TexelRectangle part;
    GLenum format, type;
};

void replace_part(Context& gl, GLenum target, const PartRequest& r, const PixelStore& store,
                  const Blob& pixels)
{
    const auto& [x, y, width, height] = r.part;
    if (!is_level(gl, r.level) || width < 0 || height < 0) {
        return gl.set_error(GL_INVALID_VALUE);
    }
    if (const GLenum error = format_type_error(r.format, r.type); error != GL_NO_ERROR) {
        return gl.set_error(error);
    }
    Texture& texture = bound_texture(gl, target);
    if (static_cast<std::size_t>(r.level) >= texture.levels.size() || texture.levels[r.level].width == 0) {
        return gl.set_error(GL_INVALID_OPERATION);
    }
    const TextureImage& level = texture.levels[r.level];
    if (x < 0 || y < 0 || x + width > level.width || y + height > level.height) {
        return gl.set_error(GL_INVALID_VALUE);
    }
    if (!pixels.data) {
        return;
    }
    set_part(
        texture, r.level, r.part,
        unpack_pixels(store, width, height, r.format, r.type, static_cast<const std::uint8_t*>(pixels.data)));
    gl.renderer.changed(change::texturing);
}

void part(const char* entry, GLenum target, GLenum wanted, const PartRequest& request, const void* pixels)
{
    if (!current_context) {
        return;
    }
    if (request.format == GL_COLOR_INDEX) {
        return refuse_color_indices();
    }
    const PixelStore store = current_context->state.unpack;
    const std::size_t size = pixels ? client_image_bytes(store, request.part.width, request.part.height,
                                                         request.format, request.type)
                                    : 0;
    dispatch(
        entry,
        [](Context& gl, GLenum t, GLenum w, const PartRequest& r, const PixelStore& s, const Blob& data) {
            t == w ? replace_part(gl, t, r, s, data) : gl.set_error(GL_INVALID_ENUM);
        },
        target, wanted, request, store, Blob{size ? pixels : nullptr, size});
}

} // namespace

extern "C" {

void glTexImage1D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLint border,
                  GLenum format, GLenum type, const GLvoid* pixels)
{
    image(__func__, target, {1, level, internalFormat, width, 1, border, format, type}, pixels);
}

void glTexImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height,
                  GLint border, GLenum format, GLenum type, const GLvoid* pixels)
{
    image(__func__, target, {2, level, internalFormat, width, height, border, format, type}, pixels);
}

void glTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format, GLenum type,
                     const GLvoid* pixels)
{
    part(__func__, target, GL_TEXTURE_1D, {level, {xoffset, 0, width, 1}, format, type}, pixels);
}

void glTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width, GLsizei height,
                     GLenum format, GLenum type, const GLvoid* pixels)
{
    part(__func__, target, GL_TEXTURE_2D, {level, {xoffset, yoffset, width, height}, format, type}, pixels);
}

} // extern "C"
