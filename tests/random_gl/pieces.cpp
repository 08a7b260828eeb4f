#include "random_gl/pieces.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace random_gl {
namespace {

constexpr double TURN = 6.283185307179586;

float cosine(double turns)
{
    return static_cast<float>(std::cos(turns * TURN));
}

float sine(double turns)
{
    return static_cast<float>(std::sin(turns * TURN));
}

/// Small numbers that look random.
float hashed(unsigned seed, unsigned i)
{
    std::uint32_t h = seed * 2654435761u ^ (i + 1) * 2246822519u;
    h = (h ^ h >> 15) * 2246822519u;
    h = (h ^ h >> 13) * 3266489917u;
    return static_cast<float>((h ^ h >> 16) & 1023) / 1023.0f;
}

void color_of(double u, double v)
{
    glColor3f(0.5f + 0.5f * cosine(u), 0.5f + 0.5f * sine(v), static_cast<float>(u));
}

void torus_vertex(double u, double v, bool colors)
{
    if (colors) {
        color_of(u, v);
    }
    const float r = 0.6f + 0.25f * cosine(v);
    glNormal3f(cosine(u) * cosine(v), sine(u) * cosine(v), sine(v));
    glTexCoord2d(u * 4, v * 2);
    glVertex3f(r * cosine(u), r * sine(u), 0.25f * sine(v));
}

void wave_vertex(double u, double v, bool colors)
{
    if (colors) {
        color_of(u, v);
    }
    const float height = 0.15f * sine(u * 2) * cosine(v);
    glNormal3f(-cosine(u * 2), 1, sine(v));
    glTexCoord2d(u, v);
    glVertex3f(static_cast<float>(u * 2 - 1), height, static_cast<float>(v * 2 - 1));
}

void ball_vertex(double u, double v, bool colors)
{
    if (colors) {
        color_of(u, v);
    }
    const float x = cosine(u) * sine(v / 2), y = sine(u) * sine(v / 2), z = cosine(v / 2);
    glNormal3f(x, y, z);
    glTexCoord2d(u, v);
    glVertex3f(0.8f * x, 0.8f * y, 0.8f * z);
}

template <class Vertex> void strips(GLenum mode, int detail, Vertex vertex)
{
    for (int i = 0; i < detail; ++i) {
        glBegin(mode);
        for (int j = 0; j <= detail; ++j) {
            vertex(static_cast<double>(i) / detail, static_cast<double>(j) / detail);
            vertex(static_cast<double>(i + 1) / detail, static_cast<double>(j) / detail);
        }
        glEnd();
    }
}

template <class Vertex> void faces(int detail, Vertex vertex)
{
    glBegin(GL_QUADS);
    for (int i = 0; i < detail; ++i) {
        for (int j = 0; j < detail; ++j) {
            for (const std::array<int, 2>& corner : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                vertex(static_cast<double>(i + corner[0]) / detail,
                       static_cast<double>(j + corner[1]) / detail);
            }
        }
    }
    glEnd();
}

void cube(bool colors)
{
    constexpr float n[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    glBegin(GL_QUADS);
    for (int face = 0; face < 6; ++face) {
        glNormal3fv(n[face]);
        if (colors) {
            color_of(face / 6.0, face / 3.0);
        }
        const int axis = face / 2, right = (axis + 1) % 3, up = (axis + 2) % 3;
        for (int corner = 0; corner < 4; ++corner) {
            const int around = face % 2 ? 3 - corner : corner;
            float p[3];
            p[axis] = 0.6f * n[face][axis];
            p[right] = around == 1 || around == 2 ? 0.6f : -0.6f;
            p[up] = around >= 2 ? 0.6f : -0.6f;
            glTexCoord2f(p[right] + 0.6f, p[up] + 0.6f);
            glVertex3fv(p);
        }
    }
    glEnd();
}

void ring(int detail, bool colors)
{
    glBegin(GL_TRIANGLE_FAN);
    glNormal3f(0, 0, 1);
    glTexCoord2f(0.5f, 0.5f);
    if (colors) {
        glColor3f(1, 1, 1);
    }
    glVertex2f(0, 0);
    for (int i = 0; i <= detail; ++i) {
        const double turns = static_cast<double>(i) / detail;
        if (colors) {
            color_of(turns, turns);
        }
        glTexCoord2f(0.5f + 0.5f * cosine(turns), 0.5f + 0.5f * sine(turns));
        glVertex2f(0.9f * cosine(turns), 0.9f * sine(turns));
    }
    glEnd();
}

} // namespace

void plane_view(double extent)
{
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-extent, extent, -extent, extent, -1, 1);
    glMatrixMode(GL_MODELVIEW);
}

void perspective_view(double angle_degrees, float x, float y, float z)
{
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(angle_degrees, 1, 0.5, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z), 0, 0, 0, 0, 1, 0);
}

void texture_image(GLenum internal_format, int width, int height, bool generates)
{
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        texels[i] = static_cast<std::uint8_t>(i * 37 ^ i / 64 * 80);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, generates);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), width, height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texels.data());
}

void mesh(int which, int detail, bool colors)
{
    const auto torus = [=](double u, double v) { torus_vertex(u, v, colors); };
    const auto wave = [=](double u, double v) { wave_vertex(u, v, colors); };
    const auto ball = [=](double u, double v) { ball_vertex(u, v, colors); };
    switch (which) {
    case 0:
        return cube(colors);
    case 1:
        return strips(GL_QUAD_STRIP, detail, torus);
    case 2:
        return faces(detail, wave);
    case 3:
        return ring(detail, colors);
    case 4:
        return strips(GL_TRIANGLE_STRIP, detail, ball);
    case 5:
        return strips(GL_LINE_STRIP, detail, wave);
    default:
        return strips(GL_QUAD_STRIP, detail, wave);
    }
}

void quadric(int which, GLenum style, GLenum normals, bool textured, bool inside, int slices, int stacks)
{
    GLUquadric* q = gluNewQuadric();
    gluQuadricDrawStyle(q, style);
    gluQuadricNormals(q, normals);
    gluQuadricTexture(q, static_cast<GLboolean>(textured));
    gluQuadricOrientation(q, inside ? GLU_INSIDE : GLU_OUTSIDE);
    if (which == 0) {
        gluSphere(q, 0.7, slices, stacks);
    } else if (which == 1) {
        gluCylinder(q, 0.5, 0.3, 0.9, slices, stacks);
    } else if (which == 2) {
        gluDisk(q, 0.2, 0.8, slices, stacks);
    } else {
        gluPartialDisk(q, 0.1, 0.8, slices, stacks, 30, 250);
    }
    gluDeleteQuadric(q);
}

void array(GLenum mode, int count, int how, unsigned seed)
{
    struct Vertex
    {
        float s, t;
        GLubyte color[4];
        float normal[3];
        float position[3];
    };
    static_assert(sizeof(Vertex) == 9 * sizeof(float));
    std::vector<Vertex> vertices(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const auto at = [&](unsigned which) { return hashed(seed, static_cast<unsigned>(i) * 16 + which); };
        Vertex& v = vertices[static_cast<std::size_t>(i)];
        v.s = 2 * at(0);
        v.t = 2 * at(1);
        for (unsigned c = 0; c < 4; ++c) {
            v.color[c] = static_cast<GLubyte>(at(2 + c) * 255);
        }
        for (unsigned c = 0; c < 3; ++c) {
            v.normal[c] = at(6 + c) * 2 - 1;
            v.position[c] = at(9 + c) * 2.5f - 1.25f;
        }
    }
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    if (how == 3) {
        struct Interleaved
        {
            GLubyte color[4];
            float position[3];
        };
        std::vector<Interleaved> interleaved;
        for (const Vertex& v : vertices) {
            interleaved.push_back({{v.color[0], v.color[1], v.color[2], v.color[3]},
                                   {v.position[0], v.position[1], v.position[2]}});
        }
        glInterleavedArrays(GL_C4UB_V3F, 0, interleaved.data());
        glDrawArrays(mode, 0, count);
        glPopClientAttrib();
        return;
    }
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), vertices.data()->position);
    glNormalPointer(GL_FLOAT, sizeof(Vertex), vertices.data()->normal);
    glColorPointer(seed % 2 ? 3 : 4, GL_UNSIGNED_BYTE, sizeof(Vertex), vertices.data()->color);
    glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), &vertices.data()->s);
    glEnableClientState(GL_VERTEX_ARRAY);
    if (seed & 2) {
        glEnableClientState(GL_NORMAL_ARRAY);
    }
    if (seed & 4) {
        glEnableClientState(GL_COLOR_ARRAY);
    }
    if (seed & 8) {
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    }
    if (how == 0) {
        glDrawArrays(mode, 0, count);
    } else if (how == 1) {
        std::vector<GLushort> indices;
        for (int i = 0; i < count + 3; ++i) {
            indices.push_back(static_cast<GLushort>(hashed(seed + 99, static_cast<unsigned>(i)) *
                                                    static_cast<float>(count - 1)));
        }
        glDrawElements(mode, count + 3, GL_UNSIGNED_SHORT, indices.data());
    } else {
        glBegin(mode);
        for (int i = 0; i < count; ++i) {
            glArrayElement(i);
        }
        glEnd();
    }
    glPopClientAttrib();
}

void copied_texture(int x, int y, int width, int height)
{
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, x, y, width, height, 0);
}

} // namespace random_gl
