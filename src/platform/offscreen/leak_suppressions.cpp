#include "platform/offscreen/leak_suppressions.h"

#ifdef __SANITIZE_ADDRESS__

#include <cstddef>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <link.h>

/// LeakSanitizer asks the program for this: the leaks that are not ours.
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:libEGL_mesa\nleak:libGLX_mesa\nleak:libglapi\nleak:_dri.so\nleak:libgallium\nleak:libLLVM\n";
}

namespace platform {

void keep_driver_loaded()
{
    std::vector<std::string> modules;
    const auto note = [](dl_phdr_info* module, std::size_t, void* into) {
        static_cast<std::vector<std::string>*>(into)->emplace_back(module->dlpi_name);
        return 0;
    };
    dl_iterate_phdr(note, &modules);
    for (const std::string& module : modules) {
        if (!module.empty()) {
            dlopen(module.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
        }
    }
}

} // namespace platform

#else

namespace platform {

void keep_driver_loaded() {}

} // namespace platform

#endif
