/* Appended by build-sdl to SDL's own SDL_config_emscripten.h: the page uses SDL2 for its window, input and
   time. The GL context is made by Emscripten itself; SDL's would add some 330 KB of WebAssembly and 135 KB of
   script, since it looks functions up by name and so keeps all of them. */
#undef SDL_VIDEO_OPENGL_ES2
#undef SDL_VIDEO_OPENGL_EGL
#undef SDL_VIDEO_RENDER_OGL_ES2
#define SDL_RENDER_DISABLED 1

#undef SDL_AUDIO_DRIVER_DISK
#undef SDL_AUDIO_DRIVER_DUMMY
#undef SDL_AUDIO_DRIVER_EMSCRIPTEN
#define SDL_AUDIO_DISABLED 1
#undef SDL_JOYSTICK_EMSCRIPTEN
#define SDL_JOYSTICK_DISABLED 1
#define SDL_HAPTIC_DISABLED 1
#define SDL_HIDAPI_DISABLED 1
#undef SDL_SENSOR_DUMMY
#define SDL_SENSOR_DISABLED 1
#undef SDL_POWER_EMSCRIPTEN
#define SDL_POWER_DISABLED 1
#undef SDL_FILESYSTEM_EMSCRIPTEN
#define SDL_FILESYSTEM_DUMMY 1
#undef SDL_LOADSO_DLOPEN
#define SDL_LOADSO_DUMMY 1
#undef HAVE_DLOPEN
#undef HAVE_ICONV
#undef HAVE_ICONV_H
#undef SDL_DEFAULT_ASSERT_LEVEL
#define SDL_DEFAULT_ASSERT_LEVEL 0

/* SDL's own, small ones: the C library's bring arithmetic on long double along. */
#undef HAVE_ATOF
#undef HAVE_STRTOD
#undef HAVE_SSCANF
#undef HAVE_VSSCANF
