// A program of programs.h on a canvas of a page: linked once with legacygl and once with Emscripten's
// emulation of OpenGL 1 (BENCH_EMSCRIPTEN). See page.js.

#include "programs.h"

#include <GL/gl.h>

#include <emscripten.h>

#ifdef BENCH_EMSCRIPTEN
#include <EGL/egl.h>
#else
#include <legacygl/legacygl.h>

#include <emscripten/html5.h>
#endif

namespace {

const bench::Program* program = nullptr;

#ifdef BENCH_EMSCRIPTEN

/// Emscripten's emulation starts with a context that its EGL makes, on Module.canvas.
bool open_context(const char*)
{
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    const EGLint wanted[] = {EGL_DEPTH_SIZE, 24, EGL_NONE},
                 version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, wanted, &config, 1, &count)) {
        return false;
    }
    EGLSurface surface = eglCreateWindowSurface(display, config, 0, nullptr);
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    return eglMakeCurrent(display, surface, surface, context);
}

void finish_frame() {}

#else

LegacyGLContext* legacygl = nullptr;

bool open_context(const char* canvas)
{
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = EM_FALSE;
    attributes.antialias = EM_FALSE;
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE webgl = emscripten_webgl_create_context(canvas, &attributes);
    if (webgl <= 0 || emscripten_webgl_make_context_current(webgl) != EMSCRIPTEN_RESULT_SUCCESS) {
        return false;
    }
    legacygl = legacygl_create(nullptr, bench::SIZE, bench::SIZE, LEGACYGL_TARGET_WINDOW);
    return legacygl != nullptr;
}

void finish_frame()
{
    legacygl_present(legacygl);
}

#endif

} // namespace

extern "C" {

/// Makes a context for the canvas (a selector) and sets up the program, 0: immediate, 1: lists.
/// Returns whether it can.
EMSCRIPTEN_KEEPALIVE int bench_open(const char* canvas, int which)
{
    if (!open_context(canvas)) {
        return 0;
    }
#ifdef BENCH_EMSCRIPTEN
    program = &bench::immediate; // The emulation has no display lists.
    (void)which;
#else
    program = which == 1 ? &bench::lists : &bench::immediate;
#endif
    program->setup();
    return 1;
}

EMSCRIPTEN_KEEPALIVE void bench_frame(int number)
{
    program->frame(number);
    finish_frame();
}

#ifndef BENCH_EMSCRIPTEN
EMSCRIPTEN_KEEPALIVE const float* bench_list_vertices(int list)
{
    return bench::list_vertices(list);
}

EMSCRIPTEN_KEEPALIVE const float* bench_list_matrices()
{
    return bench::list_matrices();
}
#endif

} // extern "C"
