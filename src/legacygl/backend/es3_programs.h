#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/backend/es3_functions.h"

#include <array>
#include <cstdint>
#include <vector>

namespace legacygl {

/// A linked program and what it holds.
struct Es3Program
{
    GLuint name = 0; ///< 0: it did not link.
    int transform_slots = 1;
    std::uint32_t attributes_read = 0; ///< Bits of Attribute.
    std::array<GLint, UNIFORM_GROUP_COUNT> locations{};
    std::array<std::uint64_t, UNIFORM_GROUP_COUNT> revisions{}; ///< Of the values it holds; in slot 0.
};

/// The programs of a backend.
class Es3Programs
{
public:
    Es3Programs(const Es3Functions& functions, LegacyGLCounters& counters)
        : gl_(functions), counters_(counters)
    {}

    /// Links a program; says on stderr if it does not link. Nothing is in use afterwards.
    ProgramId create(const ProgramText& text);
    const Es3Program& operator[](ProgramId id) const { return programs_[id]; }
    /// Uses a program. Returns whether there is one.
    bool use(ProgramId id);
    /// Uploads a group's values, if there are any, unless the program, which is in use, has them. Revision 0
    /// is never the same.
    void upload(ProgramId id, UniformGroup group, const UniformValues& values);

    /// Deletes all programs.
    void clear();
    /// Forgets all programs, which went with their context.
    void forget() { programs_.resize(1); }
    /// Forgets which one is in use, which others changed.
    void forget_use() { used_ = 0; }

private:
    const Es3Functions& gl_;
    LegacyGLCounters& counters_;
    std::vector<Es3Program> programs_{1}; ///< The first stays empty, so that 0 can mean none.
    GLuint used_ = 0;                     ///< 0: not known.
};

} // namespace legacygl
