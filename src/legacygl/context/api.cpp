// The functions of <legacygl/legacygl.h>.

#include "legacygl/backend/es3_backend.h"
#include "legacygl/context/context.h"

#include <legacygl/legacygl.h>

#include <string>

struct LegacyGLContext : legacygl::Context
{
    using Context::Context;
};

namespace {

std::string last_message;

LegacyGLContext* as_public(legacygl::Context* context)
{
    return static_cast<LegacyGLContext*>(context);
}

} // namespace

extern "C" {

LegacyGLContext* legacygl_create(LegacyGLLoader loader, int width, int height, LegacyGLTarget target)
{
    last_message.clear();
    if (width < 1 || height < 1) {
        last_message = "The size of a context must be at least 1 × 1 pixels.";
        return nullptr;
    }
    auto backend = legacygl::make_es3_backend(loader, width, height, target, last_message);
    if (!backend) {
        return nullptr;
    }
    const bool single = target == LEGACYGL_TARGET_OWN_SINGLE;
    auto* context = new LegacyGLContext(std::move(backend), width, height, !single);
    legacygl_make_current(context);
    return context;
}

void legacygl_destroy(LegacyGLContext* context)
{
    if (legacygl::current_context == context) {
        legacygl::current_context = nullptr;
    }
    delete context;
}

void legacygl_make_current(LegacyGLContext* context)
{
    legacygl::current_context = context;
}

LegacyGLContext* legacygl_current(void)
{
    return as_public(legacygl::current_context);
}

void legacygl_resize(LegacyGLContext* context, int width, int height)
{
    legacygl::Backend& backend = *context->backend;
    if (width < 1 || height < 1 || (width == backend.target_width && height == backend.target_height)) {
        return;
    }
    context->flush_vertices();
    backend.target_width = width;
    backend.target_height = height;
    backend.resize(width, height);
}

void legacygl_present(LegacyGLContext* context)
{
    context->flush_vertices();
    context->backend->present();
}

void legacygl_show_front(LegacyGLContext* context)
{
    context->flush_vertices();
    context->backend->show_front();
}

void legacygl_context_lost(LegacyGLContext* context)
{
    context->backend->context_lost();
    context->renderer.forget_objects();
}

void legacygl_context_restored(LegacyGLContext* context)
{
    context->backend->context_restored();
    context->renderer.forget_objects();
}

const char* legacygl_last_message(void)
{
    return last_message.c_str();
}

LegacyGLCounters legacygl_counters(const LegacyGLContext* context)
{
    return context->backend->counters;
}

void legacygl_reset_counters(LegacyGLContext* context)
{
    context->backend->counters = {};
}

void legacygl_capture_begin(LegacyGLContext* context)
{
    context->capture.begin();
}

const LegacyGLCall* legacygl_capture_end(LegacyGLContext* context, size_t* count)
{
    const auto calls = context->capture.end();
    *count = calls.size();
    return calls.data();
}

} // extern "C"
