// gluCylinder (GLU 1.3, 6.4), its vertices in libGLU's order.

#include "legacygl/glu/quadric.h"

#include <cmath>

using namespace legacygl::glu;

namespace {

/// The side of a cylinder or cone frustum along the z axis.
class Cylinder
{
public:
    /// narrowing is base - top; length, of the side's straight lines, is positive.
    Cylinder(const GLUquadric& quadric, double base, float narrowing, double height, float length, int slices,
             int stacks)
        : quadric_(quadric), base_(base), narrowing_(narrowing), height_(height), slices_(slices),
          stacks_(stacks), around_(full_turn(slices)),
          normals_(full_turn(slices, static_cast<double>(normal_factor(quadric, height, length)))),
          face_normals_(full_turn(slices, static_cast<double>(normal_factor(quadric, height, length)), 0.5)),
          normal_z_(narrowing / length)
    {}

    void fill() const
    {
        for (int stack = 0; stack < stacks_; ++stack) {
            const Circle low = circle(stack), high = circle(stack + 1);
            glBegin(GL_QUAD_STRIP);
            for (int slice = 0; slice <= slices_; ++slice) {
                circle_normal(slice);
                vertex(slice, quadric_.outside() ? low : high);
                vertex(slice, quadric_.outside() ? high : low);
            }
            glEnd();
        }
    }

    void points() const
    {
        glBegin(GL_POINTS);
        for (int slice = 0; slice < slices_; ++slice) {
            // libGLU has no values for flat points; the smooth normals are what it must have meant.
            line_normal(slice, normal_z_);
            for (int stack = 0; stack <= stacks_; ++stack) {
                vertex(slice, circle(stack));
            }
        }
        glEnd();
    }

    void inner_circles() const
    {
        for (int stack = 1; stack < stacks_; ++stack) {
            draw_circle(stack);
        }
    }

    void silhouette() const
    {
        draw_circle(0);
        draw_circle(stacks_);
        for (int slice = 0; slice < slices_; ++slice) {
            line_normal(slice, 0); // Along these lines libGLU's normals do not lean, also a cone's.
            glBegin(GL_LINE_STRIP);
            for (int stack = 0; stack <= stacks_; ++stack) {
                vertex(slice, circle(stack));
            }
            glEnd();
        }
    }

private:
    struct Circle
    {
        float radius, z, texture_coordinate;
    };

    static float normal_factor(const GLUquadric& quadric, double height, float length)
    {
        const auto factor = static_cast<float>(height / static_cast<double>(length));
        return quadric.outside() ? factor : -factor;
    }

    Circle circle(int stack) const
    {
        const float fraction = static_cast<float>(stack) / static_cast<float>(stacks_);
        return {static_cast<float>(base_ - static_cast<double>(narrowing_ * fraction)),
                static_cast<float>(stack * height_ / stacks_), fraction};
    }

    void circle_normal(int slice) const
    {
        if (quadric_.normals == GLU_FLAT) {
            glNormal3f(face_normals_.sine[slice], face_normals_.cosine[slice], normal_z_);
        } else if (quadric_.normals == GLU_SMOOTH) {
            line_normal(slice, normal_z_);
        }
    }

    void line_normal(int slice, float z) const
    {
        if (quadric_.normals != GLU_NONE) {
            glNormal3f(normals_.sine[slice], normals_.cosine[slice], z);
        }
    }

    void vertex(int slice, const Circle& at) const
    {
        if (quadric_.textured) {
            glTexCoord2f(1 - static_cast<float>(slice) / static_cast<float>(slices_), at.texture_coordinate);
        }
        glVertex3f(at.radius * around_.sine[slice], at.radius * around_.cosine[slice], at.z);
    }

    void draw_circle(int stack) const
    {
        const Circle at = circle(stack);
        glBegin(GL_LINE_STRIP);
        for (int slice = 0; slice <= slices_; ++slice) {
            circle_normal(slice);
            vertex(slice, at);
        }
        glEnd();
    }

    const GLUquadric& quadric_;
    double base_;
    float narrowing_;
    double height_;
    int slices_, stacks_;
    AngleTable around_, normals_, face_normals_;
    float normal_z_;
};

} // namespace

void gluCylinder(GLUquadric* quad, GLdouble base, GLdouble top, GLdouble height, GLint slices, GLint stacks)
{
    if (slices < 2 || stacks < 1 || base < 0 || top < 0 || height < 0) {
        return quad->error(GLU_INVALID_VALUE);
    }
    const auto narrowing = static_cast<float>(base - top);
    const auto length =
        static_cast<float>(std::sqrt(static_cast<double>(narrowing * narrowing) + height * height));
    if (length == 0.0f) {
        return quad->error(GLU_INVALID_VALUE);
    }
    const Cylinder cylinder(*quad, base, narrowing, height, length,
                            slices < MAX_DIVISIONS ? slices : MAX_DIVISIONS, stacks);
    switch (quad->draw_style) {
    case GLU_FILL:
        return cylinder.fill();
    case GLU_POINT:
        return cylinder.points();
    case GLU_LINE:
        cylinder.inner_circles();
        return cylinder.silhouette();
    default:
        return cylinder.silhouette();
    }
}
