// gluSphere (GLU 1.3, 6.4). Its vertices come in libGLU's order, so that triangles, flat colours and line
// patterns agree.

#include "legacygl/glu/quadric.h"

using namespace legacygl::glu;

namespace {

/// A sphere around the origin, cut into slices around the z axis and stacks from +z to -z.
class Sphere
{
public:
    Sphere(const GLUquadric& quadric, double radius, int slices, int stacks)
        : quadric_(quadric), radius_(static_cast<float>(radius)), slices_(slices), stacks_(stacks),
          around_(full_turn(slices)), around_faces_(full_turn(slices, 1, 0.5)), along_(stacks, PI, radius),
          along_normals_(stacks, PI, quadric.outside() ? 1 : -1),
          along_faces_(stacks, PI, quadric.outside() ? 1 : -1, 0.5)
    {
        // The sine of a rounded pi is not 0: let it come to a point.
        along_.sine[0] = along_.sine[stacks] = 0;
    }

    void fill() const
    {
        if (quadric_.textured) {
            // A pole has a texture coordinate for each slice: strips, although half their triangles are
            // empty.
            bands(0, stacks_);
            return;
        }
        cap(radius_, 0, 1, 1, !quadric_.outside());
        cap(-radius_, stacks_, stacks_ - 1, stacks_, quadric_.outside());
        bands(1, stacks_ - 1);
    }

    void points() const
    {
        glBegin(GL_POINTS);
        for (int stack = 0; stack <= stacks_; ++stack) {
            for (int slice = 0; slice < slices_; ++slice) {
                // libGLU has no values for flat points; the smooth normals are what it must have meant.
                if (quadric_.normals != GLU_NONE) {
                    normal(around_, slice, along_normals_, stack);
                }
                vertex(slice, stack);
            }
        }
        glEnd();
    }

    void lines() const
    {
        for (int stack = 1; stack < stacks_; ++stack) {
            glBegin(GL_LINE_STRIP);
            for (int slice = 0; slice <= slices_; ++slice) {
                if (quadric_.normals != GLU_NONE) {
                    normal(flat() ? around_faces_ : around_, slice, along_normals_, stack);
                }
                vertex(slice, stack);
            }
            glEnd();
        }
        for (int slice = 0; slice < slices_; ++slice) {
            glBegin(GL_LINE_STRIP);
            for (int stack = 0; stack <= stacks_; ++stack) {
                if (quadric_.normals != GLU_NONE) {
                    normal(around_, slice, flat() ? along_faces_ : along_normals_, stack);
                }
                vertex(slice, stack);
            }
            glEnd();
        }
    }

private:
    bool flat() const { return quadric_.normals == GLU_FLAT; }
    bool smooth() const { return quadric_.normals == GLU_SMOOTH; }

    static void normal(const AngleTable& around, int slice, const AngleTable& along, int stack)
    {
        glNormal3f(around.sine[slice] * along.sine[stack], around.cosine[slice] * along.sine[stack],
                   along.cosine[stack]);
    }

    void vertex(int slice, int stack) const
    {
        if (quadric_.textured) {
            glTexCoord2f(1 - static_cast<float>(slice) / static_cast<float>(slices_),
                         1 - static_cast<float>(stack) / static_cast<float>(stacks_));
        }
        glVertex3f(along_.sine[stack] * around_.sine[slice], along_.sine[stack] * around_.cosine[slice],
                   along_.cosine[stack]);
    }

    /// Draws the fan between a pole and the circle next to it. face is the stack of the flat normals.
    void cap(float z, int pole, int circle, int face, bool ascending) const
    {
        if (smooth()) {
            // libGLU takes the slice with the number of the stack, which it may not have; next to no matter
            // which, as the sine there is 0 but for rounding.
            normal(around_, pole <= slices_ ? pole : 0, along_normals_, pole);
        }
        glBegin(GL_TRIANGLE_FAN);
        glVertex3f(0, 0, z);
        for (int i = 0; i <= slices_; ++i) {
            const int slice = ascending ? i : slices_ - i;
            if (smooth()) {
                normal(around_, slice, along_normals_, circle);
            } else if (flat() && (ascending || i > 0)) {
                normal(around_faces_, ascending ? slice : slice + 1, along_faces_, face);
            }
            vertex(slice, circle);
        }
        glEnd();
    }

    void bands(int first, int end) const
    {
        for (int stack = first; stack < end; ++stack) {
            const int leading = quadric_.outside() ? stack + 1 : stack;
            const int trailing = quadric_.outside() ? stack : stack + 1;
            glBegin(GL_QUAD_STRIP);
            for (int slice = 0; slice <= slices_; ++slice) {
                if (smooth()) {
                    normal(around_, slice, along_normals_, leading);
                }
                vertex(slice, leading);
                if (smooth()) {
                    normal(around_, slice, along_normals_, trailing);
                } else if (flat()) {
                    normal(around_faces_, slice, along_faces_, stack + 1);
                }
                vertex(slice, trailing);
            }
            glEnd();
        }
    }

    const GLUquadric& quadric_;
    float radius_;
    int slices_, stacks_;
    AngleTable around_, around_faces_; ///< Faces' angles lie half a division before the vertices'.
    AngleTable along_, along_normals_, along_faces_;
};

} // namespace

void gluSphere(GLUquadric* quad, GLdouble radius, GLint slices, GLint stacks)
{
    if (slices < 2 || stacks < 1 || radius < 0) {
        return quad->error(GLU_INVALID_VALUE);
    }
    const Sphere sphere(*quad, radius, slices < MAX_DIVISIONS ? slices : MAX_DIVISIONS,
                        stacks < MAX_DIVISIONS ? stacks : MAX_DIVISIONS);
    switch (quad->draw_style) {
    case GLU_FILL:
        return sphere.fill();
    case GLU_POINT:
        return sphere.points();
    default:
        return sphere.lines();
    }
}
