#pragma once

#include <cstddef>

/// Returns how often the test program has allocated memory by `new` so far. Replaces the operators of the
/// whole program, in all the forms that it and GoogleTest use.
std::size_t allocation_count();
