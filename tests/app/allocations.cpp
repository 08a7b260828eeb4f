#include "allocations.h"

#include <cstdlib>
#include <new>

namespace {

std::uint64_t counted = 0;

} // namespace

std::uint64_t app::allocations()
{
    return counted;
}

void* operator new(std::size_t size)
{
    ++counted;
    void* memory = std::malloc(size > 0 ? size : 1);
    if (memory == nullptr) {
        std::abort();
    }
    return memory;
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
