#include "scene.h"

namespace oracle {

std::vector<Scene>& scenes()
{
    static std::vector<Scene> all;
    return all;
}

} // namespace oracle
