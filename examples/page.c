/* Shows a program on a page's canvas: on WebGL 2, through legacygl. */
#include "program.h"

#include <emscripten.h>
#include <emscripten/html5.h>
#include <legacygl/legacygl.h>
#include <stdio.h>

static EM_BOOL frame(double milliseconds, void* context)
{
    draw(milliseconds / 1000);
    legacygl_present(context);
    return EM_TRUE; /* and again */
}

int main(void)
{
    LegacyGLContext* legacygl = NULL;
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE webgl;
    EmscriptenWebGLContextAttributes attributes;

    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = EM_FALSE;
    attributes.stencil = EM_TRUE;
    emscripten_set_canvas_element_size("#canvas", WIDTH, HEIGHT);
    webgl = emscripten_webgl_create_context("#canvas", &attributes);
    if (webgl > 0 && emscripten_webgl_make_context_current(webgl) == EMSCRIPTEN_RESULT_SUCCESS) {
        legacygl = legacygl_create(NULL, WIDTH, HEIGHT, LEGACYGL_TARGET_WINDOW);
    }
    if (legacygl == NULL) {
        fprintf(stderr, "legacygl needs WebGL 2: %s\n", legacygl_last_message());
        return 1;
    }
    set_up();
    emscripten_request_animation_frame_loop(frame, legacygl);
    return 0;
}
