#include "platform/input/input.h"

#include "app/commands/commands.h"
#include "app/simulation/simulation.h"
#include "app/view/camera_view.h"
#include "platform/files/asset_files.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace {

constexpr platform::WindowSize WINDOW{800, 600};

const assets::Assets& own_assets()
{
    static const assets::Assets ASSETS_READ = [] {
        assets::Assets assets;
        EXPECT_EQ(platform::read_asset_folder(ASSETS, assets), "");
        return assets;
    }();
    return ASSETS_READ;
}

class Input : public ::testing::Test
{
protected:
    void key(Uint32 type, SDL_Scancode scancode, Uint16 modifiers = KMOD_NONE, Uint8 repeat = 0)
    {
        SDL_Event event{};
        event.type = type;
        event.key.keysym.scancode = scancode;
        event.key.keysym.mod = modifiers;
        event.key.repeat = repeat;
        input.handle(event, WINDOW, simulation);
    }

    void button(Uint32 type, Uint8 which)
    {
        SDL_Event event{};
        event.type = type;
        event.button.button = which;
        event.button.x = pointer_x;
        event.button.y = pointer_y;
        input.handle(event, WINDOW, simulation);
    }

    void move(int x, int y)
    {
        SDL_Event event{};
        event.type = SDL_MOUSEMOTION;
        pointer_x += x;
        pointer_y += y;
        event.motion.x = pointer_x;
        event.motion.y = pointer_y;
        event.motion.xrel = x;
        event.motion.yrel = y;
        input.handle(event, WINDOW, simulation);
    }

    void finger(Uint32 type, SDL_FingerID id, float x, float y)
    {
        SDL_Event event{};
        event.type = type;
        event.tfinger.fingerId = id;
        event.tfinger.x = x;
        event.tfinger.y = y;
        input.handle(event, WINDOW, simulation);
    }

    bool is_held(std::string_view command) const
    {
        return state.held[static_cast<std::size_t>(app::find_command(command) - app::commands().data())];
    }

    app::Simulation simulation{own_assets()};
    const app::State& state = simulation.state();
    int pointer_x = 400;
    int pointer_y = 300;
    platform::Input input;
};

TEST_F(Input, HoldsACommandAsLongAsItsKeyIsDown)
{
    key(SDL_KEYDOWN, SDL_SCANCODE_Q);
    EXPECT_TRUE(is_held("turret_left"));
    key(SDL_KEYDOWN, SDL_SCANCODE_Q, KMOD_NONE, 1);
    EXPECT_TRUE(is_held("turret_left"));
    key(SDL_KEYUP, SDL_SCANCODE_Q);
    EXPECT_TRUE(state.held.none());
}

TEST_F(Input, FollowsEveryKeyOfTheTable)
{
    for (const app::Command& command : app::commands()) {
        for (app::Key own : command.keys) {
            if (own == app::Key::none || command.kind != app::CommandKind::hold) {
                continue;
            }
            SCOPED_TRACE(command.name);
            key(SDL_KEYDOWN, static_cast<SDL_Scancode>(own));
            EXPECT_TRUE(is_held(command.name));
            key(SDL_KEYUP, static_cast<SDL_Scancode>(own));
            EXPECT_TRUE(state.held.none());
        }
    }
}

TEST_F(Input, EndsACommandOfTwoKeysWithTheLastOfThem)
{
    key(SDL_KEYDOWN, SDL_SCANCODE_PAGEUP);
    key(SDL_KEYDOWN, SDL_SCANCODE_EQUALS);
    key(SDL_KEYUP, SDL_SCANCODE_PAGEUP);
    EXPECT_TRUE(is_held("zoom_in"));
    key(SDL_KEYUP, SDL_SCANCODE_EQUALS);
    EXPECT_TRUE(state.held.none());
}

TEST_F(Input, PressesOnceHoweverLongAKeyIsDown)
{
    const bool before = state.show.ground;
    key(SDL_KEYDOWN, SDL_SCANCODE_B);
    key(SDL_KEYDOWN, SDL_SCANCODE_B, KMOD_NONE, 1);
    key(SDL_KEYDOWN, SDL_SCANCODE_B, KMOD_NONE, 1);
    key(SDL_KEYUP, SDL_SCANCODE_B);
    EXPECT_NE(state.show.ground, before);
}

TEST_F(Input, LeavesShortcutsToTheWindowSystem)
{
    const app::State before = state;
    for (Uint16 modifier : {KMOD_LCTRL, KMOD_RCTRL, KMOD_LALT, KMOD_LGUI}) {
        key(SDL_KEYDOWN, SDL_SCANCODE_R, modifier);
        key(SDL_KEYUP, SDL_SCANCODE_R);
    }
    EXPECT_EQ(state, before);
}

TEST_F(Input, TakesKeysWithShift)
{
    key(SDL_KEYDOWN, SDL_SCANCODE_Q, KMOD_LSHIFT);
    EXPECT_TRUE(is_held("turret_left"));
}

TEST_F(Input, LetsGoOfAKeyWhoseModifierCameLater)
{
    key(SDL_KEYDOWN, SDL_SCANCODE_Q);
    key(SDL_KEYUP, SDL_SCANCODE_Q, KMOD_LCTRL);
    EXPECT_TRUE(state.held.none());
}

TEST_F(Input, IgnoresKeysThatDoNothing)
{
    const app::State before = state;
    for (int scancode : {int(SDL_SCANCODE_UNKNOWN), int(SDL_SCANCODE_F5), int(SDL_SCANCODE_LSHIFT),
                         SDL_NUM_SCANCODES - 1, int(SDL_NUM_SCANCODES)}) {
        key(SDL_KEYDOWN, static_cast<SDL_Scancode>(scancode));
        key(SDL_KEYUP, static_cast<SDL_Scancode>(scancode));
    }
    EXPECT_EQ(state, before);
}

TEST_F(Input, LetsGoOfEverythingWhenTheFocusIsLost)
{
    key(SDL_KEYDOWN, SDL_SCANCODE_Q);
    key(SDL_KEYDOWN, SDL_SCANCODE_LEFT);
    button(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT);
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
    input.handle(event, WINDOW, simulation);
    EXPECT_TRUE(state.held.none());
    const app::State before = state;
    move(30, 30);
    EXPECT_EQ(state, before);
    key(SDL_KEYDOWN, SDL_SCANCODE_Q);
    EXPECT_TRUE(is_held("turret_left"));
}

TEST_F(Input, OrbitsAndTiltsByDraggingWithTheLeftButtonOnly)
{
    const app::State before = state;
    move(50, 20);
    button(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_RIGHT);
    move(50, 20);
    EXPECT_EQ(state, before);

    button(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT);
    move(10, 20);
    constexpr double PER_POINT = app::DRAG_DEGREES_PER_POINT * 3.14159265358979 / 180.0;
    EXPECT_NEAR(state.camera.orbit, before.camera.orbit - 10 * PER_POINT, 1e-9);
    EXPECT_NEAR(state.camera.tilt, before.camera.tilt + 20 * PER_POINT, 1e-9);
    button(SDL_MOUSEBUTTONUP, SDL_BUTTON_LEFT);
    const app::State after = state;
    move(10, 20);
    EXPECT_EQ(state, after);
}

TEST_F(Input, FiresThroughThePointerByAClickEvenOfATremblingHand)
{
    pointer_x = 500;
    pointer_y = 250;
    button(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT);
    move(2, -1);
    EXPECT_FALSE(state.shot.flies);
    button(SDL_MOUSEBUTTONUP, SDL_BUTTON_LEFT);
    ASSERT_TRUE(state.shot.flies);

    // The way of the shot, seen from the eye, goes through the pixel under the pointer.
    const app::CameraView camera = app::camera_view(state, simulation.assets());
    const app::ViewAxes axes = app::view_axes(camera);
    const glm::dvec3 far = state.shot.origin + state.shot.velocity - camera.eye;
    const double depth = glm::dot(far, axes.forward) * axes.heights_per_depth;
    EXPECT_NEAR(glm::dot(far, axes.right) / depth, (502.5 - 400.0) / 600.0, 2e-3);
    EXPECT_NEAR(glm::dot(far, axes.up) / depth, (300.0 - 249.5) / 600.0, 2e-3);
}

TEST_F(Input, FiresNothingByADrag)
{
    button(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT);
    move(10, 0);
    move(-10, 0);
    button(SDL_MOUSEBUTTONUP, SDL_BUTTON_LEFT);
    EXPECT_FALSE(state.shot.flies);
}

TEST_F(Input, DragsTheProjectileWhereADragBeginsOnIt)
{
    simulation.open_link(
        "probe=point&point_x=0&point_y=2&point_z=0&orbit=0&tilt=0&look_x=0&look_y=2&look_z=0");
    const app::State before = state;
    button(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT);
    move(60, -30);
    button(SDL_MOUSEBUTTONUP, SDL_BUTTON_LEFT);
    EXPECT_GT(state.projectile.point.x, 0.2);
    EXPECT_GT(state.projectile.point.y, 2.1);
    EXPECT_NEAR(state.projectile.point.z, 0.0, 1e-6); // as deep in the picture as it was
    EXPECT_EQ(state.camera, before.camera);
    EXPECT_FALSE(state.shot.flies);
}

TEST_F(Input, ZoomsByTheWheel)
{
    const double before = state.camera.distance;
    SDL_Event event{};
    event.type = SDL_MOUSEWHEEL;
    event.wheel.preciseY = 1.0f;
    input.handle(event, WINDOW, simulation);
    EXPECT_LT(state.camera.distance, before);
    event.wheel.preciseY = -1.0f;
    input.handle(event, WINDOW, simulation);
    EXPECT_NEAR(state.camera.distance, before, 1e-9);
}

TEST_F(Input, ZoomsByTwoFingersAndDoesNotOrbitMeanwhile)
{
    const app::Camera before = state.camera;
    finger(SDL_FINGERDOWN, 11, 0.4f, 0.5f);
    button(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT); // as SDL makes it of the first finger
    finger(SDL_FINGERDOWN, 22, 0.6f, 0.5f);
    finger(SDL_FINGERMOTION, 11, 0.3f, 0.5f);
    move(-60, 0);
    EXPECT_LT(state.camera.distance, before.distance);
    EXPECT_EQ(state.camera.orbit, before.orbit);
    finger(SDL_FINGERMOTION, 11, 0.4f, 0.5f);
    EXPECT_NEAR(state.camera.distance, before.distance, 1e-6);
    finger(SDL_FINGERUP, 22, 0.6f, 0.5f);
    const app::State after = state;
    finger(SDL_FINGERMOTION, 11, 0.1f, 0.5f);
    EXPECT_EQ(state, after);
}

TEST_F(Input, DoesNotZoomByOneOrThreeFingers)
{
    const app::State before = state;
    finger(SDL_FINGERDOWN, 1, 0.1f, 0.1f);
    finger(SDL_FINGERMOTION, 1, 0.2f, 0.9f);
    finger(SDL_FINGERDOWN, 2, 0.6f, 0.5f);
    finger(SDL_FINGERDOWN, 3, 0.9f, 0.5f);
    finger(SDL_FINGERMOTION, 2, 0.1f, 0.5f);
    finger(SDL_FINGERMOTION, 3, 0.2f, 0.5f);
    EXPECT_EQ(state, before);
}

} // namespace
