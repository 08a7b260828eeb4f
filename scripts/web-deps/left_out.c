/* Takes the place of the parts of SDL2 that the page's build leaves out: drawing into surfaces on the
   CPU, and recognising gestures. Nine tenths of what SDL would add to the page is that drawing, and the
   page draws with WebGL. Every function says so by SDL_Unsupported().

   No line of SDL is changed: this file is compiled instead of src/video/SDL_surface.c, SDL_blit*.c and
   their kind, and src/events/SDL_gesture.c (see ../web-dependencies). Finger events still arrive. */
#include "SDL_error.h"
#include "SDL_events.h"
#include "SDL_surface.h"

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
