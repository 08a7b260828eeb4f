#include "allocation_count/allocation_count.h"
#include "recorded_gl.h"

namespace {

using Counters = RecordedGl;

/// A backend that only counts, so that what allocates is legacygl itself.
class CountingBackend final : public legacygl::Backend
{
public:
    legacygl::ProgramId create_program(const legacygl::ProgramText&) override { return ++programs; }
    legacygl::GeometryId create_geometry(const legacygl::VertexFormat&, std::span<const float>,
                                         std::span<const std::uint32_t>) override
    {
        return ++geometries;
    }
    void destroy_geometry(legacygl::GeometryId) override {}
    legacygl::TextureId create_texture() override { return 1; }
    void destroy_texture(legacygl::TextureId) override {}
    void texture_image(legacygl::TextureId, int, int, int, std::span<const std::uint8_t>) override {}
    void generate_mipmap(legacygl::TextureId) override {}
    void sampling(legacygl::TextureId, const legacygl::Sampling&) override {}
    bool draw(const legacygl::DrawState&, legacygl::GeometryId, std::span<const legacygl::DrawRun>) override
    {
        ++draws;
        return true;
    }
    void draw_stream(const legacygl::DrawState&, const legacygl::VertexFormat&, std::span<const float>,
                     std::span<const std::uint32_t>, std::span<const legacygl::DrawRun>) override
    {
        ++draws;
    }
    void clear(const legacygl::Pipeline&, const legacygl::Clear&) override {}
    void read_pixels(bool, int, int, int, int, std::span<std::uint8_t>) override {}
    bool read_depths(int, int, int, int, std::span<std::uint32_t>) override { return true; }
    bool read_stencils(int, int, int, int, std::span<std::uint8_t>) override { return true; }
    bool clips_lines() override { return true; }
    void flush(bool) override {}
    void resize(int, int) override {}
    void present() override {}
    void show_front() override {}
    void context_lost() override {}
    void context_restored() override {}

    std::uint32_t programs = 0, geometries = 0;
    int draws = 0;
};

void frame(GLuint list)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    for (int i = 0; i < 20; ++i) {
        glPushMatrix();
        glTranslatef(static_cast<float>(i), 0, 0);
        glRotatef(10, 0, 1, 0);
        glCallList(list);
        glPopMatrix();
    }
    glDisable(GL_LIGHTING);
    for (int i = 0; i < 50; ++i) {
        glColor3ub(static_cast<GLubyte>(i), 0, 0);
        triangle(static_cast<float>(i));
    }
    glFlush();
}

TEST(SteadyFrame, AllocatesNothingAndCompilesNoShader)
{
    auto made = std::make_unique<CountingBackend>();
    CountingBackend* backend = made.get();
    legacygl::Context context(std::move(made), 64, 48);
    legacygl::current_context = &context;
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    triangle();
    glEndList();
    frame(list);
    frame(list);
    const std::size_t before = allocation_count();
    const std::uint32_t programs = backend->programs, geometries = backend->geometries;
    backend->draws = 0;
    frame(list);
    EXPECT_EQ(allocation_count(), before);
    EXPECT_EQ(backend->programs, programs);
    EXPECT_EQ(backend->geometries, geometries);
    EXPECT_EQ(backend->draws, 22) << "One a list call; of the triangles of the same state one for the first, "
                                     "which has a colour alone, and one for all others.";
    legacygl::current_context = nullptr;
}

TEST_F(Counters, AdjacentPrimitivesOfOneStateShareADraw)
{
    for (int i = 0; i < 10; ++i) {
        triangle(static_cast<float>(i));
    }
    glFlush();
    EXPECT_EQ(backend->counters.draw_calls, 1u);
    EXPECT_EQ(backend->counters.vertices, 30u);
}

TEST_F(Counters, AListIsUploadedOnceAndDrawnInOneCall)
{
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    for (int i = 0; i < 10; ++i) {
        triangle(static_cast<float>(i));
    }
    glEndList();
    glCallList(list);
    glCallList(list);
    EXPECT_EQ(backend->counters.draw_calls, 2u);
    EXPECT_EQ(backend->counters.uploads, 1u);
}

} // namespace
