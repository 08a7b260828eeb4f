#include "image/jpeg_check.h"

#include <algorithm>
#include <cstddef>

namespace image {
namespace {

// Markers and segments: ITU-T T.81, annex B.
constexpr std::uint8_t DEFINE_HUFFMAN_TABLES = 0xC4;
constexpr std::uint8_t START_OF_SCAN = 0xDA;
constexpr std::uint8_t END_OF_IMAGE = 0xD9;

/// Tells whether each Huffman table of the segment at `at`, behind its marker, has at most 256 codes
/// (B.2.4.2).
bool has_sound_huffman_tables(std::span<const std::uint8_t> bytes, std::size_t at)
{
    constexpr std::size_t TABLE_HEADER = 17;
    const auto byte = [&](std::size_t i) { return i < bytes.size() ? bytes[i] : std::uint8_t{0}; };
    const std::size_t end = at + 256 * byte(at) + byte(at + 1);
    for (at += 2; at < end;) {
        std::size_t codes = 0;
        for (std::size_t i = 1; i < TABLE_HEADER; ++i) {
            codes += byte(at + i);
        }
        if (codes > 256) {
            return false;
        }
        at += TABLE_HEADER + codes;
    }
    return true;
}

/// What is found of interest from the first scan on, and in the segments before it.
struct Findings
{
    bool sound_tables = true;
    long long scans = 0;
    bool ends = false; ///< With the marker that says so.
};

/// Goes through the segments before the first scan as stb_image does: a marker (0xFF, perhaps repeated, and a
/// byte), then as many bytes as it says. What lies between is skipped. Returns where the first scan's marker
/// begins.
std::size_t look_at_header(std::span<const std::uint8_t> bytes, Findings& findings)
{
    std::size_t at = 0;
    while (at < bytes.size() && bytes[at] == 0xFF) {
        ++at;
    }
    ++at; // of "start of image", which stands alone
    while (at < bytes.size()) {
        const std::size_t marker_begin = at;
        while (at < bytes.size() && bytes[at] == 0xFF) {
            ++at;
        }
        if (at == marker_begin) {
            ++at;
            continue;
        }
        if (at + 2 >= bytes.size() || bytes[at] == START_OF_SCAN) {
            return marker_begin;
        }
        if (bytes[at] == DEFINE_HUFFMAN_TABLES) {
            findings.sound_tables &= has_sound_huffman_tables(bytes, at + 1);
        }
        at += 1 + std::max(256 * bytes[at + 1] + bytes[at + 2], 2);
    }
    return bytes.size();
}

/// From the first scan on, where stb_image may look for a marker anywhere, looks at all bytes that could be
/// one. The compressed data of a sound file holds none: 0xFF is followed by 0 there.
void look_at_scans(std::span<const std::uint8_t> bytes, std::size_t begin, Findings& findings)
{
    for (std::size_t i = begin; i + 1 < bytes.size(); ++i) {
        if (bytes[i] != 0xFF) {
            continue;
        }
        findings.scans += bytes[i + 1] == START_OF_SCAN ? 1 : 0;
        findings.ends |= bytes[i + 1] == END_OF_IMAGE;
        if (bytes[i + 1] == DEFINE_HUFFMAN_TABLES) {
            findings.sound_tables &= has_sound_huffman_tables(bytes, i + 2);
        }
    }
}

Findings look_at(std::span<const std::uint8_t> bytes)
{
    Findings findings;
    const std::size_t first_scan = look_at_header(bytes, findings);
    look_at_scans(bytes, first_scan, findings);
    return findings;
}

} // namespace

std::string check_jpeg_tables(std::span<const std::uint8_t> bytes)
{
    return look_at(bytes).sound_tables
               ? ""
               : "the JPEG image is damaged (in a Huffman table); copy or save it again";
}

std::string check_jpeg_scans(std::span<const std::uint8_t> bytes, long long pixels)
{
    // A block of 64 pixels costs at least a bit in one of the scans, so a byte gives at most 512 pixels of a
    // grey image. Real files have at most 350 a byte, and a dozen scans.
    constexpr long long most_pixels_per_byte = 1024;
    constexpr long long most_pixels_in_scans = 1LL << 30;
    const Findings found = look_at(bytes);
    if (!found.ends || pixels > most_pixels_per_byte * static_cast<long long>(bytes.size())) {
        return "the image is cut short; copy or save it again";
    }
    if (found.scans > 1 && found.scans * pixels > most_pixels_in_scans) {
        return "the JPEG image has " + std::to_string(found.scans) +
               " scans, too many for its size; save it again as PNG";
    }
    return {};
}

} // namespace image
