#pragma once

#include <cstdlib>
#include <string>

namespace oracle {

/// Major versions of Mesa, the first and the last; all by default. Other OpenGLs have version 0.
struct MesaVersions
{
    int first = 0;
    int last = 1'000'000;
    bool contain(int version) const { return first <= version && version <= last; }
};

/// Returns the major version that a GL_VERSION names ("4.5 (Compatibility Profile) Mesa 22.3.6"), or 0.
inline int mesa_version(const std::string& gl_version)
{
    const std::string::size_type at = gl_version.find("Mesa ");
    return at == std::string::npos ? 0 : std::atoi(gl_version.c_str() + at + 5);
}

} // namespace oracle
