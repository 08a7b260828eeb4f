#pragma once

#include <GL/gl.h>

#include <array>
#include <cstdint>

namespace legacygl {

/// The greatest point size and line width, and the steps between; Mesa's software renderer has the same.
constexpr GLfloat MAX_POINT_SIZE = 255, MAX_LINE_WIDTH = 255, SIZE_GRANULARITY = 0.1f;

/// How a point's size depends on its distance (OpenGL 1.5, 3.3).
struct PointParameters
{
    GLfloat minimum = 0;
    GLfloat maximum = MAX_POINT_SIZE;
    GLfloat fade_threshold = 1; ///< Only of multisampling, which no target has.
    std::array<GLfloat, 3> attenuation{1, 0, 0};
    bool attenuates() const { return attenuation != std::array<GLfloat, 3>{1, 0, 0}; }
};

/// OpenGL 1.5, 3.4.2.
struct LineStipple
{
    bool enabled = false;
    GLint factor = 1;
    GLushort pattern = 0xffff;
    /// Returns whether some of a line is left out.
    bool stipples() const { return enabled && pattern != 0xffff; }
};

/// A polygon stipple: 32 rows from the bottom, in each the leftmost pixel in the highest bit.
using StippleRows = std::array<std::uint32_t, 32>;

/// OpenGL 1.5, 3.5.2.
struct PolygonStipple
{
    PolygonStipple() { rows.fill(~0u); }
    bool enabled = false;
    StippleRows rows{};
};

/// OpenGL 1.5, table 6.13.
struct RasterState
{
    bool cull_face = false;
    GLenum cull_face_mode = GL_BACK;
    GLenum front_face = GL_CCW;
    std::array<GLenum, 2> polygon_mode{GL_FILL, GL_FILL}; ///< front, back
    bool polygon_smooth = false;
    PolygonStipple polygon_stipple;
    bool polygon_offset_fill = false;
    bool polygon_offset_line = false;
    bool polygon_offset_point = false;
    GLfloat polygon_offset_factor = 0;
    GLfloat polygon_offset_units = 0;
    GLfloat line_width = 1;
    bool line_smooth = false;
    LineStipple line_stipple;
    GLfloat point_size = 1;
    bool point_smooth = false;
    PointParameters point_parameters;
    GLenum provoking_vertex = GL_LAST_VERTEX_CONVENTION;

    /// Returns the size of points whose distance does not count. A minimum above the maximum leaves it open
    /// (OpenGL 1.5, 3.3); the minimum then counts, as in Mesa.
    GLfloat clamped_point_size() const
    {
        const GLfloat most = point_size > point_parameters.maximum ? point_parameters.maximum : point_size;
        const GLfloat size = most < point_parameters.minimum ? point_parameters.minimum : most;
        return size > MAX_POINT_SIZE ? MAX_POINT_SIZE : size;
    }
    /// Returns whether polygons are offset at their vertices, as Mesa does where it does any such work
    /// itself.
    bool offsets_in_pipeline() const
    {
        return (line_smooth || point_smooth || line_stipple.enabled || polygon_stipple.enabled) &&
               (polygon_offset_fill || polygon_offset_line || polygon_offset_point);
    }
    /// Returns whether polygons of the face (0 front, 1 back) are culled.
    bool culls(int face) const
    {
        return cull_face &&
               (cull_face_mode == GL_FRONT_AND_BACK || (cull_face_mode == GL_BACK) == (face == 1));
    }
    /// Returns the mode that polygons of the face (0 front, 1 back) are drawn in. Where the face is culled
    /// that is the other's, as in Mesa: what is culled and what is drawn are decided apart for polygons
    /// without an area, and one that is not culled must not take the mode of a face that is.
    GLenum drawn_mode(int face) const { return polygon_mode[culls(face) ? 1 - face : face]; }
    /// Returns whether polygons of some face are drawn as points or lines.
    bool unfilled() const
    {
        return (polygon_mode[0] != GL_FILL && !culls(0)) || (polygon_mode[1] != GL_FILL && !culls(1));
    }
};

} // namespace legacygl
