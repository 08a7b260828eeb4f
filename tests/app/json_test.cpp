#include "app/json.h"
#include "mesh/obj_reader.h"

#include "app/commands.h"
#include "app/fields.h"
#include "app/links.h"
#include "app/tasks.h"
#include "app/update.h"
#include "fixtures.h"
#include "json_reader.h"

#include <gtest/gtest.h>

namespace app {
namespace {

JsonValue parsed(const std::string& text)
{
    const std::optional<JsonValue> value = read_json(text);
    EXPECT_TRUE(value) << text;
    return value.value_or(JsonValue{});
}

TEST(JsonTest, StateHasEveryFieldInUnitsForPeople)
{
    State state;
    open_link(state, "task=1.2&turret=-30.25&distance=40&ground=off");
    apply(state, tiny_assets(), "gun_up", 1.0);
    step(state, tiny_assets());
    const JsonValue json = parsed(state_json(state, &tiny_assets()));
    for (const Field& field : fields()) {
        EXPECT_TRUE(json.has(std::string(field.name))) << field.name;
    }
    EXPECT_EQ(json["turret"].text, "-30.25");
    EXPECT_EQ(json["gun"].text, "0.2");
    EXPECT_EQ(json["distance"].number, 40.0);
    EXPECT_EQ(json["ground"].text, "off");
    EXPECT_EQ(json["tick"].number, 1.0);
    EXPECT_EQ(json["revision"].number, static_cast<double>(state.revision.count));
    EXPECT_EQ(json["link"].text, link(state));
    EXPECT_EQ(json["task"].text, "1.2");
    EXPECT_EQ(json["figure"].type, JsonValue::Type::null);
    EXPECT_EQ(json["level"].text, "high");
    ASSERT_EQ(json["held"].items.size(), 1u);
    EXPECT_EQ(json["held"][0].text, "gun_up");
}

TEST(JsonTest, StateWithoutTaskOrAssetsHasNulls)
{
    const JsonValue json = parsed(state_json(State(), nullptr));
    EXPECT_TRUE(json.has("task"));
    EXPECT_EQ(json["task"].type, JsonValue::Type::null);
    EXPECT_TRUE(json.has("level"));
    EXPECT_EQ(json["level"].type, JsonValue::Type::null);
    EXPECT_TRUE(json["held"].items.empty());
    EXPECT_EQ(json["link"].text, "");
}

TEST(JsonTest, EveryStateGivesJson)
{
    std::mt19937_64 random(23);
    for (int i = 0; i < 1000; ++i) {
        ASSERT_TRUE(read_json(state_json(random_state(random), &tiny_assets())));
    }
}

TEST(JsonTest, CommandsHaveTheirKeysGroupsAndRanges)
{
    const JsonValue json = parsed(commands_json());
    ASSERT_EQ(json.items.size(), commands().size());
    std::map<std::string, JsonValue> rows;
    for (const JsonValue& row : json.items) {
        rows[row["name"].text] = row;
        EXPECT_EQ(row["keys"].items.size(), row["key_labels"].items.size());
        EXPECT_FALSE(row["group"].text.empty()) << row["name"].text;
        EXPECT_FALSE(row["kind"].text.empty()) << row["name"].text;
    }
    const JsonValue& left = rows["turret_left"];
    EXPECT_EQ(left["kind"].text, "hold");
    EXPECT_EQ(left["group"].text, "Turret, guns and wheels");
    EXPECT_EQ(left["keys"][0].text, "KeyQ");
    EXPECT_EQ(left["key_labels"][0].text, "Q");
    EXPECT_EQ(left["fields"][0].text, "turret");
    EXPECT_EQ(rows["zoom_in"]["keys"].items.size(), 3u);

    const JsonValue& gun = rows["gun"];
    EXPECT_EQ(gun["kind"].text, "set");
    EXPECT_EQ(gun["unit"].text, "degrees");
    EXPECT_EQ(gun["minimum"].number, -9.0);
    EXPECT_EQ(gun["maximum"].number, 20.0);
    EXPECT_EQ(gun["step"].number, 0.01);
    EXPECT_EQ(gun["default"].number, 0.0);
    EXPECT_FALSE(gun["wraps"].boolean);
    EXPECT_TRUE(rows["turret"]["wraps"].boolean);
    EXPECT_EQ(rows["turret"]["maximum"].number, 179.99);
    EXPECT_EQ(rows["wheels"]["fields"].items.size(), 2u);
    ASSERT_EQ(rows["ground"]["choices"].items.size(), 2u);
    EXPECT_EQ(rows["ground"]["choices"][1].text, "on");
    EXPECT_FALSE(rows["ground"].has("minimum"));
}

TEST(JsonTest, TasksHaveLinksThatOpenThem)
{
    for (std::size_t i = 0; i < tasks().size(); ++i) {
        JsonWriter writer;
        writer.begin_object();
        write_task(writer, tasks()[i]);
        const JsonValue json = parsed(writer.end_object().take());
        State state;
        EXPECT_TRUE(open_link(state, json["link"].text).messages.empty());
        EXPECT_EQ(state.task, i);
        EXPECT_EQ(json["id"].text, tasks()[i].id);
        EXPECT_FALSE(json["commands"].items.empty());
    }
}

TEST(JsonTest, MessagesAreStrings)
{
    const std::vector<std::string> messages = {"a \"b\"", "c"};
    const JsonValue json = parsed(strings_json(messages));
    ASSERT_EQ(json.items.size(), 2u);
    EXPECT_EQ(json[0].text, "a \"b\"");
    EXPECT_EQ(strings_json({}), "[]");
}

TEST(JsonTest, ManifestNamesTenMeshesAndTheTextures)
{
    const JsonValue json = parsed(asset_manifest_json());
    EXPECT_EQ(json["meshes"].items.size(), 10u);
    EXPECT_EQ(json["meshes"][0].text, "tankbody.obj");
    EXPECT_EQ(json["texture"].items.size(), 3u);
    EXPECT_EQ(json["largest_mesh"].number, double(mesh::max_obj_bytes));
    EXPECT_EQ(json["largest_texture"].number, double(mesh::max_image_file_bytes));
}

TEST(JsonTest, WhatCameOfAUsersTankIsASentenceOrNotes)
{
    const std::vector<std::string> notes = {"It is \"scaled\"."};
    const JsonValue json = parsed(tank_brought_json("", notes));
    EXPECT_EQ(json["error"].text, "");
    ASSERT_EQ(json["notes"].items.size(), 1u);
    EXPECT_EQ(json["notes"][0].text, notes[0]);
    EXPECT_EQ(parsed(tank_brought_json("tankbody.obj is missing", {}))["error"].text,
              "tankbody.obj is missing");
}

} // namespace
} // namespace app
