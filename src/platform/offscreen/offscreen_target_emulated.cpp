// Draws through legacygl, into a target of its own on an OpenGL ES 3 context.
#include "platform/offscreen/egl_context.h"
#include "platform/offscreen/offscreen_target.h"

#include <legacygl/legacygl.h>

namespace platform {
namespace {

class EmulatedTarget final : public OffscreenTarget
{
public:
    ~EmulatedTarget() override { legacygl_destroy(legacygl_); } // while egl_ is still current

    std::string open(int width, int height)
    {
        if (std::string error = egl_.open(GlApi::es_3); !error.empty()) {
            return error;
        }
        legacygl_ = legacygl_create(find_egl_function, width, height, LEGACYGL_TARGET_OWN);
        if (legacygl_ == nullptr) {
            return std::string("legacygl cannot draw here: ") + legacygl_last_message();
        }
        return "";
    }

private:
    EglContext egl_;
    LegacyGLContext* legacygl_ = nullptr;
};

} // namespace

std::unique_ptr<OffscreenTarget> open_offscreen_target(int width, int height, std::string& error)
{
    auto target = std::make_unique<EmulatedTarget>();
    error = target->open(width, height);
    if (!error.empty()) {
        return nullptr;
    }
    return target;
}

RendererName offscreen_renderer()
{
    return RendererName::emulated;
}

} // namespace platform
