#pragma once

#include <string>

namespace platform {

/// Which kind of OpenGL an EglContext speaks.
enum class GlApi
{
    es_3,
    desktop_compatibility
};

/// An EGL context without any surface, on Mesa's surfaceless platform: no display, no window.
/// It has no default framebuffer; whoever draws brings a framebuffer object.
class EglContext
{
public:
    EglContext() = default;
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;
    ~EglContext();

    /// Makes the context and makes it current. Call at most once.
    /// Returns "" or a sentence that says which step failed.
    std::string open(GlApi api);

private:
    void* display_ = nullptr; // EGLDisplay and EGLContext, kept out of the header
    void* context_ = nullptr;
};

/// Finds a GL function of the current context by name, as legacygl's loader does.
/// Non-null for any name, also an unknown one: EGL answers so.
void* find_egl_function(const char* name);

} // namespace platform
