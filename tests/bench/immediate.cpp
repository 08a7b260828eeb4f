#include "programs.h"

#include <GL/gl.h>

#include <array>
#include <cmath>

namespace bench {
namespace {

constexpr int OBJECTS = 200;
constexpr int TRIANGLES = 64;
constexpr int TEXTURE = 64;

struct Corner
{
    float place[3], normal[3], texture[2];
};

std::array<Corner, TRIANGLES * 3> object;

/// A tube of 32 sides, two triangles each.
void make_object()
{
    constexpr int SIDES = TRIANGLES / 2;
    const auto corner = [](int side, int end) {
        const double angle = 2 * 3.14159265358979323846 * side / SIDES;
        const auto x = static_cast<float>(std::cos(angle)), y = static_cast<float>(std::sin(angle));
        return Corner{{0.4f * x, 0.4f * y, end - 0.5f},
                      {x, y, 0},
                      {static_cast<float>(side) / SIDES, static_cast<float>(end)}};
    };
    auto* out = object.data();
    for (int side = 0; side < SIDES; ++side) {
        for (const auto& [s, end] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
            *out++ = corner(side + s, end);
        }
    }
}

void make_texture()
{
    std::array<GLubyte, static_cast<std::size_t>(TEXTURE) * TEXTURE * 4> texels;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        texels[i] = (i / 32 + i / 4 / TEXTURE / 8) % 2 == 0 || i % 4 == 3 ? 255 : 90;
    }
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, TEXTURE, TEXTURE, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    glEnable(GL_TEXTURE_2D);
}

void setup()
{
    make_object();
    make_texture();
    glViewport(0, 0, SIZE, SIZE);
    glClearColor(0.1f, 0.1f, 0.2f, 1);
    glEnable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 2, 60);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    const GLfloat direction[] = {0.3f, 0.5f, 1, 0}, white[] = {1, 1, 1, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, direction);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, white);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHTING);
}

void frame(int number)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < OBJECTS; ++i) {
        glPushMatrix();
        glTranslatef(static_cast<float>(i % 20) - 9.5f, static_cast<float>(i / 20) * 2 - 9.0f, -22);
        glRotatef(static_cast<float>(number + 7 * i), 0.6f, 0.8f, 0);
        glBegin(GL_TRIANGLES);
        for (const Corner& corner : object) {
            glNormal3f(corner.normal[0], corner.normal[1], corner.normal[2]);
            glTexCoord2f(corner.texture[0], corner.texture[1]);
            glVertex3f(corner.place[0], corner.place[1], corner.place[2]);
        }
        glEnd();
        glPopMatrix();
    }
}

} // namespace

const Program immediate = {setup, frame};

} // namespace bench
