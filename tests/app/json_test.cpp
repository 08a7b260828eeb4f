#include "app/report/state_json.h"
#include "app/report/tables_json.h"
#include "mesh/obj_reader.h"

#include "app/commands/commands.h"
#include "app/commands/update.h"
#include "app/links/links.h"
#include "app/links/tasks.h"
#include "app/state/fields.h"
#include "fixtures.h"
#include "parsed_json.h"

#include <gtest/gtest.h>

namespace app {
namespace {

using nlohmann::json;

json parsed(const std::string& text)
{
    json value = parsed_json(text);
    EXPECT_FALSE(value.is_discarded()) << text;
    return value;
}

TEST(JsonTest, StateHasEveryFieldInUnitsForPeople)
{
    State state;
    open_link(state, "task=1.2&turret=-30.25&distance=40&ground=off");
    apply(state, assets::tiny_assets(), "gun_up", 1.0);
    step(state, assets::tiny_assets());
    const json read = parsed(state_json(state, &assets::tiny_assets()));
    for (const Field& field : fields()) {
        EXPECT_TRUE(read.contains(std::string(field.name))) << field.name;
    }
    EXPECT_EQ(read["turret"].dump(), "-30.25");
    EXPECT_EQ(read["gun"].dump(), "0.2");
    EXPECT_EQ(read["distance"], 40.0);
    EXPECT_EQ(read["ground"], "off");
    EXPECT_EQ(read["tick"], 1.0);
    EXPECT_EQ(read["revision"], 0);
    EXPECT_EQ(read["link"], link(state));
    EXPECT_EQ(read["task"], "1.2");
    EXPECT_TRUE(read["figure"].is_null());
    EXPECT_EQ(read["level"], "high");
    ASSERT_EQ(read["held"].size(), 1u);
    EXPECT_EQ(read["held"][0], "gun_up");
}

TEST(JsonTest, StateWithoutTaskOrAssetsHasNulls)
{
    const json read = parsed(state_json(State(), nullptr));
    EXPECT_TRUE(read.contains("task"));
    EXPECT_TRUE(read["task"].is_null());
    EXPECT_TRUE(read.contains("level"));
    EXPECT_TRUE(read["level"].is_null());
    EXPECT_TRUE(read["held"].empty());
    EXPECT_EQ(read["link"], "");
}

TEST(JsonTest, EveryStateGivesJson)
{
    std::mt19937_64 random(23);
    for (int i = 0; i < 1000; ++i) {
        ASSERT_FALSE(parsed_json(state_json(random_state(random), &assets::tiny_assets())).is_discarded());
    }
}

TEST(JsonTest, StatusHasWhatIsShownAtAllTimesAndNothingThatTakesLong)
{
    Simulation simulation(assets::own_assets());
    simulation.open_link("task=3.1");
    simulation.apply("turret_left", 1.0);
    const json read = parsed(status_json(simulation));
    EXPECT_EQ(read["task"], "3.1");
    EXPECT_EQ(read["detail"], "both");
    EXPECT_EQ(read["level"], "high");
    EXPECT_EQ(read["held"], json({"turret_left"}));
    EXPECT_EQ(read["flies"], false);
    EXPECT_EQ(read["sparks"], 0);
    EXPECT_EQ(read["revision"], simulation.revision());
    EXPECT_EQ(read["printed"], simulation.log().count());
    std::size_t faces = 0;
    for (const tank::PartPlacement& placement : assets::own_assets().layout.parts) {
        faces += assets::own_assets().high[tank::index_of(placement.mesh)].faces.size();
        faces += assets::own_assets().low[tank::index_of(placement.mesh)].faces.size();
    }
    EXPECT_EQ(read["triangles"], faces);
    for (const char* costly : {"hash", "hits", "evidence", "link"}) {
        EXPECT_FALSE(read.contains(costly)) << costly;
    }
}

TEST(JsonTest, WhatIsAskedForApartIsWhatTheWholeStateHas)
{
    Simulation simulation(assets::own_assets());
    simulation.open_link("task=2.3");
    const json whole = parsed(state_json(simulation));
    const json fields_read = parsed(fields_json(simulation.state()));
    EXPECT_EQ(fields_read.size(), fields().size());
    for (const auto& [name, value] : fields_read.items()) {
        EXPECT_EQ(value, whole[name]) << name;
    }
    const json evidence = parsed(evidence_json(simulation));
    EXPECT_EQ(evidence["evidence"], whole["evidence"]);
    EXPECT_EQ(evidence["moving"], whole["moving"]);
    EXPECT_EQ(evidence["axis"], whole["axis"]);
}

TEST(JsonTest, CommandsHaveTheirKeysGroupsAndRanges)
{
    const json read = parsed(commands_json());
    ASSERT_EQ(read.size(), commands().size());
    std::map<std::string, json> rows;
    for (const json& row : read) {
        rows[row["name"]] = row;
        EXPECT_EQ(row["keys"].size(), row["key_labels"].size());
        EXPECT_FALSE(row["group"].get<std::string>().empty()) << row["name"];
        EXPECT_FALSE(row["kind"].get<std::string>().empty()) << row["name"];
    }
    const json& left = rows["turret_left"];
    EXPECT_EQ(left["kind"], "hold");
    EXPECT_EQ(left["group"], "Turret, guns and wheels");
    EXPECT_EQ(left["keys"][0], "KeyQ");
    EXPECT_EQ(left["key_labels"][0], "Q");
    EXPECT_EQ(left["fields"][0], "turret");
    EXPECT_EQ(rows["zoom_in"]["keys"].size(), 3u);

    const json& gun = rows["gun"];
    EXPECT_EQ(gun["kind"], "set");
    EXPECT_EQ(gun["unit"], "degrees");
    EXPECT_EQ(gun["minimum"], -9.0);
    EXPECT_EQ(gun["maximum"], 20.0);
    EXPECT_EQ(gun["step"], 0.01);
    EXPECT_EQ(gun["default"], 0.0);
    EXPECT_EQ(gun["wraps"], false);
    EXPECT_EQ(rows["turret"]["wraps"], true);
    EXPECT_EQ(rows["turret"]["maximum"], 179.99);
    EXPECT_EQ(rows["wheels"]["fields"].size(), 2u);
    ASSERT_EQ(rows["ground"]["choices"].size(), 2u);
    EXPECT_EQ(rows["ground"]["choices"][1], "on");
    EXPECT_FALSE(rows["ground"].contains("minimum"));
}

TEST(JsonTest, TasksHaveLinksThatOpenThem)
{
    for (std::size_t i = 0; i < tasks().size(); ++i) {
        base::JsonWriter writer;
        writer.begin_object();
        write_task(writer, tasks()[i]);
        const json read = parsed(writer.end_object().take());
        State state;
        EXPECT_TRUE(open_link(state, read["link"].get<std::string>()).messages.empty());
        EXPECT_EQ(state.task, i);
        EXPECT_EQ(read["id"], tasks()[i].id);
        EXPECT_FALSE(read["commands"].empty());
    }
}

TEST(JsonTest, MessagesAreStrings)
{
    const std::vector<std::string> messages = {"a \"b\"", "c"};
    const json read = parsed(strings_json(messages));
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0], "a \"b\"");
    EXPECT_EQ(strings_json({}), "[]");
}

TEST(JsonTest, ManifestNamesTenMeshesAndTheTextures)
{
    const json read = parsed(asset_manifest_json());
    EXPECT_EQ(read["meshes"].size(), 10u);
    EXPECT_EQ(read["meshes"][0], "tankbody.obj");
    EXPECT_EQ(read["texture"].size(), 3u);
    EXPECT_EQ(read["largest_mesh"], double(mesh::MAX_OBJ_BYTES));
    EXPECT_EQ(read["largest_texture"], double(image::MAX_IMAGE_FILE_BYTES));
}

TEST(JsonTest, WhatCameOfAUsersTankIsASentenceOrNotes)
{
    const std::vector<std::string> notes = {"It is \"scaled\"."};
    const json read = parsed(tank_brought_json("", notes));
    EXPECT_EQ(read["error"], "");
    ASSERT_EQ(read["notes"].size(), 1u);
    EXPECT_EQ(read["notes"][0], notes[0]);
    EXPECT_EQ(parsed(tank_brought_json("tankbody.obj is missing", {}))["error"], "tankbody.obj is missing");
}

} // namespace
} // namespace app
