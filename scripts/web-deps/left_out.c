/* Takes the place of the parts of SDL2 that the page's build leaves out: drawing into surfaces on the
   CPU, showing those, and recognising gestures. Nine tenths of what SDL would add to the page is that
   drawing, and the page draws with WebGL. Every function says so by SDL_Unsupported().

   No line of SDL is changed: this file is compiled instead of src/video/SDL_surface.c, SDL_blit*.c and
   their kind, and src/events/SDL_gesture.c (see ../web-dependencies). Finger events still arrive. */
#include "SDL_error.h"
#include "SDL_events.h"
#include "SDL_surface.h"
#include "SDL_video.h"

#include <emscripten.h>

SDL_Surface* SDL_CreateRGBSurface(Uint32 flags, int width, int height, int depth, Uint32 red_mask,
                                  Uint32 green_mask, Uint32 blue_mask, Uint32 alpha_mask)
{
    SDL_Unsupported();
    return NULL;
}

SDL_Surface* SDL_CreateRGBSurfaceFrom(void* pixels, int width, int height, int depth, int pitch,
                                      Uint32 red_mask, Uint32 green_mask, Uint32 blue_mask, Uint32 alpha_mask)
{
    SDL_Unsupported();
    return NULL;
}

SDL_Surface* SDL_ConvertSurfaceFormat(SDL_Surface* surface, Uint32 pixel_format, Uint32 flags)
{
    SDL_Unsupported();
    return NULL;
}

void SDL_FreeSurface(SDL_Surface* surface) {}

/* What src/video/emscripten/SDL_emscriptenframebuffer.h declares. */
int Emscripten_CreateWindowFramebuffer(struct SDL_VideoDevice* device, SDL_Window* window, Uint32* format,
                                       void** pixels, int* pitch)
{
    return SDL_Unsupported();
}

int Emscripten_UpdateWindowFramebuffer(struct SDL_VideoDevice* device, SDL_Window* window,
                                       const SDL_Rect* rectangles, int count)
{
    return SDL_Unsupported();
}

void Emscripten_DestroyWindowFramebuffer(struct SDL_VideoDevice* device, SDL_Window* window) {}

/* Three functions of Emscripten that SDL calls, and with each of which comes all of Emscripten's main loop,
   full screen and image code. web-dependencies has SDL call these instead. The first belongs to the exit
   after a failed assertion, and there is no main loop of that kind to cancel. */
void tanklab_cancel_main_loop(void) {}

void tanklab_set_window_title(const char* title)
{
    EM_ASM({ document.title = UTF8ToString($0); }, title);
}

void tanklab_get_screen_size(int* width, int* height)
{
    *width = EM_ASM_INT({ return screen.width; });
    *height = EM_ASM_INT({ return screen.height; });
}

/* Called by SDL's touch and event code, which declares them in src/events/SDL_gesture_c.h. */
int SDL_GestureAddTouch(SDL_TouchID touch)
{
    return 0;
}

int SDL_GestureDelTouch(SDL_TouchID touch)
{
    return 0;
}

void SDL_GestureProcessEvent(SDL_Event* event) {}

void SDL_GestureQuit(void) {}
