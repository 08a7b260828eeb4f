// tanklab where no window can be opened; what it does in one is seen by its input and program tests.
#include "process.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

namespace {

using platform_test::Finished;
using platform_test::run;

void expect_refused(const Finished& finished, const std::string& words)
{
    EXPECT_EQ(finished.status, 2) << finished.err;
    EXPECT_NE(finished.err.find("tanklab: "), std::string::npos) << finished.err;
    EXPECT_NE(finished.err.find(words), std::string::npos) << finished.err;
}

TEST(Window, NeedsADisplay)
{
    expect_refused(run({TANKLAB, "--assets", ASSETS}, {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}),
                   "display");
}

TEST(Window, RefusesArgumentsItDoesNotKnow)
{
    expect_refused(run({TANKLAB, "--frobnicate"}), "--frobnicate");
    expect_refused(run({TANKLAB, "--assets"}), "--assets needs a folder");
    expect_refused(run({TANKLAB, "--assets="}), "--assets needs a folder");
    expect_refused(run({TANKLAB, "--help=yes"}), "--help takes no value");
    expect_refused(run({TANKLAB, "turret=1", "gun=2"}), "two links");
}

TEST(Window, ReadsTheFilesBeforeItOpens)
{
    platform_test::TemporaryFolder folder;
    expect_refused(run({TANKLAB, "--assets", folder.path().string()}), "tankbody.obj");
    expect_refused(run({TANKLAB, "--assets=" + folder.path().string()}), "tankbody.obj");
}

TEST(Window, TellsItsUsage)
{
    const Finished finished = run({TANKLAB, "--help"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_NE(finished.out.find("Usage: tanklab"), std::string::npos);
}

} // namespace
