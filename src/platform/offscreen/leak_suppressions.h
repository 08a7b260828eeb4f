#pragma once

namespace platform {

/// Keeps the graphics driver's modules loaded until the end, in builds with the address sanitizer; else does
/// nothing. Mesa leaks a few hundred bytes at exit, which LeakSanitizer can only tell from our own leaks
/// while the module is there to be named. Call it when a context is current.
void keep_driver_loaded();

} // namespace platform
