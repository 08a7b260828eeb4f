/* Functions of Emscripten's that SDL2 calls, and with each of which comes all of Emscripten's main loop, full
   screen and image code. build-sdl renames them in SDL2 and here alike, so that the compiler holds these to
   their types. */
#include <emscripten.h>
#include <emscripten/html5.h>

/* Belongs to the exit after a failed assertion; the page has no main loop of that kind. */
void emscripten_cancel_main_loop(void) {}

void emscripten_set_window_title(const char* title)
{
    EM_ASM({ document.title = UTF8ToString($0); }, title);
}

void emscripten_get_screen_size(int* width, int* height)
{
    *width = EM_ASM_INT({ return screen.width; });
    *height = EM_ASM_INT({ return screen.height; });
}
