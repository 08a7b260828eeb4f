#pragma once

#include "image/image.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace assets {

/// Holds an image of which each pixel is the mean of a square of another's: what OpenGL shows of a texture
/// from so far away that the square is as large as a pixel of the window.
class Mipmap
{
public:
    /// Averages squares of side x side pixels; those at the far edges are cut off.
    /// Preconditions: side >= 1; the image has as many pixels as its size says, at least one.
    Mipmap(const image::Image& image, int side);

    /// Returns red, green and blue in [0, 1] at a texture coordinate: between the four nearest pixels; the
    /// image repeats (OpenGL 1.1, 3.8.1, GL_LINEAR and GL_REPEAT).
    glm::vec3 colour_at(const glm::vec2& place) const;

private:
    const glm::vec3& pixel(float x, float y) const;

    int width_;
    int height_;
    std::vector<glm::vec3> pixels_;
};

} // namespace assets
