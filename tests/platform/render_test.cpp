// tanklab-render as people use it: as a process, by its arguments, exit status, words and files.
#include "process.h"
#include "temporary_folder.h"

#include "image/image.h"
#include "original_set.h"

#include <cstdint>
#include <filesystem>

#include <gtest/gtest.h>

namespace {

using platform_test::Finished;
using platform_test::read_file;
using platform_test::write_file;

namespace fs = std::filesystem;

class Render : public ::testing::Test
{
protected:
    Finished render(std::vector<std::string> arguments, const std::vector<std::string>& environment = {})
    {
        arguments.insert(arguments.begin(), RENDER);
        return platform_test::run(arguments, environment);
    }

    /// Draws with the tank's own files into picture().
    Finished draw(const std::string& link, const std::string& size = "64x48",
                  std::vector<std::string> more = {})
    {
        std::vector<std::string> arguments = {link, "--size", size, "--out", picture(), "--assets", ASSETS};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return render(arguments);
    }

    std::string picture() const { return folder.file("picture.png"); }

    /// Copies the tank's own files, to be spoilt.
    fs::path own_assets()
    {
        const fs::path copy = folder.path() / "assets";
        fs::copy(ASSETS, copy, fs::copy_options::recursive);
        return copy;
    }

    Finished draw_assets(const fs::path& assets)
    {
        return render({"", "--size", "64x48", "--out", picture(), "--assets", assets.string()});
    }

    /// Writes a set like the lab's into a folder in `name` and returns the outermost one.
    std::string made_set(const std::string& name, const assets::OriginalSetOptions& options)
    {
        const assets::Files files = assets::original_set(options);
        for (const assets::AssetFile& file : files.views()) {
            const fs::path path = folder.path() / name / file.name;
            fs::create_directories(path.parent_path());
            write_file(path, {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
        }
        return (folder.path() / *fs::path(name).begin()).string();
    }

    /// Expects exit status 2, one sentence that contains `words`, and no picture.
    void expect_refused(const Finished& finished, const std::string& words)
    {
        EXPECT_EQ(finished.status, 2) << finished.err;
        EXPECT_NE(finished.err.find(words), std::string::npos) << finished.err;
        EXPECT_EQ(finished.err.find("tanklab-render: "), 0u) << finished.err;
        EXPECT_EQ(finished.out, "");
        EXPECT_FALSE(fs::exists(picture()));
    }

    platform_test::TemporaryFolder folder;
};

TEST_F(Render, DrawsAPictureOfTheSizeAskedFor)
{
    for (const char* renderer : {"emulated", "reference"}) {
        const Finished finished = draw("turret=30", "37x21", {"--renderer", renderer});
        ASSERT_EQ(finished.status, 0) << finished.err;
        EXPECT_EQ(finished.err, "");
        const std::string png = read_file(picture());
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(png.data());
        const auto image = image::read_image("picture.png", {bytes, png.size()});
        ASSERT_TRUE(image);
        EXPECT_EQ(image.value().width, 37);
        EXPECT_EQ(image.value().height, 21);
    }
}

TEST_F(Render, DrawsALinkTwiceToTheSameBytes)
{
    const char* link =
        "#turret=35&gun=7&secondary_gun=-20&wheels=15&heading=12.5&orbit=70&tilt=9&distance=10";
    for (const char* renderer : {"emulated", "reference"}) {
        const Finished first = draw(link, "200x120", {"--renderer", renderer, "--state"});
        ASSERT_EQ(first.status, 0) << first.err;
        const std::string first_bytes = read_file(picture());
        const Finished second = draw(link, "200x120", {"--renderer", renderer, "--state"});
        ASSERT_EQ(second.status, 0) << second.err;
        EXPECT_FALSE(first_bytes.empty());
        EXPECT_EQ(first_bytes, read_file(picture()));
        EXPECT_EQ(first.out, second.out);
    }
}

TEST_F(Render, DrawsAnotherPictureForAnotherLink)
{
    ASSERT_EQ(draw("turret=10").status, 0);
    const std::string first = read_file(picture());
    ASSERT_EQ(draw("turret=11").status, 0);
    EXPECT_NE(first, read_file(picture()));
}

TEST_F(Render, MovesTheLinksOfATrackAsItsWheelsTurn)
{
    // Only the body is drawn, from the left: the left wheels' angle shows in its track alone. A link's pitch
    // is an eleventh of a turn; after it, the next link is where the one before was.
    const std::string link = "#parts=body&detail=high&orbit=90&tilt=5&look_y=0.6&distance=6&wheels_left=";
    std::vector<std::string> pictures;
    for (const char* const angle : {"0", "16.36", "32.73"}) {
        ASSERT_EQ(draw(link + angle, "256x160").status, 0);
        pictures.push_back(read_file(picture()));
    }
    EXPECT_NE(pictures[0], pictures[1]);
    EXPECT_EQ(pictures[0], pictures[2]);
}

TEST_F(Render, TakesAWholeAddressAsALink)
{
    const Finished address =
        render({"https://example.org/tanklab/?a=b#turret=30", "--state", "--assets", ASSETS});
    const Finished fragment = render({"turret=30", "--state", "--assets", ASSETS});
    EXPECT_EQ(address.status, 0);
    EXPECT_EQ(address.out, fragment.out);
    EXPECT_NE(address.out.find("\"turret\":30,"), std::string::npos) << address.out;
    EXPECT_EQ(address.err, "");
}

TEST_F(Render, NamesWhatItCannotUseOfALinkAndDrawsTheRest)
{
    const Finished finished = draw("turret=30&gun=steep&nonsense=1", "64x48", {"--state"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_NE(finished.err.find("steep"), std::string::npos) << finished.err;
    EXPECT_NE(finished.err.find("nonsense"), std::string::npos) << finished.err;
    EXPECT_NE(finished.out.find("\"turret\":30,"), std::string::npos) << finished.out;
    EXPECT_TRUE(fs::exists(picture()));
}

TEST_F(Render, RefusesSizesThatAreNone)
{
    for (const char* size :
         {"0x0", "0x48", "64x0", "-64x48", "64x-48", "64", "64x", "x48", "x", "", "64x48x2", "64 x 48",
          "6.4x48", "1e2x48", "0x40x48", "99999999999x48", "8193x48", "64x8193"}) {
        SCOPED_TRACE(size);
        expect_refused(draw("", size), "--size " + std::string(size) + " ");
    }
}

TEST_F(Render, RefusesArgumentsItDoesNotKnow)
{
    expect_refused(draw("", "64x48", {"--renderer", "vulkan"}), "--renderer vulkan");
    expect_refused(draw("", "64x48", {"--frobnicate"}), "--frobnicate");
    expect_refused(draw("", "64x48", {"turret=3"}), "two links");
    expect_refused(draw("", "64x48", {"--renderer"}), "--renderer needs a value");
    expect_refused(render({"--out", picture()}), "There is no link");
    expect_refused(render({""}), "nothing to do");
    expect_refused(render({"", "--out", ""}), "--out needs a path");
    expect_refused(render({"", "--out"}), "--out needs a path");
    expect_refused(draw("", "64x48", {"--frobnicate=3"}), "The option --frobnicate=3 is unknown.");
    expect_refused(draw("", "64x48", {"-xy"}), "The option -x is unknown.");
    expect_refused(draw("", "64x48", {"--state=yes"}), "--state takes no value.");
    expect_refused(draw("", "64x48", {"--", "--state"}), "two links, '' and '--state'");
}

TEST_F(Render, TakesAValueBehindAnEqualsSignToo)
{
    const Finished finished = render({"--size=37x21", std::string("--assets=") + ASSETS, "--out=" + picture(),
                                      "--renderer=emulated", "--", "turret=30"});
    ASSERT_EQ(finished.status, 0) << finished.err;
    const std::string with_equals_signs = read_file(picture());
    ASSERT_EQ(draw("turret=30", "37x21").status, 0);
    EXPECT_EQ(with_equals_signs, read_file(picture()));
}

TEST_F(Render, MeasuresTheThresholdByBothRenderers)
{
    for (const char* renderer : {"emulated", "reference"}) {
        const Finished finished =
            render({"--measure-threshold", "--size", "160x100", "--assets", ASSETS, "--renderer", renderer});
        EXPECT_EQ(finished.status, 0) << finished.err;
        EXPECT_NE(finished.out.find("   400.0 m "), std::string::npos) << finished.out; // it begins far away
        EXPECT_NE(finished.out.find("\nd = "), std::string::npos) << finished.out;
        EXPECT_FALSE(fs::exists(picture()));
    }
}

TEST_F(Render, TellsItsUsage)
{
    const Finished finished = render({"--help"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_NE(finished.out.find("Usage: tanklab-render LINK"), std::string::npos);
}

TEST_F(Render, SaysThatAPathCannotBeWritten)
{
    const std::string missing = folder.file("no/such/folder/picture.png");
    for (const char* renderer : {"emulated", "reference"}) {
        expect_refused(
            render({"", "--size", "64x48", "--out", missing, "--assets", ASSETS, "--renderer", renderer}),
            missing);
    }
    expect_refused(render({"", "--size", "64x48", "--out", folder.path().string(), "--assets", ASSETS}),
                   folder.path().string());
}

TEST_F(Render, SaysThatADiskIsFullAndLeavesDevicesAlone)
{
    if (!fs::exists("/dev/full")) {
        GTEST_SKIP() << "no /dev/full here";
    }
    expect_refused(render({"", "--size", "64x48", "--out", "/dev/full", "--assets", ASSETS}), "/dev/full");
    EXPECT_TRUE(fs::exists("/dev/full"));
}

TEST_F(Render, SaysThatTheFolderOfFilesIsMissing)
{
    expect_refused(draw_assets(folder.path() / "nowhere"), "nowhere");
}

TEST_F(Render, NamesTheFilesThatAreMissing)
{
    const fs::path assets = own_assets();
    fs::remove(assets / "tankobjs/tankwheel.obj");
    expect_refused(draw_assets(assets), "tankwheel.obj");
    const fs::path nothing_of_use = folder.path() / "empty";
    fs::create_directory(nothing_of_use);
    expect_refused(draw_assets(nothing_of_use), "tankbody.obj");
}

TEST_F(Render, SaysWhereAFileIsWrong)
{
    const struct
    {
        const char* content;
        const char* words;
    } faults[] = {
        {"", "tankturret.obj"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "tankturret.obj:4:"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "tankturret.obj:4:"},
        {"v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "tankturret.obj:2:"},
        {"v 0 0 0\nv 1 0", "tankturret.obj:2:"},
        {"\x7f\x45\x4c\x46\x02\x01", "tankturret.obj"},
    };
    const fs::path assets = own_assets();
    for (const auto& fault : faults) {
        SCOPED_TRACE(fault.content);
        write_file(assets / "tankobjs/tankturret.obj", fault.content);
        expect_refused(draw_assets(assets), fault.words);
    }
}

TEST_F(Render, DrawsATankWithoutATextureInOneColourAndSaysSo)
{
    const fs::path assets = own_assets();
    ASSERT_EQ(draw_assets(assets).err, "");
    const std::string textured = read_file(picture());
    fs::remove(assets / "texture.jpg");
    const Finished finished = draw_assets(assets);
    EXPECT_EQ(finished.status, 0);
    EXPECT_NE(finished.err.find("no texture"), std::string::npos) << finished.err;
    EXPECT_NE(read_file(picture()), textured);
}

TEST_F(Render, AssemblesTheLabsOwnDataWhereverTheyLieInTheFolder)
{
    const Finished finished = render({"turret=20", "--state", "--assets", made_set("lab/Lab 3/tank", {})});
    EXPECT_EQ(finished.status, 0);
    EXPECT_NE(finished.err.find("the lab's own tank"), std::string::npos) << finished.err;
    EXPECT_NE(finished.err.find("scaled by 0.04369"), std::string::npos) << finished.err;
    EXPECT_NE(finished.out.find("\"link\":\"turret=20&tank=own\""), std::string::npos) << finished.out;
    EXPECT_NE(finished.out.find("\"has_own_tank\":true"), std::string::npos);
}

TEST_F(Render, LightsNormalsOfAnyLengthAndFacesThatWindAgainstThemAlike)
{
    const std::string plain = made_set("plain", {.varied_normals = false, .reversed_faces = false});
    const std::string quirky = made_set("quirky", {});
    for (const char* renderer : {"emulated", "reference"}) {
        std::vector<std::string> pictures;
        for (const std::string& set : {plain, quirky}) {
            ASSERT_EQ(render({"#orbit=30", "--size", "200x120", "--out", picture(), "--renderer", renderer,
                              "--assets", set})
                          .status,
                      0);
            pictures.push_back(read_file(picture()));
        }
        EXPECT_EQ(pictures[0], pictures[1]) << renderer;
    }
}

TEST_F(Render, SaysThatALinkNeedsTheUsersOwnFiles)
{
    const Finished finished = draw("turret=20&tank=own", "64x48", {"--state"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_NE(finished.err.find("name the folder of its files with --assets"), std::string::npos)
        << finished.err;
    EXPECT_NE(finished.out.find("\"tank\":\"own\""), std::string::npos) << finished.out;
    const std::string waiting = read_file(picture());
    draw("turret=20");
    EXPECT_EQ(waiting, read_file(picture())); // the program's own stands in
}

TEST_F(Render, SaysThatATextureIsNone)
{
    const fs::path assets = own_assets();
    fs::remove(assets / "texture.jpg");
    for (const char* content : {"", "not a picture", "\x89PNG\r\n\x1a\n"}) {
        write_file(assets / "texture.png", content);
        expect_refused(draw_assets(assets), "texture.png");
    }
}

TEST_F(Render, SaysThatAFolderIsNoFile)
{
    const fs::path assets = own_assets();
    fs::remove(assets / "tankobjs/tankbody.obj");
    fs::create_directory(assets / "tankobjs/tankbody.obj");
    expect_refused(draw_assets(assets), "tankbody.obj: is not a file");
}

TEST_F(Render, ReadsTheFilesAlsoWhenOnlyTheStateIsAskedFor)
{
    expect_refused(render({"", "--state", "--assets", folder.path().string()}), "tankbody.obj");
}

TEST_F(Render, SaysThatThereIsNoEgl)
{
    for (const char* renderer : {"emulated", "reference"}) {
        const Finished finished =
            render({"", "--size", "64x48", "--out", picture(), "--assets", ASSETS, "--renderer", renderer},
                   {"__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null"}); // libglvnd then finds no driver at all
        expect_refused(finished, "EGL");
    }
}

} // namespace
