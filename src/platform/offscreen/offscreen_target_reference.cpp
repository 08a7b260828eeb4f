// Draws through the system's own OpenGL, into a framebuffer object, as legacygl draws into one: Mesa stores a
// pbuffer upside down, and its pictures then differ (docs/architecture.md).
#include "platform/offscreen/egl_context.h"
#include "platform/offscreen/offscreen_target.h"

#include <GL/gl.h>
#include <GL/glext.h>

namespace platform {
namespace {

/// The few functions newer than OpenGL 1.1 that this file needs, from the context itself.
struct FramebufferFunctions
{
    PFNGLGENFRAMEBUFFERSPROC gen_framebuffers;
    PFNGLBINDFRAMEBUFFERPROC bind_framebuffer;
    PFNGLFRAMEBUFFERRENDERBUFFERPROC framebuffer_renderbuffer;
    PFNGLCHECKFRAMEBUFFERSTATUSPROC check_framebuffer_status;
    PFNGLDELETEFRAMEBUFFERSPROC delete_framebuffers;
    PFNGLGENRENDERBUFFERSPROC gen_renderbuffers;
    PFNGLBINDRENDERBUFFERPROC bind_renderbuffer;
    PFNGLRENDERBUFFERSTORAGEPROC renderbuffer_storage;
    PFNGLDELETERENDERBUFFERSPROC delete_renderbuffers;
};

template <class Function> void find(Function& function, const char* name)
{
    function = reinterpret_cast<Function>(find_egl_function(name));
}

FramebufferFunctions framebuffer_functions()
{
    FramebufferFunctions gl{};
    find(gl.gen_framebuffers, "glGenFramebuffers");
    find(gl.bind_framebuffer, "glBindFramebuffer");
    find(gl.framebuffer_renderbuffer, "glFramebufferRenderbuffer");
    find(gl.check_framebuffer_status, "glCheckFramebufferStatus");
    find(gl.delete_framebuffers, "glDeleteFramebuffers");
    find(gl.gen_renderbuffers, "glGenRenderbuffers");
    find(gl.bind_renderbuffer, "glBindRenderbuffer");
    find(gl.renderbuffer_storage, "glRenderbufferStorage");
    find(gl.delete_renderbuffers, "glDeleteRenderbuffers");
    return gl;
}

class ReferenceTarget final : public OffscreenTarget
{
public:
    ~ReferenceTarget() override
    {
        if (framebuffer_ == 0) {
            return;
        }
        gl_.delete_framebuffers(1, &framebuffer_);
        gl_.delete_renderbuffers(2, renderbuffers_);
    }

    std::string open(int width, int height)
    {
        if (std::string error = egl_.open(GlApi::desktop_compatibility); !error.empty()) {
            return error;
        }
        gl_ = framebuffer_functions();
        gl_.gen_framebuffers(1, &framebuffer_);
        gl_.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.gen_renderbuffers(2, renderbuffers_);
        attach(0, GL_RGBA8, GL_COLOR_ATTACHMENT0, width, height);
        attach(1, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT, width, height);
        if (gl_.check_framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            return "The system's OpenGL cannot draw into a picture of this size.";
        }
        return "";
    }

private:
    void attach(int index, GLenum format, GLenum attachment, int width, int height)
    {
        gl_.bind_renderbuffer(GL_RENDERBUFFER, renderbuffers_[index]);
        gl_.renderbuffer_storage(GL_RENDERBUFFER, format, width, height);
        gl_.framebuffer_renderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffers_[index]);
    }

    EglContext egl_;
    FramebufferFunctions gl_{};
    GLuint framebuffer_ = 0;
    GLuint renderbuffers_[2] = {0, 0}; // colour; depth and stencil
};

} // namespace

std::unique_ptr<OffscreenTarget> open_offscreen_target(int width, int height, std::string& error)
{
    auto target = std::make_unique<ReferenceTarget>();
    error = target->open(width, height);
    if (!error.empty()) {
        return nullptr;
    }
    return target;
}

RendererName offscreen_renderer()
{
    return RendererName::reference;
}

} // namespace platform
