#include "image/image.h"
#include "mesh/obj_reader.h"
#include "tests/mesh/invariants.h"
#include "tests/mesh/sample_files.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

// A small fuzz run in every test run: valid files, damaged at random from a fixed seed. tests/fuzz does it in
// earnest.

namespace {

class Mutator
{
public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    Bytes damaged(Bytes bytes)
    {
        for (std::size_t i = 1 + random_() % 4; i > 0 && !bytes.empty(); --i) {
            damage(bytes);
        }
        return bytes;
    }

private:
    std::size_t below(std::size_t n) { return random_() % n; }

    void damage(Bytes& bytes)
    {
        const std::size_t at = below(bytes.size());
        const std::size_t length = std::min(bytes.size() - at, 1 + below(16));
        const auto begin = bytes.begin() + long(at);
        switch (below(7)) {
        case 0:
            *begin ^= std::uint8_t(1U << below(8));
            return;
        case 1:
            *begin = std::uint8_t(below(256));
            return;
        case 2:
            *begin = std::uint8_t("0123456789-/.# \n\r\t\\efvns"[below(25)]);
            return;
        case 3:
            bytes.erase(begin, begin + long(length));
            return;
        case 4:
            bytes.resize(at);
            return;
        case 5: // repeat a piece elsewhere
        {
            const Bytes piece(begin, begin + long(length));
            bytes.insert(bytes.begin() + long(below(bytes.size())), piece.begin(), piece.end());
            return;
        }
        default:
            bytes.insert(begin, length, *begin);
        }
    }

    std::mt19937 random_;
};

TEST(Mutations, OfAnObjAreReadOrRefusedInASentence)
{
    const std::string cube = sample_obj();
    const Bytes original(cube.begin(), cube.end());
    Mutator mutator(11);
    int read = 0;
    int refused = 0;
    for (int i = 0; i < 5000; ++i) {
        const Bytes bytes = mutator.damaged(original);
        const std::string text(bytes.begin(), bytes.end());
        const base::Result<mesh::ObjMesh> result = mesh::read_obj("cube.obj", text);
        const int lines =
            1 + int(std::count(text.begin(), text.end(), '\n') + std::count(text.begin(), text.end(), '\r'));
        ASSERT_EQ(result ? broken_invariant(result.value()) : broken_invariant(result.error(), lines), "")
            << text;
        ++(result ? read : refused);
    }
    EXPECT_GT(read, 300);
    EXPECT_GT(refused, 300);
}

TEST(Mutations, OfImagesAreReadOrRefusedInASentence)
{
    const Picture picture = sample_picture(23, 9, 3);
    const Bytes palette = png_chunk("PLTE", {1, 2, 3, 40, 50, 60});
    const std::vector<Bytes> originals = {
        png_file(picture),
        jpeg_file(picture, 80),
        progressive_jpeg(),
        tga_file(picture, false, false),
        tga_file(sample_picture(23, 9, 4), true, true),
        raw_png(3, 2, 8, 3, {{1, 0, 1}, {0, 0, 1}}, palette),
        raw_png(2, 2, 16, 6, {Bytes(16, 1), Bytes(16, 2)}),
    };
    Mutator mutator(12);
    int read = 0;
    int refused = 0;
    for (int i = 0; i < 6000; ++i) {
        const Bytes bytes = mutator.damaged(originals[std::size_t(i) % originals.size()]);
        const base::Result<image::Image> result = image::read_image("texture", bytes);
        ASSERT_EQ(result ? broken_invariant(result.value()) : broken_invariant(result.error(), 0), "") << i;
        ++(result ? read : refused);
    }
    EXPECT_GT(read, 300);
    EXPECT_GT(refused, 300);
}

} // namespace
