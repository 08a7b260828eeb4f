#pragma once

#include "mesa_version.h"

#include <functional>
#include <string>
#include <vector>

namespace oracle {

/// How many pixels of a scene may differ from the system's OpenGL by more than 2 of 255, and why. Zero for
/// all but counted, explained exceptions. Where only some versions of Mesa differ, `why` names the clause of
/// the specification that decides, or that leaves it open.
struct Exception
{
    int pixels = 0;
    const char* why = "";
    MesaVersions versions{};
    int told = 0; ///< How far whole numbers that the scene tells may be off.
};

/// Why some pixels differ on Mesa 26: where a line and its face, or two surfaces, are equally far away, or a
/// pixel's centre is on an edge of a triangle or texel, the last bit decides what it shows.
constexpr const char* LAST_BIT_DECIDES = "OpenGL 1.5, 2.1.1, asks of computing to be right to about 1 part "
                                         "in 10^5. This Mesa fuses the products and sums "
                                         "of the fixed transform, which a shader of ES 3.0 cannot.";

/// The size of a picture in pixels.
struct Size
{
    int width;
    int height;
};

constexpr int WIDTH = 160;
constexpr int HEIGHT = 120;

/// A picture drawn by plain OpenGL 1.x calls: once through legacygl, once through the system's OpenGL.
struct Scene
{
    std::string name;
    std::function<void()> draw;
    Exception exception;
    Size size{WIDTH, HEIGHT};
};

/// All scenes, in the order they were registered.
std::vector<Scene>& scenes();

struct Registration
{
    Registration(const char* name, void (*draw)(), Exception exception = {})
    {
        scenes().push_back({name, draw, exception});
    }
};

/// Says something a scene found out (a query's answer, an error); both sides must say the same.
void tell(const std::string& line);

/// Returns what glGetError does, and notes that the scene is wrong on purpose.
unsigned next_error();

} // namespace oracle

/// Defines a scene; its body are the calls.
#define SCENE(name, ...)                                                                                     \
    static void name();                                                                                      \
    static const oracle::Registration name##_registration(#name, name, ##__VA_ARGS__);                       \
    static void name()
