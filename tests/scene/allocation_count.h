#pragma once

#include <cstddef>

/// Returns how often this test program has allocated memory by `new`.
std::size_t allocation_count();
