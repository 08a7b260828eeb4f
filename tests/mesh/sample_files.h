#pragma once

#include "mesh/obj_mesh.h"

#include <cstdint>
#include <string>
#include <vector>

using Bytes = std::vector<std::uint8_t>;

/// A cube of side 2 about the origin: six quads with normals and texture coordinates.
std::string sample_obj();

/// Writes a mesh as an OBJ text of triangles; reading it gives the same mesh.
std::string written_obj(const mesh::ObjMesh& m);

/// Pixels to be written: rows from the top down.
struct Picture
{
    int width;
    int height;
    int channels;
    Bytes pixels;
};

/// A picture whose every pixel differs from its neighbours, in each channel in another way.
Picture sample_picture(int width, int height, int channels);

Bytes png_file(const Picture& picture);
Bytes jpeg_file(const Picture& picture, int quality);

/// A baseline JPEG and the same one as a progressive JPEG, made from it by jpegtran; they decode to the same
/// pixels.
Bytes baseline_jpeg();
Bytes progressive_jpeg();

/// A TGA of 24 bits (3 channels) or 32 (4), as its header says: from the bottom up or from the top down.
Bytes tga_file(const Picture& picture, bool run_length_encoded, bool from_the_bottom);

/// A PNG of any colour type and depth. `rows`: the packed samples of each row, without filter bytes; `extra`:
/// chunks that come before the pixels, such as png_chunk("PLTE", ...).
Bytes raw_png(int width, int height, int depth, int colour_type, const std::vector<Bytes>& rows,
              const Bytes& extra = {});
Bytes png_chunk(const std::string& type, const Bytes& data);
