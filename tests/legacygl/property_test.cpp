// Random command streams: what a list replays is what the same calls draw at once.

#define GL_GLEXT_PROTOTYPES
#include "recorded_gl.h"

#include <algorithm>
#include <random>

namespace {

/// Whether a seed's stream has separate quads. Where the last vertex provokes, a list cuts them along another
/// diagonal, as Mesa's does: with quads the first one provokes.
bool has_quads(unsigned seed)
{
    return seed % 2 == 0;
}

/// Returns a mode for glBegin that a seed's stream may have.
GLenum some_mode(unsigned seed, unsigned random)
{
    const GLenum mode = random % 10;
    return mode == GL_QUADS && !has_quads(seed) ? GL_TRIANGLES : mode;
}

/// Calls GL at random, but the same for the same seed. May leave a primitive open; see close().
class RandomCalls
{
public:
    explicit RandomCalls(unsigned seed) : seed_(seed), random_(seed) {}

    void make(int count)
    {
        for (int i = 0; i < count; ++i) {
            one();
        }
    }
    bool inside() const { return inside_; }

private:
    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    float number() { return static_cast<float>(pick(9)) * 0.5f - 2; }

    void one()
    {
        switch (pick(inside_ ? 12 : 16)) {
        case 0:
        case 1:
        case 2:
        case 3:
            return vertex();
        case 4:
        case 5: {
            const float r = number(), g = number(), b = number();
            return pick(2) ? glColor3f(r, g, b) : glColor4f(r, g, b, 0.5f);
        }
        case 6: {
            const float x = number(), y = number();
            return glNormal3f(x, y, 1);
        }
        case 7: {
            const float s = number(), t = number();
            return pick(2) ? glTexCoord2f(s, t) : glTexCoord4f(s, t, 1, 2);
        }
        case 8:
        case 9:
        case 10:
            return begin_or_end();
        case 11:
            return glEnable(GL_LIGHTING); // An error inside Begin/End.
        case 12: {
            const float x = number(), y = number();
            return glTranslatef(x, y, 0);
        }
        case 13:
            return pick(2) ? glEnable(GL_LIGHTING) : glDisable(GL_LIGHTING);
        case 14:
            return glShadeModel(pick(2) ? GL_FLAT : GL_SMOOTH);
        default:
            return pick(2) ? glPushMatrix() : glPopMatrix();
        }
    }

    void vertex()
    {
        const float x = number(), y = number(), z = number();
        switch (pick(3)) {
        case 0:
            return glVertex2f(x, y);
        case 1:
            return glVertex3f(x, y, z);
        default:
            return glVertex4f(x, y, z, 2);
        }
    }

    void begin_or_end()
    {
        if (inside_) {
            glEnd();
        } else {
            glBegin(some_mode(seed_, static_cast<unsigned>(random_())));
        }
        inside_ = !inside_;
    }

    unsigned seed_;
    std::mt19937 random_;
    bool inside_ = false;
};

/// What a stream of calls amounts to.
struct Outcome
{
    std::vector<Corner> corners;
    legacygl::CurrentAttributes current;
    GLenum error;
    bool inside;
};

/// Returns the first corner at which two outcomes differ in what `of` tells, or their size.
template <class Of> std::size_t first_difference(const Outcome& a, const Outcome& b, Of of)
{
    const auto same = [&](const Corner& one, const Corner& other) { return of(one) == of(other); };
    return static_cast<std::size_t>(
        std::mismatch(a.corners.begin(), a.corners.end(), b.corners.begin(), same).first - a.corners.begin());
}

class RandomStreams : public RecordedGl
{
protected:
    /// Starts from an OpenGL as new, with a view that holds all of a stream: what it cuts off decides in
    /// which order the triangles of a strip's quads come, and a list cannot know.
    void renew(unsigned seed)
    {
        auto made = std::make_unique<legacygl::RecordingBackend>();
        backend = made.get();
        context = std::make_unique<legacygl::Context>(std::move(made), 64, 48);
        legacygl::current_context = context.get();
        glMatrixMode(GL_PROJECTION);
        glScalef(0.001f, 0.001f, 0.001f);
        glMatrixMode(GL_MODELVIEW);
        glProvokingVertex(has_quads(seed) ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
        glColor4f(0.5f, 0.25f, 1, 0.75f);
        glTexCoord3f(3, 4, 5);
    }
    Outcome outcome()
    {
        const bool inside = context->immediate.inside();
        if (inside) {
            glEnd();
        }
        Outcome out{corners(), context->state.current, context->error, inside};
        return out;
    }
};

TEST_F(RandomStreams, ReplayedFromListsAreAsDrawnAtOnce)
{
    for (unsigned seed = 0; seed < 20000; ++seed) {
        const int length = 1 + static_cast<int>(seed % 60);
        renew(seed);
        RandomCalls(seed).make(length);
        const Outcome direct = outcome();

        // The same stream cut into two lists at a place that may lie inside a primitive.
        renew(seed);
        RandomCalls calls(seed);
        const int first = length / 3;
        glNewList(1, GL_COMPILE);
        calls.make(first);
        glEndList();
        glNewList(2, GL_COMPILE);
        calls.make(length - first);
        glEndList();
        glCallList(1);
        glCallList(2);
        const Outcome replayed = outcome();

        ASSERT_EQ(direct.corners.size(), replayed.corners.size()) << "seed " << seed;
        ASSERT_EQ(first_difference(direct, replayed, [](const Corner& c) { return c.position; }),
                  direct.corners.size())
            << "seed " << seed;
        for (int a = 1; a < legacygl::ATTRIBUTE_COUNT; ++a) {
            ASSERT_EQ(direct.current[a], replayed.current[a]) << "seed " << seed << " attribute " << a;
        }
        ASSERT_EQ(direct.error, replayed.error) << "seed " << seed;
        ASSERT_EQ(direct.inside, replayed.inside) << "seed " << seed;
    }
}

TEST_F(RandomStreams, ReplayedFromListsHaveTheSameColours)
{
    // Unlit, so that the colour is sent for every corner on both sides.
    for (unsigned seed = 0; seed < 5000; ++seed) {
        const auto stream = [seed] {
            std::mt19937 random(seed);
            for (int primitive = 0; primitive < 4; ++primitive) {
                if (random() % 2) {
                    glColor3f(static_cast<float>(random() % 4), 0, 1);
                }
                glBegin(some_mode(seed, static_cast<unsigned>(random())));
                for (unsigned i = random() % 9; i > 0; --i) {
                    if (random() % 3 == 0) {
                        glColor4f(0, static_cast<float>(random() % 4), 0, 0.25f);
                    }
                    glVertex2f(static_cast<float>(i), static_cast<float>(random() % 5));
                }
                glEnd();
            }
        };
        renew(seed);
        stream();
        const Outcome direct = outcome();
        renew(seed);
        glNewList(1, GL_COMPILE);
        stream();
        glEndList();
        glCallList(1);
        const Outcome replayed = outcome();
        ASSERT_EQ(direct.corners.size(), replayed.corners.size()) << "seed " << seed;
        ASSERT_EQ(first_difference(direct, replayed, [](const Corner& c) { return c.color; }),
                  direct.corners.size())
            << "seed " << seed;
    }
}

} // namespace
