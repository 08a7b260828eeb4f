#include "tests/mesh/sample_files.h"

#include <algorithm>
#include <sstream>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace {

void append_to_bytes(void* context, void* data, int size)
{
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    static_cast<Bytes*>(context)->insert(static_cast<Bytes*>(context)->end(), bytes, bytes + size);
}

void append_big_endian(Bytes& bytes, std::uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(std::uint8_t(value >> shift));
}

void append_little_endian_16(Bytes& bytes, int value)
{
    bytes.push_back(std::uint8_t(value & 255));
    bytes.push_back(std::uint8_t(value >> 8));
}

std::uint32_t crc32(const Bytes& bytes)
{
    std::uint32_t crc = 0xFFFFFFFF;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320 : 0);
    }
    return ~crc;
}

std::uint32_t adler32(const Bytes& bytes)
{
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const std::uint8_t byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

/// A zlib stream of one block that is not compressed.
Bytes stored_zlib(const Bytes& data)
{
    Bytes zlib = {0x78, 0x01, 0x01};
    append_little_endian_16(zlib, int(data.size()));
    append_little_endian_16(zlib, int(~data.size() & 0xFFFF));
    zlib.insert(zlib.end(), data.begin(), data.end());
    append_big_endian(zlib, adler32(data));
    return zlib;
}

} // namespace

std::string sample_obj()
{
    return "# a cube\no cube\n"
           "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
           "vn 0 0 -1\nvn 0 0 1\nvn -1 0 0\nvn 1 0 0\nvn 0 -1 0\nvn 0 1 0\n"
           "g sides\ns off\nusemtl steel\n"
           "f 1/1/1 4/2/1 3/3/1 2/4/1\nf 5/1/2 6/2/2 7/3/2 8/4/2\nf 1/1/3 5/2/3 8/3/3 4/4/3\n"
           "f -7/-4/-3 -6/-3/-3 -2/-2/-3 -3/-1/-3\n"
           "g ends\ns 1\nf 1/1/5 2/2/5 6/3/5 \\\n 5/4/5\nf 4/1/6 8/2/6 7/3/6 3/4/6\n";
}

std::string written_obj(const mesh::ObjMesh& m)
{
    std::ostringstream text;
    text.precision(9); // enough to give every float back
    for (const glm::vec3& p : m.positions)
        text << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (const glm::vec2& t : m.texture_coordinates)
        text << "vt " << t.x << ' ' << t.y << '\n';
    for (const glm::vec3& n : m.normals)
        text << "vn " << n.x << ' ' << n.y << ' ' << n.z << '\n';
    for (const mesh::Face& face : m.faces) {
        text << 'f';
        for (const mesh::FaceVertex& v : face.vertices) {
            text << ' ' << v.position + 1 << '/';
            if (v.texture_coordinate >= 0)
                text << v.texture_coordinate + 1;
            text << '/' << v.normal + 1;
        }
        text << '\n';
    }
    return text.str();
}

Picture sample_picture(int width, int height, int channels)
{
    Picture picture{width, height, channels, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < channels; ++channel)
                picture.pixels.push_back(std::uint8_t(x * 7 + y * 31 + channel * 83));
    return picture;
}

Bytes png_file(const Picture& p)
{
    Bytes bytes;
    stbi_write_png_to_func(append_to_bytes, &bytes, p.width, p.height, p.channels, p.pixels.data(), 0);
    return bytes;
}

Bytes jpeg_file(const Picture& p, int quality)
{
    Bytes bytes;
    stbi_write_jpg_to_func(append_to_bytes, &bytes, p.width, p.height, p.channels, p.pixels.data(), quality);
    return bytes;
}

Bytes tga_file(const Picture& p, bool run_length_encoded, bool from_the_bottom)
{
    Bytes bytes = {0, 0, std::uint8_t(run_length_encoded ? 10 : 2), 0, 0, 0, 0, 0, 0, 0, 0, 0};
    append_little_endian_16(bytes, p.width);
    append_little_endian_16(bytes, p.height);
    bytes.push_back(std::uint8_t(p.channels * 8));
    bytes.push_back(std::uint8_t((from_the_bottom ? 0 : 0x20) | (p.channels == 4 ? 8 : 0)));
    const auto append_pixel = [&](std::size_t at) {
        for (const std::size_t channel : {2, 1, 0, 3})
            if (channel < std::size_t(p.channels))
                bytes.push_back(p.pixels[at + channel]);
    };
    const std::size_t row_bytes = std::size_t(p.width) * std::size_t(p.channels);
    for (int row = 0; row < p.height; ++row) {
        const std::size_t begin = std::size_t(from_the_bottom ? p.height - 1 - row : row) * row_bytes;
        for (std::size_t at = begin; at < begin + row_bytes;) {
            std::size_t pixels = 1;
            const auto next_is_the_same = [&] {
                const std::size_t next = at + pixels * std::size_t(p.channels);
                return next < begin + row_bytes &&
                       std::equal(p.pixels.begin() + long(at), p.pixels.begin() + long(at) + p.channels,
                                  p.pixels.begin() + long(next));
            };
            if (run_length_encoded) {
                while (pixels < 128 && next_is_the_same())
                    ++pixels;
                bytes.push_back(std::uint8_t(pixels > 1 ? 0x80 | (pixels - 1) : 0));
            }
            append_pixel(at);
            at += pixels * std::size_t(p.channels);
        }
    }
    return bytes;
}

Bytes png_chunk(const std::string& type, const Bytes& data)
{
    Bytes named(type.begin(), type.end());
    named.insert(named.end(), data.begin(), data.end());
    Bytes chunk;
    append_big_endian(chunk, std::uint32_t(data.size()));
    chunk.insert(chunk.end(), named.begin(), named.end());
    append_big_endian(chunk, crc32(named));
    return chunk;
}

Bytes raw_png(int width, int height, int depth, int colour_type, const std::vector<Bytes>& rows,
              const Bytes& extra)
{
    Bytes header;
    append_big_endian(header, std::uint32_t(width));
    append_big_endian(header, std::uint32_t(height));
    header.insert(header.end(), {std::uint8_t(depth), std::uint8_t(colour_type), 0, 0, 0});
    Bytes filtered;
    for (const Bytes& row : rows) {
        filtered.push_back(0);
        filtered.insert(filtered.end(), row.begin(), row.end());
    }
    Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    for (const Bytes& part :
         {png_chunk("IHDR", header), extra, png_chunk("IDAT", stored_zlib(filtered)), png_chunk("IEND", {})})
        file.insert(file.end(), part.begin(), part.end());
    return file;
}
