#include "assets/assets.h"

#include "asset_fixtures.h"

#include <gtest/gtest.h>
#include <set>

namespace assets {
namespace {

std::string message(const Files& files)
{
    const base::Result<Assets> result = read_assets(files.views(), PAINT_VIEW);
    EXPECT_FALSE(result);
    return result ? "" : result.error().message();
}

TEST(AssetsTest, TheTableNamesTheLabsTenFiles)
{
    std::set<std::string_view> names;
    for (const MeshFile& file : mesh_files()) {
        names.insert(file.name);
    }
    EXPECT_EQ(names, (std::set<std::string_view>{"tankbody.obj", "tankturret.obj", "tankmaingun.obj",
                                                 "tanksecondarygun.obj", "tankwheel.obj", "tankbodyLow.obj",
                                                 "tankturretLow.obj", "tankmaingunLow.obj",
                                                 "tanksecondarygunLow.obj", "tankwheelLow.obj"}));
}

TEST(AssetsTest, ACompleteSetIsReadIntoItsPlaces)
{
    Files files = Files::complete();
    // Four corners tell the low wheel from the others.
    files.add("tankwheelLow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
    const base::Result<Assets> result = read_assets(files.views(), PAINT_VIEW);
    ASSERT_TRUE(result) << result.error().message();
    const Assets& assets = result.value();
    for (lod::Level level : {lod::Level::high, lod::Level::low}) {
        for (std::size_t i = 0; i < tank::MESH_KIND_COUNT; ++i) {
            const bool is_low_wheel = level == lod::Level::low && i == tank::index_of(tank::MeshKind::wheel);
            EXPECT_EQ(assets.meshes(level)[i].positions.size(), is_low_wheel ? 4u : 3u);
        }
    }
    EXPECT_EQ(assets.texture.width, 2);
    EXPECT_EQ(assets.texture.height, 2);
    EXPECT_EQ(assets.layout[tank::Part::turret].pivot, tank::default_layout()[tank::Part::turret].pivot);
}

TEST(AssetsTest, FoldersAndCaseMakeNoDifferenceAndOtherFilesAreIgnored)
{
    Files files = Files::complete();
    files.remove("tankbody.obj");
    files.remove("tankwheelLow.obj");
    files.remove("texture.tga");
    files.add("some/where/TankBody.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    files.add("C:\\lab\\tankwheellow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    files.add("x/TEXTURE.TGA", tiny_tga());
    files.add("readme.txt", "not an OBJ");
    files.add("broken.obj", "f 1 2");
    const base::Result<Assets> result = read_assets(files.views(), PAINT_VIEW);
    EXPECT_TRUE(result) << result.error().message();
}

TEST(AssetsTest, AMissingFileIsNamed)
{
    Files files = Files::complete();
    files.remove("tankmaingun.obj");
    EXPECT_EQ(message(files), "assets: tankmaingun.obj is missing");
}

TEST(AssetsTest, AllMissingFilesAreNamedInOneSentence)
{
    Files files = Files::complete();
    files.remove("tankmaingun.obj");
    files.remove("tankbodyLow.obj");
    files.remove("texture.tga");
    EXPECT_EQ(message(files),
              "assets: tankmaingun.obj, tankbodyLow.obj and texture.png (or .jpg, .tga) are missing");
    const std::string none = message(Files());
    for (const MeshFile& file : mesh_files()) {
        EXPECT_NE(none.find(file.name), none.npos) << file.name;
    }
}

TEST(AssetsTest, AnErrorInAFileComesWithFileAndLine)
{
    Files files = Files::complete();
    files.add("tankturret.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    EXPECT_EQ(message(files).substr(0, 17), "tankturret.obj:4:") << message(files);
    files = Files::complete();
    files.add("texture.tga", "no picture");
    EXPECT_EQ(message(files).substr(0, 12), "texture.tga:") << message(files);
    files = Files::complete();
    files.add("tankwheel.obj", "");
    EXPECT_EQ(message(files).substr(0, 13), "tankwheel.obj") << message(files);
}

TEST(AssetsTest, AFileGivenTwiceIsRefused)
{
    Files files = Files::complete();
    files.add("other/tankbody.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(message(files),
              "tankbody.obj: is there more than once, as \"other/tankbody.obj\" and as \"tankbody.obj\"");
    files = Files::complete();
    files.add("other/texture.tga", tiny_tga());
    EXPECT_NE(message(files).find("more than once"), std::string::npos);
}

TEST(AssetsTest, OfSeveralTexturesTheFirstOfTheTableIsRead)
{
    Files files = Files::complete();
    files.add("texture.png", "broken");
    EXPECT_EQ(message(files).substr(0, 12), "texture.png:");
}

} // namespace
} // namespace assets
