// Draws random programs through legacygl and through the system's OpenGL and compares the pictures.
//
//   oracle_fuzz [FIRST [COUNT]]       one line for each seed that differs, and how many are identical
//   oracle_fuzz --shrink FIRST COUNT  the same, and for each that differs the fewest calls that do, as C++
//   oracle_fuzz --test                the test's seeds: each identical, or as exceptions.h says
//   oracle_fuzz --print SEED          all calls of a seed's program, as C++

#include "fuzz/drawer.h"
#include "fuzz/exceptions.h"
#include "fuzz/fuzz_program.h"
#include "picture_difference.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace {

using oracle::PictureDifference;
using oracle::fuzz::Drawer;

class Comparison
{
public:
    /// folder: where the drawers are.
    explicit Comparison(const std::string& folder)
        : emulated_(folder + "oracle_fuzz_emulated"), reference_(folder + "oracle_fuzz_reference")
    {}

    PictureDifference of(unsigned seed, const std::vector<std::size_t>& kept)
    {
        emulated_.ask(seed, kept);
        reference_.ask(seed, kept);
        const std::string emulated = emulated_.answer();
        return compare(emulated, reference_.answer());
    }

    /// Returns the major version of Mesa that draws the reference, see mesa_version().
    int reference_version()
    {
        reference_.ask_version();
        return oracle::mesa_version(reference_.answer());
    }

private:
    static PictureDifference compare(const std::string& a, const std::string& b)
    {
        constexpr std::size_t BYTES = static_cast<std::size_t>(oracle::fuzz::SIZE) * oracle::fuzz::SIZE * 4;
        if (a.size() < BYTES || b.size() < BYTES) {
            return {-1, -1, 255, false};
        }
        PictureDifference difference = oracle::difference(a.substr(0, BYTES), b.substr(0, BYTES));
        difference.told = a.substr(BYTES) != b.substr(BYTES);
        return difference;
    }

    Drawer emulated_, reference_;
};

void print(const random_gl::Program& program, const std::vector<std::size_t>& kept)
{
    for (const std::size_t i : kept) {
        std::printf("    %s\n", program.commands()[i].text.c_str());
    }
}

void say(unsigned seed, const PictureDifference& d)
{
    std::printf("seed %u: %d pixels differ, %d by more than 2, by %d at most%s\n", seed, d.pixels, d.visible,
                d.greatest, d.told ? "; other errors" : "");
    std::fflush(stdout);
}

/// Leaves out more and more calls as long as the picture differs (Zeller's delta debugging).
std::vector<std::size_t> shrunk(Comparison& comparison, unsigned seed, const random_gl::Program& program)
{
    std::vector<std::size_t> kept = oracle::fuzz::all(program);
    const bool visible = comparison.of(seed, kept).visible != 0;
    const auto fails = [&](const std::vector<std::size_t>& some) {
        const PictureDifference d = comparison.of(seed, some);
        return visible ? d.visible != 0 : d.differs();
    };
    for (std::size_t chunk = kept.size() / 2; chunk != 0;) {
        bool less = false;
        for (std::size_t from = kept.size(); from != 0;) {
            from -= std::min(from, chunk);
            const std::vector<std::size_t> fewer = program.without(kept, from, from + chunk);
            if (!fewer.empty() && fewer.size() < kept.size() && fails(fewer)) {
                kept = fewer;
                from = std::min(from, kept.size());
                less = true;
            }
        }
        if (chunk > 1 || !less) {
            chunk /= 2;
        }
    }
    return kept;
}

int sweep(Comparison& comparison, unsigned first, unsigned count, bool shrinks)
{
    unsigned identical = 0, within_two = 0;
    for (unsigned seed = first; seed < first + count; ++seed) {
        const random_gl::Program program = oracle::fuzz::make_program(seed);
        const PictureDifference d = comparison.of(seed, oracle::fuzz::all(program));
        identical += !d.differs();
        within_two += d.differs() && d.visible == 0 && !d.told;
        if (!d.differs()) {
            continue;
        }
        say(seed, d);
        if (!shrinks) {
            continue;
        }
        const std::vector<std::size_t> kept = shrunk(comparison, seed, program);
        say(seed, comparison.of(seed, kept));
        print(program, kept);
    }
    std::printf("%u of %u identical, %u more within 2 of 255\n", identical, count, within_two);
    return identical == count ? 0 : 1;
}

/// Returns whether a seed is as it should be, and says so where not.
bool holds(unsigned seed, const PictureDifference& d, int version)
{
    const auto exception =
        std::find_if(oracle::fuzz::EXCEPTIONS.begin(), oracle::fuzz::EXCEPTIONS.end(),
                     [&](const auto& e) { return e.seed == seed && e.versions.contain(version); });
    if (exception == oracle::fuzz::EXCEPTIONS.end()) {
        if (d.differs()) {
            say(seed, d);
        }
        return !d.differs();
    }
    if (!d.differs()) {
        std::printf("seed %u: the exception is not needed any more, remove it: %s\n", seed, exception->why);
    } else if (d.pixels > exception->pixels || d.told) {
        say(seed, d);
    }
    return d.differs() && d.pixels <= exception->pixels && !d.told;
}

int test(Comparison& comparison)
{
    unsigned failures = 0;
    const int version = comparison.reference_version();
    for (unsigned seed = 1; seed <= oracle::fuzz::TEST_SEEDS; ++seed) {
        const random_gl::Program program = oracle::fuzz::make_program(seed);
        failures += !holds(seed, comparison.of(seed, oracle::fuzz::all(program)), version);
    }
    std::printf("%u seeds; %u failures\n", oracle::fuzz::TEST_SEEDS, failures);
    return failures == 0 ? 0 : 1;
}

std::string folder_of(const std::string& path)
{
    return path.substr(0, path.rfind('/') + 1);
}

} // namespace

int main(int argc, char** argv)
{
    const std::string option = argc > 1 && argv[1][0] == '-' ? argv[1] : "";
    const int numbers = option.empty() ? 1 : 2;
    const auto number = [&](int i, unsigned otherwise) {
        return i < argc ? static_cast<unsigned>(std::strtoul(argv[i], nullptr, 10)) : otherwise;
    };
    const unsigned first = number(numbers, 1);
    if (option == "--print") {
        const random_gl::Program program = oracle::fuzz::make_program(first);
        print(program, oracle::fuzz::all(program));
        return 0;
    }
    Comparison comparison(folder_of(argv[0]));
    if (option == "--test") {
        return test(comparison);
    }
    return sweep(comparison, first, number(numbers + 1, option.empty() ? 200 : 1), option == "--shrink");
}
