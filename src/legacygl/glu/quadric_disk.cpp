// gluDisk and gluPartialDisk (GLU 1.3, 6.4), their vertices in libGLU's order.

#include "legacygl/glu/quadric.h"

using namespace legacygl::glu;

namespace {

/// A ring, or a part of one, in the plane z = 0, cut into loops from the outer radius inwards.
class Disk
{
public:
    /// start and sweep in degrees, clockwise from +y; 0 <= sweep <= 360.
    Disk(const GLUquadric& quadric, double inner, double outer, int slices, int loops, double start,
         double sweep)
        : quadric_(quadric), inner_(inner), outer_(outer), width_(static_cast<float>(outer - inner)),
          slices_(slices), loops_(loops), whole_(sweep == 360),
          around_(slices, PI * sweep / 180, 1, 0, static_cast<float>(start / 180 * PI))
    {
        if (whole_) {
            around_.close(slices);
        }
    }

    void fill() const
    {
        const bool has_hole = inner_ != 0;
        if (!has_hole) {
            innermost();
        }
        for (int loop = 0; loop < (has_hole ? loops_ : loops_ - 1); ++loop) {
            const Circle outside = circle(loop), inside = circle(loop + 1);
            glBegin(GL_QUAD_STRIP);
            for (int slice = 0; slice <= slices_; ++slice) {
                vertex(slice, quadric_.outside() ? outside : inside);
                vertex(slice, quadric_.outside() ? inside : outside);
            }
            glEnd();
        }
    }

    void points() const
    {
        glBegin(GL_POINTS);
        for (int slice = 0; slice < slices_ + (whole_ ? 0 : 1); ++slice) {
            for (int loop = 0; loop <= loops_; ++loop) {
                vertex(slice, circle(loop));
            }
        }
        glEnd();
    }

    void lines() const
    {
        if (inner_ == outer_) {
            return draw_circle({static_cast<float>(inner_), 0.5f});
        }
        for (int loop = 0; loop <= loops_; ++loop) {
            draw_circle(circle(loop));
        }
        for (int slice = 0; slice < slices_ + (whole_ ? 0 : 1); ++slice) {
            draw_spoke(slice);
        }
    }

    void silhouette() const
    {
        if (!whole_) {
            draw_spoke(0);
            draw_spoke(slices_);
        }
        draw_circle(circle(0));
        if (inner_ != outer_) {
            draw_circle(circle(loops_));
        }
    }

private:
    struct Circle
    {
        float radius, texture_radius;
    };

    Circle circle(int loop) const
    {
        const float fraction = static_cast<float>(loop) / static_cast<float>(loops_);
        const auto radius = static_cast<float>(outer_ - static_cast<double>(width_ * fraction));
        return {radius, static_cast<float>(static_cast<double>(radius) / outer_ / 2)};
    }

    void vertex(int slice, const Circle& at) const
    {
        const float sine = around_.sine[slice], cosine = around_.cosine[slice];
        if (quadric_.textured) {
            glTexCoord2f(at.texture_radius * sine + 0.5f, at.texture_radius * cosine + 0.5f);
        }
        glVertex3f(at.radius * sine, at.radius * cosine, 0);
    }

    void innermost() const
    {
        glBegin(GL_TRIANGLE_FAN);
        if (quadric_.textured) {
            glTexCoord2f(0.5f, 0.5f);
        }
        glVertex3f(0, 0, 0);
        const Circle at = circle(loops_ - 1);
        for (int i = 0; i <= slices_; ++i) {
            vertex(quadric_.outside() ? slices_ - i : i, at);
        }
        glEnd();
    }

    void draw_circle(const Circle& at) const
    {
        glBegin(GL_LINE_STRIP);
        for (int slice = 0; slice <= slices_; ++slice) {
            vertex(slice, at);
        }
        glEnd();
    }

    void draw_spoke(int slice) const
    {
        glBegin(GL_LINE_STRIP);
        for (int loop = 0; loop <= loops_; ++loop) {
            vertex(slice, circle(loop));
        }
        glEnd();
    }

    const GLUquadric& quadric_;
    double inner_, outer_;
    float width_;
    int slices_, loops_;
    bool whole_;
    AngleTable around_;
};

} // namespace

void gluDisk(GLUquadric* quad, GLdouble inner, GLdouble outer, GLint slices, GLint loops)
{
    gluPartialDisk(quad, inner, outer, slices, loops, 0, 360);
}

void gluPartialDisk(GLUquadric* quad, GLdouble inner, GLdouble outer, GLint slices, GLint loops,
                    GLdouble start, GLdouble sweep)
{
    if (slices < 2 || loops < 1 || outer <= 0 || inner < 0 || inner > outer) {
        return quad->error(GLU_INVALID_VALUE);
    }
    if (sweep < -360 || sweep > 360) {
        sweep = 360;
    }
    if (sweep < 0) {
        start += sweep;
        sweep = -sweep;
    }
    if (quad->normals != GLU_NONE) {
        glNormal3f(0, 0, quad->outside() ? 1.0f : -1.0f);
    }
    const Disk disk(*quad, inner, outer, slices < MAX_DIVISIONS ? slices : MAX_DIVISIONS, loops, start,
                    sweep);
    switch (quad->draw_style) {
    case GLU_FILL:
        return disk.fill();
    case GLU_POINT:
        return disk.points();
    case GLU_LINE:
        return disk.lines();
    default:
        return disk.silhouette();
    }
}
