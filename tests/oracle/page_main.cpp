// The scenes as a page: tests/page/oracle.test.mjs asks for them one by one and compares them with what
// oracle_emulated draws natively. One WebGL context serves all of them, since browsers give a page only a
// few; each scene gets a legacygl context of its own, which shows that a new one starts from the beginning.

#include "drawing.h"

#include <legacygl/legacygl.h>

#include <emscripten.h>
#include <emscripten/html5.h>

namespace {

oracle::Drawn drawn;

} // namespace

extern "C" {

/// Makes the WebGL context. Returns whether the browser gives one.
EMSCRIPTEN_KEEPALIVE int oracle_open()
{
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = EM_FALSE;
    attributes.antialias = EM_FALSE;
    attributes.stencil = EM_TRUE;
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE webgl = emscripten_webgl_create_context("#canvas", &attributes);
    return webgl > 0 && emscripten_webgl_make_context_current(webgl) == EMSCRIPTEN_RESULT_SUCCESS;
}

EMSCRIPTEN_KEEPALIVE int oracle_count()
{
    return static_cast<int>(oracle::scenes().size());
}

EMSCRIPTEN_KEEPALIVE const char* oracle_name(int index)
{
    return oracle::scenes()[index].name.c_str();
}

/// Draws a scene. Returns why it cannot, or "" and then oracle_pixels … tell what came of it.
EMSCRIPTEN_KEEPALIVE const char* oracle_draw(int index)
{
    const oracle::Scene& scene = oracle::scenes()[index];
    LegacyGLContext* context =
        legacygl_create(nullptr, scene.size.width, scene.size.height, LEGACYGL_TARGET_OWN);
    if (context == nullptr) {
        return legacygl_last_message();
    }
    drawn = oracle::draw(scene);
    legacygl_destroy(context);
    return "";
}

EMSCRIPTEN_KEEPALIVE const unsigned char* oracle_pixels()
{
    return drawn.rgba.data();
}

EMSCRIPTEN_KEEPALIVE int oracle_pixel_bytes()
{
    return static_cast<int>(drawn.rgba.size());
}

EMSCRIPTEN_KEEPALIVE const char* oracle_told()
{
    return drawn.told.c_str();
}

} // extern "C"
