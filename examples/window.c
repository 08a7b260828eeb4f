/* Shows a program in a window of SDL2: on OpenGL ES 3, through legacygl. */
#include "program.h"

#include <SDL.h>
#include <legacygl/legacygl.h>
#include <stdio.h>

int main(int argc, char* argv[])
{
    int frames = argc > 1 ? SDL_atoi(argv[1]) : -1; /* to draw; without a number until the window is closed */
    SDL_Window* window = NULL;
    LegacyGLContext* legacygl = NULL;

    if (SDL_Init(SDL_INIT_VIDEO) == 0) {
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
        SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
        SDL_GL_SetAttribute(SDL_GL_STENCIL_SIZE, 8);
        window = SDL_CreateWindow("legacygl", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, WIDTH, HEIGHT,
                                  SDL_WINDOW_OPENGL);
    }
    if (window == NULL || SDL_GL_CreateContext(window) == NULL) {
        fprintf(stderr, "No window with OpenGL ES 3 can be opened: %s\n", SDL_GetError());
        return 1;
    }
    legacygl = legacygl_create(SDL_GL_GetProcAddress, WIDTH, HEIGHT, LEGACYGL_TARGET_WINDOW);
    if (legacygl == NULL) {
        fprintf(stderr, "legacygl cannot draw here: %s\n", legacygl_last_message());
        return 1;
    }

    set_up();
    for (; frames != 0; frames -= frames > 0) {
        SDL_Event event;
        while (SDL_PollEvent(&event)) {
            if (event.type == SDL_QUIT) {
                frames = 1;
            }
        }
        draw(SDL_GetTicks() / 1000.0);
        legacygl_present(legacygl);
        SDL_GL_SwapWindow(window);
    }
    legacygl_destroy(legacygl);
    SDL_Quit();
    return 0;
}
