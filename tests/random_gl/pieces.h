#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glu.h>

namespace random_gl {

/// Functions above OpenGL that random programs call: what a program would have written itself, in one line.

/// Maps the square [-extent, extent]² onto the viewport.
void plane_view(double extent);
/// Sets a perspective of the angle in degrees and looks from (x, y, z) at the origin.
void perspective_view(double angle_degrees, float x, float y, float z);

/// Gives the bound texture, of 2 dimensions, an image of a noisy pattern. generates: levels of detail, too.
void texture_image(GLenum internal_format, int width, int height, bool generates);

enum class Mesh
{
    cube,
    torus,
    wave,
    ring,
    ball
};
/// Draws a mesh of about detail² faces, in the way its name says: with normals, texture coordinates and, if
/// wanted, colours.
void mesh(int which, int detail, bool colors);

/// Draws a quadric: 0 sphere, 1 cylinder, 2 disk, 3 part of a disk.
void quadric(int which, GLenum style, GLenum normals, bool textured, bool inside, int slices, int stacks);

/// Draws count vertices of arrays of the mode: 0 by glDrawArrays, 1 by glDrawElements, 2 by glArrayElement,
/// 3 from interleaved arrays.
void array(GLenum mode, int count, int how, unsigned seed);

/// Copies a part of the picture into the bound texture of 2 dimensions.
void copied_texture(int x, int y, int width, int height);

} // namespace random_gl
