// Saving and restoring attributes (OpenGL 1.5, 6.1.14).

#include "legacygl/state/attribute_stack.h"
#include "legacygl/context/dispatch.h"

using namespace legacygl;

extern "C" {

void glPushAttrib(GLbitfield mask)
{
    dispatch(
        __func__,
        [](Context& gl, GLbitfield groups) {
            if (gl.attributes.size() == ATTRIBUTE_STACK_DEPTH) {
                return gl.set_error(GL_STACK_OVERFLOW);
            }
            gl.store_followed_color(); // The material is what the colour makes of it now.
            gl.attributes.emplace_back(gl.state, groups);
        },
        mask);
}

void glPopAttrib()
{
    dispatch(__func__, [](Context& gl) {
        if (gl.attributes.empty()) {
            return gl.set_error(GL_STACK_UNDERFLOW);
        }
        gl.store_followed_color(); // A material that is not restored keeps the colour it followed.
        gl.attributes.back().restore(gl.state);
        gl.attributes.pop_back();
        gl.store_followed_color();
        gl.renderer.changed(change::everything);
    });
}

void glPushClientAttrib(GLbitfield mask)
{
    dispatch_now(
        __func__,
        [](Context& gl, GLbitfield groups) {
            if (gl.client_attributes.size() == ATTRIBUTE_STACK_DEPTH) {
                return gl.set_error(GL_STACK_OVERFLOW);
            }
            SavedClientAttributes saved;
            if (groups & GL_CLIENT_PIXEL_STORE_BIT) {
                saved.pixel_stores = {gl.state.pack, gl.state.unpack};
            }
            if (groups & GL_CLIENT_VERTEX_ARRAY_BIT) {
                saved.arrays = {gl.client_arrays, gl.state.texturing.client_active};
            }
            gl.client_attributes.push_back(std::move(saved));
        },
        mask);
}

void glPopClientAttrib()
{
    dispatch_now(__func__, [](Context& gl) {
        if (gl.client_attributes.empty()) {
            return gl.set_error(GL_STACK_UNDERFLOW);
        }
        const SavedClientAttributes saved = std::move(gl.client_attributes.back());
        gl.client_attributes.pop_back();
        if (saved.pixel_stores) {
            gl.state.pack = saved.pixel_stores->pack;
            gl.state.unpack = saved.pixel_stores->unpack;
        }
        if (!saved.arrays) {
            return;
        }
        gl.client_arrays = saved.arrays->arrays;
        gl.state.texturing.client_active = saved.arrays->client_active;
        for (GLuint* bound : {&gl.client_arrays.bound_array_buffer, &gl.client_arrays.bound_element_buffer}) {
            if (!gl.find_buffer(*bound)) {
                *bound = 0; // It was deleted meanwhile.
            }
        }
    });
}

} // extern "C"
