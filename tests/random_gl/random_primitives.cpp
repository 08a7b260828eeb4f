#include "random_gl/pieces.h"
#include "random_gl/random_stream.h"

#include <span>

namespace random_gl {

void RandomStream::primitive()
{
    if (uses(Feature::display_lists) && pick(6) == 0) {
        return list();
    }
    if (uses(Feature::attribute_stack) && pick(8) == 0) {
        return pushed();
    }
    if (uses(Feature::rectangles) && pick(4) == 0) {
        return rectangle();
    }
    if (uses(Feature::quadrics) && pick(4) == 0) {
        return quadric();
    }
    if (uses(Feature::meshes) && pick(3) == 0) {
        return mesh();
    }
    if (uses(Feature::arrays) && pick(4) == 0) {
        return array();
    }
    loose_primitive();
}

void RandomStream::begin(Name mode)
{
    begun_ = RANDOM_GL_CALL(glBegin, mode);
}

void RandomStream::end()
{
    program_.pair(begun_, RANDOM_GL_CALL(glEnd), true);
}

Name RandomStream::mode()
{
    if (uses(Feature::quads) && pick(6) == 0) {
        return RANDOM_GL_NAME(GL_QUADS);
    }
    if (!uses(Feature::quad_strips)) {
        return RANDOM_GL_ANY(GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES,
                             GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_POLYGON);
    }
    return RANDOM_GL_ANY(GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES, GL_TRIANGLE_STRIP,
                         GL_TRIANGLE_FAN, GL_QUAD_STRIP, GL_POLYGON);
}

/// Returns a number of vertices, in a list one that leaves none over: Mesa repeats the last one there.
int RandomStream::vertex_count(GLenum mode)
{
    const int count = 1 + pick(9);
    if (!in_list_ && pick(5) == 0) {
        return count;
    }
    switch (mode) {
    case GL_POINTS:
        return count;
    case GL_LINES:
        return (count + 1) / 2 * 2;
    case GL_LINE_STRIP:
    case GL_LINE_LOOP:
        return count + 1;
    case GL_TRIANGLES:
        return (count + 2) / 3 * 3;
    case GL_QUADS:
        return (count + 3) / 4 * 4;
    case GL_QUAD_STRIP:
        return (count + 3) / 2 * 2;
    default:
        return count + 2;
    }
}

void RandomStream::loose_primitive()
{
    const Name name = mode();
    const int count = vertex_count(name.value);
    const int components = uses(Feature::homogeneous) && pick(3) == 0 ? 4 : pick(4) == 0 ? 2 : 3;
    std::array<int, 3> varying{};
    const auto some = std::span(varying).first(static_cast<std::size_t>(pick(4)));
    for (int& which : some) {
        which = pick(ATTRIBUTES);
    }
    if (uses(Feature::textures) && !some.empty()) {
        some.front() = TEXTURE_COORDINATE;
    }
    program_.begin_unit(); // All that the vertices get, the first one gets with glBegin.
    begin(name);
    for (int i = 0; i < count; ++i) {
        for (const int which : some) {
            if (i == 0 || pick(3)) {
                attribute(which);
            }
        }
        if (uses(Feature::ragged) && pick(3) == 0) {
            attribute(pick(ATTRIBUTES));
        }
        vertex(uses(Feature::ragged) ? 2 + pick(2) : components);
        program_.begin_unit();
    }
    program_.end_unit();
    end();
}

void RandomStream::vertex(int components)
{
    const float x = number() * 1.25f, y = number() * 1.25f, z = number();
    if (components == 4) {
        const float w = pick(12) ? 0.5f + part() : part();
        RANDOM_GL_CALL(glVertex4f, x, y, z, w);
    } else if (components == 2) {
        RANDOM_GL_CALL(glVertex2f, x, y);
    } else if (pick(8) == 0) {
        RANDOM_GL_CALL(glVertex3d, static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
    } else {
        RANDOM_GL_CALL(glVertex3f, x, y, z);
    }
}

void RandomStream::attribute(int which)
{
    const Values<float, 4> v = four();
    const auto& a = v.values;
    switch (which) {
    case 0:
    case 1:
        if (has_alpha_ || uses(Feature::ragged)) {
            RANDOM_GL_CALL(glColor4fv, v);
        } else {
            RANDOM_GL_CALL(glColor3fv, v);
        }
        return;
    case 2:
        if (has_alpha_) {
            RANDOM_GL_CALL(glColor4ub, static_cast<GLubyte>(pick(256)), static_cast<GLubyte>(pick(256)),
                           static_cast<GLubyte>(pick(256)), static_cast<GLubyte>(pick(256)));
        } else {
            RANDOM_GL_CALL(glColor3ub, static_cast<GLubyte>(pick(256)), static_cast<GLubyte>(pick(256)),
                           static_cast<GLubyte>(pick(256)));
        }
        return;
    case 3:
        RANDOM_GL_CALL(glNormal3f, a[0] - 0.5f, a[1] - 0.5f, 1.0f);
        return;
    case 4:
        RANDOM_GL_CALL(glTexCoord2f, a[0] * 2, a[1] * 2);
        return;
    case 5:
        if (uses(Feature::edge_flags)) {
            RANDOM_GL_CALL(glEdgeFlag, static_cast<GLboolean>(a[0] < 0.7f));
        }
        return;
    case 6:
        if (uses(Feature::fog_coordinates)) {
            RANDOM_GL_CALL(glFogCoordf, a[0]);
        }
        return;
    case 7:
        if (uses(Feature::secondary_colors)) {
            RANDOM_GL_CALL(glSecondaryColor3fv, v);
        }
        return;
    case 8:
        if (uses(Feature::second_texture_unit)) {
            RANDOM_GL_CALL(glMultiTexCoord2f, RANDOM_GL_NAME(GL_TEXTURE1), a[0] * 2, a[1] * 2);
        }
        return;
    default:
        if (uses(Feature::materials)) {
            RANDOM_GL_CALL(glMaterialfv, RANDOM_GL_NAME(GL_FRONT_AND_BACK),
                           has_alpha_ ? RANDOM_GL_NAME(GL_DIFFUSE) : RANDOM_GL_NAME(GL_EMISSION), v);
        }
    }
}

void RandomStream::mesh()
{
    RANDOM_GL_CALL(random_gl::mesh, pick(7), 2 + pick(12), pick(2) != 0);
}

void RandomStream::rectangle()
{
    const float x0 = number(), y0 = number(), x1 = number(), y1 = number();
    RANDOM_GL_CALL(glRectf, x0, y0, x1, y1);
}

void RandomStream::quadric()
{
    const int which = pick(4);
    const Name style = RANDOM_GL_ANY(GLU_FILL, GLU_LINE, GLU_SILHOUETTE, GLU_POINT, GLU_FILL);
    // Points and silhouettes have no flat normals in libGLU: it reads memory that nothing was written to.
    const Name normals = style.value == GLU_POINT || style.value == GLU_SILHOUETTE
                             ? RANDOM_GL_ANY(GLU_SMOOTH, GLU_NONE)
                             : RANDOM_GL_ANY(GLU_SMOOTH, GLU_FLAT, GLU_NONE);
    const bool textured = pick(2) != 0, inside = pick(4) == 0;
    const int slices = 3 + pick(12), stacks = 1 + pick(10);
    RANDOM_GL_CALL(random_gl::quadric, which, style, normals, textured, inside, slices, stacks);
}

void RandomStream::array()
{
    const Name name = mode();
    const int count = vertex_count(name.value), how = pick(4);
    RANDOM_GL_CALL(random_gl::array, name, count, how, static_cast<unsigned>(pick(1000)));
}

/// Compiles a list of some commands, sometimes with lists in it, and calls it twice.
void RandomStream::list()
{
    if (depth_ != 0) {
        return loose_primitive();
    }
    ++depth_;
    const auto name = static_cast<GLuint>(++lists_);
    in_list_ = true;
    const std::size_t opened =
        RANDOM_GL_CALL(glNewList, name, RANDOM_GL_ANY(GL_COMPILE, GL_COMPILE, GL_COMPILE_AND_EXECUTE));
    for (int i = 1 + pick(6); i > 0; --i) {
        pick(2) ? primitive() : state();
    }
    if (name > 1 && pick(2)) {
        RANDOM_GL_CALL(glCallList, 1 + static_cast<GLuint>(pick(static_cast<int>(name) - 1)));
    }
    program_.pair(opened, RANDOM_GL_CALL(glEndList), false);
    in_list_ = false;
    --depth_;
    for (int i = pick(3); i >= 0; --i) {
        if (pick(2)) {
            state();
        }
        RANDOM_GL_CALL(glCallList, name);
    }
}

void RandomStream::pushed()
{
    if (depth_ > 1) {
        return loose_primitive();
    }
    ++depth_;
    const std::size_t opened =
        RANDOM_GL_CALL(glPushAttrib, RANDOM_GL_ANY(GL_ALL_ATTRIB_BITS, GL_ENABLE_BIT, GL_CURRENT_BIT,
                                                   GL_LIGHTING_BIT, GL_POLYGON_BIT));
    for (int i = 1 + pick(5); i > 0; --i) {
        pick(2) ? primitive() : state();
    }
    program_.pair(opened, RANDOM_GL_CALL(glPopAttrib), false);
    --depth_;
}

} // namespace random_gl
