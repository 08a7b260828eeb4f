#pragma once

#include <cstdint>

namespace app {

/// Returns how often memory has been allocated by `new` in this program so far.
std::uint64_t allocations();

} // namespace app
