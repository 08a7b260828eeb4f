#include "image/image.h"
#include "tests/mesh/invariants.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Any bytes: read_image neither crashes nor hangs, and gives an image that keeps its promises, twice the
// same, or a sentence.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const base::Result<image::Image> result = image::read_image("fuzz.png", {data, size});
    std::string broken = result ? broken_invariant(result.value()) : broken_invariant(result.error(), 0);
    if (result && result.value().pixels.size() < 100'000) {
        const base::Result<image::Image> again = image::read_image("fuzz.png", {data, size});
        if (!again || again.value().pixels != result.value().pixels) {
            broken = "the same bytes were read differently the second time";
        }
    }
    if (!broken.empty()) {
        std::fprintf(stderr, "%s\n", broken.c_str());
        std::abort();
    }
    return 0;
}
