#include "picture_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace oracle {

PictureDifference difference(const std::string& a, const std::string& b)
{
    PictureDifference difference;
    for (std::size_t pixel = 0; pixel + 4 <= a.size(); pixel += 4) {
        int greatest = 0;
        for (std::size_t i = pixel; i < pixel + 4; ++i) {
            greatest = std::max(
                greatest, std::abs(static_cast<unsigned char>(a[i]) - static_cast<unsigned char>(b[i])));
        }
        difference.pixels += greatest > 0;
        difference.visible += greatest > 2;
        difference.greatest = std::max(difference.greatest, greatest);
    }
    return difference;
}

} // namespace oracle
