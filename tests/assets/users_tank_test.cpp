// A tank that a user brings: the lab's own data with all their quirks, and any other under the same names.
#include "assets/users_tank.h"

#include "assets/original_texture.h"
#include "mesh/obj_reader.h"
#include "original_set.h"
#include "tank/bounding_box_layout.h"
#include "tank/original_layout.h"
#include "tank/part_matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace assets {
namespace {

using tank::Box;
using tank::MeshKind;
using tank::Part;

constexpr double HULL = 7.515; // metres, of our tank
constexpr double UNIT = HULL / 172.0;

UsersTank read(const Files& files)
{
    base::Result<UsersTank> tank = read_users_tank(files.views(), PAINT_VIEW);
    EXPECT_TRUE(tank) << tank.error().message();
    return tank ? std::move(tank).value() : UsersTank{};
}

std::string message(const Files& files)
{
    const base::Result<UsersTank> tank = read_users_tank(files.views(), PAINT_VIEW);
    EXPECT_FALSE(tank);
    return tank ? "" : tank.error().message();
}

std::string notes(const UsersTank& tank)
{
    std::string all;
    for (const std::string& note : tank.notes) {
        all += note + "\n";
    }
    return all;
}

/// Returns where a part's mesh is in the assembled tank.
Box placed(const Assets& assets, Part part, const tank::JointAngles& angles = {},
           lod::Level level = lod::Level::high)
{
    const tank::Layout& layout = assets.layout_of(level);
    const glm::mat4 matrix = tank::part_matrices(layout, {}, angles).mesh(part);
    Box box{glm::vec3(1e9f), glm::vec3(-1e9f)};
    for (const glm::vec3& position : assets.meshes(level)[tank::index_of(layout[part].mesh)].positions) {
        const glm::vec3 world(matrix * glm::vec4(position, 1.0f));
        box = {glm::min(box.minimum, world), glm::max(box.maximum, world)};
    }
    return box;
}

void expect_box(const Box& box, const glm::vec3& minimum, const glm::vec3& maximum)
{
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.minimum[axis], double(minimum[axis]) * UNIT, 1e-4) << "axis " << axis;
        EXPECT_NEAR(box.maximum[axis], double(maximum[axis]) * UNIT, 1e-4) << "axis " << axis;
    }
}

bool winds_with_normals(const mesh::ObjMesh& mesh, const mesh::Face& face)
{
    const auto at = [&](int i) {
        return mesh.positions[static_cast<std::size_t>(face.vertices[i].position)];
    };
    const glm::vec3 normal = mesh.normals[static_cast<std::size_t>(face.vertices[0].normal)];
    return glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), normal) > 0.0f;
}

double share_against_normals(const mesh::ObjMesh& mesh)
{
    const auto against = std::count_if(mesh.faces.begin(), mesh.faces.end(), [&](const mesh::Face& face) {
        return !winds_with_normals(mesh, face);
    });
    return static_cast<double>(against) / static_cast<double>(mesh.faces.size());
}

TEST(OriginalTankTest, IsRecognisedAndTheFactorIsShown)
{
    const UsersTank tank = read(original_set());
    EXPECT_EQ(tank.data, TankData::original);
    EXPECT_NEAR(tank.assets.scale, UNIT, 1e-9);
    EXPECT_NE(notes(tank).find("the lab's own tank"), std::string::npos) << notes(tank);
    EXPECT_NE(notes(tank).find("scaled by 0.04369, so that its hull is 7.515 m long"), std::string::npos)
        << notes(tank);
    EXPECT_EQ(tank.notes.size(), 2u);
}

TEST(OriginalTankTest, IsRecognisedInAnyUnit)
{
    for (const double unit : {0.1, 0.025, 25.4}) {
        const UsersTank tank = read(original_set({.unit = unit}));
        EXPECT_EQ(tank.data, TankData::original);
        EXPECT_NEAR(tank.assets.scale * unit, UNIT, 1e-6);
        const Box gun = placed(tank.assets, Part::main_gun);
        EXPECT_NEAR(gun.maximum.z, 108.4 * UNIT, 1e-3);
    }
}

TEST(OriginalTankTest, StandsOnTheGroundWithEveryPartInItsPlace)
{
    const Assets assets = read(original_set()).assets;
    const float lift = 19.0f;
    expect_box(placed(assets, Part::body), {-39.4f, 0.0f, -92.9f}, {39.4f, 17.9f + lift, 79.1f});
    expect_box(placed(assets, Part::turret), {-35.0f, 11.0f + lift, -64.4f}, {35.5f, 106.4f + lift, 39.6f});
    // Brought from far off to the front of the turret.
    expect_box(placed(assets, Part::main_gun), {-6.2f, 14.6f + lift, 20.5f}, {6.6f, 28.2f + lift, 108.4f});
    // On the roof, not on the tips of the antennas, which the box has for the turret's height.
    const float roof = 14.0f + lift + MADE_ROOF;
    expect_box(placed(assets, Part::secondary_gun), {-15.1f, roof, -7.1f}, {-8.5f, roof + 8.7f, 29.7f});
    // Within the hull's width, on either side alike.
    expect_box(placed(assets, Part::wheel_right_1), {-38.0f, -17.45f + lift, 35.615f},
               {-23.1f, -2.55f + lift, 50.415f});
    expect_box(placed(assets, Part::wheel_left_7), {23.1f, -17.45f + lift, -64.415f},
               {38.0f, -2.55f + lift, -49.615f});
}

TEST(OriginalTankTest, TurnsEachPartAboutItsPivot)
{
    const Assets assets = read(original_set()).assets;
    const auto moved = [&](Part part, const tank::JointAngles& angles, const glm::vec3& in_mesh) {
        const glm::mat4 matrix = tank::part_matrices(assets.layout, {}, angles).mesh(part);
        return glm::vec3(matrix * glm::vec4(in_mesh * static_cast<float>(UNIT), 1.0f));
    };
    const auto expect_fixed = [&](Part part, tank::Joint joint, double radians, const glm::vec3& in_mesh) {
        tank::JointAngles angles;
        angles[joint] = radians;
        EXPECT_LT(glm::distance(moved(part, {}, in_mesh), moved(part, angles, in_mesh)), 1e-4f)
            << tank::part_name(part);
    };
    expect_fixed(Part::turret, tank::Joint::turret, 1.0, {0.0f, 5.0f, 0.0f});
    expect_fixed(Part::main_gun, tank::Joint::main_gun, 0.3, {-53.7f, 7.0f + 102.0f, 25.0f - 11.0f});
    expect_fixed(Part::secondary_gun, tank::Joint::secondary_gun, 1.0, {0.0f, 3.0f, -10.0f});
    expect_fixed(Part::wheel_left_3, tank::Joint::wheels_left, 2.0, {-5.0f, -0.05f, 0.385f});
    expect_fixed(Part::wheel_right_3, tank::Joint::wheels_right, 2.0, {-5.0f, -0.05f, 0.385f});
    // The secondary gun pitches about its mesh's origin at half its height.
    expect_fixed(Part::secondary_gun, tank::Joint::secondary_gun_pitch, 1.0, {2.0f, 4.65f, 0.0f});
    tank::JointAngles pitched;
    pitched[tank::Joint::secondary_gun_pitch] = 0.3;
    EXPECT_GT(placed(assets, Part::secondary_gun, pitched).maximum.y,
              placed(assets, Part::secondary_gun).maximum.y + 8.0f * static_cast<float>(UNIT));
    // The gun's muzzle rises.
    tank::JointAngles raised;
    raised[tank::Joint::main_gun] = 0.3;
    EXPECT_GT(placed(assets, Part::main_gun, raised).maximum.y,
              placed(assets, Part::main_gun).maximum.y + 20.0f * static_cast<float>(UNIT));
}

TEST(OriginalTankTest, ShowsTheLowWheelsOutsideTheLowBody)
{
    const Assets assets = read(original_set()).assets;
    const Box body = placed(assets, Part::body, {}, lod::Level::low);
    for (const Part part : {Part::wheel_left_1, Part::wheel_left_7}) {
        EXPECT_GT(placed(assets, part, {}, lod::Level::low).maximum.x, body.maximum.x);
        EXPECT_LT(placed(assets, part, {}, lod::Level::high).maximum.x, body.maximum.x);
    }
    EXPECT_LT(placed(assets, Part::wheel_right_4, {}, lod::Level::low).minimum.x, body.minimum.x);
}

TEST(OriginalTankTest, HasItsTextureTheRightWayUp)
{
    const Files files = original_set();
    const image::Image& image = read(files).assets.texture;
    ASSERT_EQ(image.width, 1024);
    ASSERT_EQ(image.pixels.size(), 1024u * 1024u * 3u);
    EXPECT_EQ(image.pixels[0], 0); // the lower left corner is blue, as it is seen
    EXPECT_EQ(image.pixels[2], 200);
    EXPECT_EQ(image.pixels[image.pixels.size() - 3], 200); // the upper right one red
}

TEST(OriginalTankTest, BelievesTheHeaderOfATextureThatIsNotTheLabs)
{
    // Another tank: nobody says that its picture is the wrong way round.
    const Assets other = read(original_set({.turret_stretch = 1.3f})).assets;
    EXPECT_EQ(other.texture.pixels[0], 200);
    // The lab's tank with a picture of another form.
    Files files = original_set();
    std::string tga = tiny_tga();
    files.add("texture.tga", tga);
    EXPECT_EQ(read(files).assets.texture.pixels[0],
              image::read_image("", files.views().back().bytes).value().pixels[0]);
    for (const auto& [place, value] : {std::pair{2, 2}, {13, 2}, {16, 32}, {17, 0x20}}) {
        tga = original_tga();
        tga[static_cast<std::size_t>(place)] = static_cast<char>(value);
        EXPECT_FALSE(
            has_form_of_original_texture({reinterpret_cast<const std::uint8_t*>(tga.data()), tga.size()}));
    }
}

TEST(OriginalTankTest, WindsItsFacesAsTheNormalsSay)
{
    const Files files = original_set();
    bool seen_raw = false;
    for (const AssetFile& file : files.views()) {
        if (file.name.ends_with("tankbody.obj")) {
            const auto raw = mesh::read_obj(
                file.name, {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
            EXPECT_NEAR(share_against_normals(raw.value()), 0.06, 0.005);
            seen_raw = true;
        }
    }
    EXPECT_TRUE(seen_raw);
    const Assets assets = read(files).assets;
    EXPECT_FALSE(assets.is_one_sided);
    for (const lod::Level level : {lod::Level::high, lod::Level::low}) {
        for (const mesh::ObjMesh& mesh : assets.meshes(level)) {
            EXPECT_EQ(share_against_normals(mesh), 0.0);
        }
    }
}

TEST(OriginalTankTest, ReadsTextureCoordinatesOfThreeNumbersAndLowMeshesWithoutAny)
{
    const Assets assets = read(original_set()).assets;
    for (const mesh::ObjMesh& mesh : assets.high) {
        EXPECT_GE(mesh.faces[0].vertices[0].texture_coordinate, 0);
        EXPECT_EQ(mesh.texture_coordinates.size(), mesh.positions.size());
    }
    for (const mesh::ObjMesh& mesh : assets.low) {
        EXPECT_EQ(mesh.faces[0].vertices[0].texture_coordinate, -1);
    }
}

TEST(UsersTankTest, WithoutLowModelsShowsTheHighOnesAndSaysSo)
{
    const UsersTank tank = read(original_set({.has_low_model = false}));
    EXPECT_FALSE(tank.assets.has_low_model);
    EXPECT_EQ(&tank.assets.meshes(lod::Level::low), &tank.assets.high);
    EXPECT_NE(notes(tank).find("no low model"), std::string::npos) << notes(tank);
}

TEST(UsersTankTest, WithoutATextureHasOneColourAndSaysSo)
{
    const UsersTank tank = read(original_set({.has_texture = false}));
    EXPECT_EQ(tank.assets.texture.pixels.size(), 3u);
    EXPECT_NE(notes(tank).find("no texture"), std::string::npos) << notes(tank);
}

TEST(UsersTankTest, WithAPartMissingIsRefusedAndThePartNamed)
{
    Files files = original_set();
    files.remove("tankobjs/tankwheel.obj");
    EXPECT_EQ(message(files), "assets: tankwheel.obj is missing");
    files.remove("tankobjs/tankturretLow.obj"); // a low model in part is no low model, and no high one either
    EXPECT_EQ(message(files), "assets: tankwheel.obj and tankturretLow.obj are missing");
    EXPECT_NE(message(Files()).find("tankbody.obj"), std::string::npos);
}

TEST(UsersTankTest, TakesTheSameFileTwiceForOneAndRefusesTwoOfOneName)
{
    Files files = original_set();
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    files.add("copy/TEXTURE.TGA", original_tga());
    files.add("__MACOSX/tankobjs/._tankbody.obj", "\x05\x16\x07");
    EXPECT_EQ(read(files).data, TankData::original);
    files.add("copy/TankBody.obj", text);
    EXPECT_NE(message(files).find("tankbody.obj: is there more than once"), std::string::npos);
}

TEST(UsersTankTest, NamesFileAndLineOfAFault)
{
    Files files = original_set();
    files.add("tankobjs/tankturret.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    EXPECT_EQ(message(files).substr(0, 17), "tankturret.obj:4:");
    files = original_set();
    files.add("tankobjs/tankwheelLow.obj", "");
    EXPECT_EQ(message(files), "tankwheelLow.obj: the file is empty");
    files = original_set();
    files.add("texture.tga", original_tga().substr(0, 5000));
    EXPECT_NE(message(files).find("texture.tga: the image is cut short"), std::string::npos);
}

TEST(UsersTankTest, OurOwnFilesAreOurOwnTank)
{
    const Assets& ours = own_assets();
    const UsersTank tank = read(own_files());
    EXPECT_EQ(tank.data, TankData::ours);
    EXPECT_TRUE(tank.notes.empty()) << notes(tank);
    EXPECT_EQ(tank.assets.scale, 1.0);
    EXPECT_TRUE(tank.assets.is_one_sided);
    for (std::size_t i = 0; i < tank::MESH_KIND_COUNT; ++i) {
        EXPECT_EQ(tank.assets.high[i].positions, ours.high[i].positions);
        EXPECT_EQ(tank.assets.low[i].faces, ours.low[i].faces);
    }
    EXPECT_EQ(tank.assets.texture.pixels, ours.texture.pixels);
}

TEST(UsersTankTest, AnyOtherSetIsLaidOutByItsBoxes)
{
    const UsersTank tank = read(original_set({.turret_stretch = 1.3f}));
    EXPECT_EQ(tank.data, TankData::other);
    EXPECT_NE(notes(tank).find("bounding boxes"), std::string::npos) << notes(tank);
    const Box body = placed(tank.assets, Part::body);
    EXPECT_NEAR(body.minimum.y, 0.0f, 1e-5f);
    EXPECT_NEAR(body.maximum.z - body.minimum.z, HULL, 1e-4);
    // The gun reaches out of the turret's front, and both are where they belong, more or less.
    const Box turret = placed(tank.assets, Part::turret);
    const Box gun = placed(tank.assets, Part::main_gun);
    EXPECT_NEAR(turret.minimum.y, body.maximum.y, 0.3f);
    EXPECT_LT(gun.minimum.z, turret.maximum.z);
    EXPECT_GT(gun.maximum.z, turret.maximum.z + 2.0f);
    EXPECT_NEAR(0.5f * (gun.minimum.x + gun.maximum.x), 0.0f, 0.05f);
    const Box secondary = placed(tank.assets, Part::secondary_gun);
    EXPECT_NEAR(secondary.minimum.y, double(turret.minimum.y) + double(MADE_ROOF + 3.0f) * UNIT, 1e-4);
}

TEST(UsersTankTest, MeshesThatNoScaleMakesATankAreRefused)
{
    Files files = original_set();
    files.add("tankobjs/tankbody.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); // no length along Z
    EXPECT_EQ(message(files).substr(0, 13), "tankbody.obj:");
    EXPECT_NE(message(files).find("length along Z"), std::string::npos);
    files.add("tankobjs/tankbody.obj", "v 0 0 0\nv 1 0 0\nv 0 1 1e30\nf 1 2 3\n");
    EXPECT_NE(message(files).find("too large"), std::string::npos) << message(files);
    files = original_set();
    files.add("tankobjs/tankmaingun.obj", "v 0 0 0\nv 1e6 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_NE(message(files).find("tankmaingun.obj: the part lies more than 1000 m"), std::string::npos)
        << message(files);
}

} // namespace
} // namespace assets
