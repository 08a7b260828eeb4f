#include "platform/offscreen/egl_context.h"

#include "platform/offscreen/leak_suppressions.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdio>

namespace platform {
namespace {

std::string failed(const char* what)
{
    char code[16];
    std::snprintf(code, sizeof code, "0x%04x", static_cast<unsigned>(eglGetError()));
    return std::string("EGL cannot draw without a window here: ") + what + " failed (EGL error " + code +
           ").";
}

} // namespace

std::string EglContext::open(GlApi api)
{
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) {
        return failed("finding Mesa's surfaceless platform");
    }
    EGLint major = 0;
    EGLint minor = 0;
    if (eglInitialize(display, &major, &minor) == EGL_FALSE) {
        return failed("initialising Mesa's surfaceless platform");
    }
    display_ = display;

    const bool desktop = api == GlApi::desktop_compatibility;
    if (eglBindAPI(desktop ? EGL_OPENGL_API : EGL_OPENGL_ES_API) == EGL_FALSE) {
        return failed(desktop ? "choosing desktop OpenGL" : "choosing OpenGL ES");
    }

    const EGLint config_wishes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                    desktop ? EGL_OPENGL_BIT : EGL_OPENGL_ES3_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint config_count = 0;
    if (eglChooseConfig(display, config_wishes, &config, 1, &config_count) == EGL_FALSE ||
        config_count == 0) {
        return failed("finding a configuration");
    }

    const EGLint desktop_wishes[] = {EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT, EGL_NONE};
    const EGLint es_wishes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
    EGLContext context =
        eglCreateContext(display, config, EGL_NO_CONTEXT, desktop ? desktop_wishes : es_wishes);
    if (context == EGL_NO_CONTEXT) {
        return failed(desktop ? "making an OpenGL compatibility context" : "making an OpenGL ES 3 context");
    }
    context_ = context;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
        return failed("making the context current without a surface");
    }
    keep_driver_loaded();
    return "";
}

EglContext::~EglContext()
{
    if (display_ == nullptr) {
        return;
    }
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != nullptr) {
        eglDestroyContext(display_, context_);
    }
    eglTerminate(display_);
}

void* find_egl_function(const char* name)
{
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

} // namespace platform
