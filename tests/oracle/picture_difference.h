#pragma once

#include <string>

namespace oracle {

/// How two pictures differ.
struct PictureDifference
{
    int pixels = 0;  ///< That differ at all.
    int visible = 0; ///< That differ by more than 2 of 255.
    int greatest = 0;
    bool told = false; ///< What was told beside them differs.

    bool differs() const { return pixels != 0 || told; }
};

/// Compares pictures of the same size, of four bytes a pixel.
PictureDifference difference(const std::string& a, const std::string& b);

} // namespace oracle
