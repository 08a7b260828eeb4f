/* Uses of SDL2 what the page may use of it; web-dependencies links it to see that the library is whole. */
#include <SDL.h>

int main(void)
{
    SDL_SetHint(SDL_HINT_EMSCRIPTEN_KEYBOARD_ELEMENT, "#canvas");
    if (SDL_Init(SDL_INIT_VIDEO | SDL_INIT_TIMER) != 0) {
        SDL_Log("%s", SDL_GetError());
        return 1;
    }
    SDL_Window* window = SDL_CreateWindow("", 0, 0, 1, 1, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
    int width = 0, height = 0;
    SDL_GetWindowSizeInPixels(window, &width, &height);
    SDL_SetWindowSize(window, width, height);
    SDL_SetWindowTitle(window, "");
    SDL_SetCursor(SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_HAND));
    SDL_CaptureMouse(SDL_TRUE);
    SDL_Event event;
    while (SDL_PollEvent(&event)) {
        SDL_Log("%s", SDL_GetKeyName(SDL_GetKeyFromScancode(event.key.keysym.scancode)));
    }
    const int state = SDL_GetKeyboardState(NULL)[SDL_SCANCODE_A] + (int)SDL_GetMouseState(NULL, NULL);
    SDL_Delay((Uint32)(SDL_GetTicks64() + SDL_GetPerformanceCounter()) & 1);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return state;
}
