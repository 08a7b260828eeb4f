#include "mesh/obj_reader.h"
#include "tests/mesh/invariants.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Any bytes: read_obj neither crashes nor hangs, and gives a mesh that keeps its promises or a sentence with
// a line.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const base::Result<mesh::ObjMesh> result = mesh::read_obj("fuzz.obj", text);
    const auto is_line_end = [](char c) { return c == '\n' || c == '\r'; };
    const int lines = 1 + int(std::count_if(text.begin(), text.end(), is_line_end));
    const std::string broken =
        result ? broken_invariant(result.value()) : broken_invariant(result.error(), lines);
    if (!broken.empty()) {
        std::fprintf(stderr, "%s\n", broken.c_str());
        std::abort();
    }
    return 0;
}
