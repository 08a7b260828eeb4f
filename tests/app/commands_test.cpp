#include "app/commands/commands.h"

#include "fixtures.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace app {
namespace {

TEST(CommandsTest, NoNameTwice)
{
    std::set<std::string_view> names;
    for (const Command& command : commands()) {
        EXPECT_TRUE(names.insert(command.name).second) << command.name;
        EXPECT_EQ(find_command(command.name), &command);
        EXPECT_FALSE(command.title.empty());
    }
    EXPECT_EQ(find_command("nothing"), nullptr);
    EXPECT_EQ(find_command(""), nullptr);
}

TEST(CommandsTest, NoKeyTwice)
{
    std::map<Key, std::string_view> owners;
    for (const Command& command : commands()) {
        for (Key key : command.keys) {
            if (key == Key::none) {
                continue;
            }
            EXPECT_TRUE(owners.emplace(key, command.name).second) << command.name << " and " << owners[key];
            EXPECT_EQ(command_for_key(key), &command);
            EXPECT_FALSE(key_code(key).empty()) << command.name;
        }
    }
    EXPECT_EQ(command_for_key(Key::none), nullptr);
}

TEST(CommandsTest, TheProjectileIsMovedAlongEveryAxisBothWaysByKeys)
{
    const struct
    {
        Key key;
        FieldId field;
        double sign;
    } keys[] = {
        {Key::j, FieldId::point_x, -1.0}, {Key::l, FieldId::point_x, 1.0},  {Key::u, FieldId::point_y, -1.0},
        {Key::o, FieldId::point_y, 1.0},  {Key::i, FieldId::point_z, -1.0}, {Key::k, FieldId::point_z, 1.0},
    };
    for (const auto& row : keys) {
        const Command* command = command_for_key(row.key);
        ASSERT_NE(command, nullptr);
        EXPECT_EQ(command->kind, CommandKind::hold);
        EXPECT_EQ(command->moves[0].field, row.field);
        EXPECT_GT(command->moves[0].rate * row.sign, 0.0);
        EXPECT_TRUE(command->moves[0].of_handle);
    }
}

TEST(CommandsTest, EveryChoiceHasAKeyThatGoesThroughAllOfThem)
{
    for (const Field& field : fields()) {
        if (field.choices.empty()) {
            continue;
        }
        bool found = false;
        for (const Command& command : commands()) {
            if (command.kind != CommandKind::press || command.keys[0] == Key::none) {
                continue;
            }
            State state;
            std::set<std::int64_t> seen;
            for (std::size_t i = 0; i < field.choices.size(); ++i) {
                seen.insert(grid_value(field, state));
                ASSERT_EQ(command.press(state, assets::tiny_assets()).refusal, "");
            }
            found = found || (seen.size() == field.choices.size() && state == State());
        }
        EXPECT_TRUE(found) << field.name;
    }
}

TEST(CommandsTest, UnusedKeysComeLast)
{
    for (const Command& command : commands()) {
        EXPECT_TRUE(std::is_partitioned(command.keys.begin(), command.keys.end(), [](Key key) {
            return key != Key::none;
        })) << command.name;
    }
}

TEST(CommandsTest, EveryKindHasWhatItNeeds)
{
    for (std::size_t i = 0; i < commands().size(); ++i) {
        const Command& command = commands()[i];
        EXPECT_EQ(command.kind == CommandKind::press, command.press != nullptr) << command.name;
        EXPECT_EQ(command.kind == CommandKind::press, command.moves.empty()) << command.name;
        if (command.kind == CommandKind::hold) {
            EXPECT_LT(i, MAX_HELD_COMMANDS);
        }
        if (command.kind == CommandKind::hold || command.kind == CommandKind::add) {
            for (const Move& move : command.moves) {
                EXPECT_NE(move.rate, 0.0) << command.name;
            }
        }
    }
}

TEST(CommandsTest, EveryFieldAndAliasCanBeSetByItsName)
{
    for (const Field& field : fields()) {
        const Command* command = find_command(field.name);
        ASSERT_NE(command, nullptr) << field.name;
        EXPECT_EQ(command->kind, CommandKind::set);
        ASSERT_EQ(command->moves.size(), 1u);
        EXPECT_EQ(command->moves[0].field, field.id);
    }
    const Command* wheels = find_command("wheels");
    ASSERT_NE(wheels, nullptr);
    EXPECT_EQ(wheels->moves.size(), 2u);
}

TEST(CommandsTest, FieldsOfOneCommandHaveOneRange)
{
    for (const Command& command : commands()) {
        for (const Move& move : command.moves) {
            const Field& first = field(command.moves[0].field);
            EXPECT_EQ(field(move.field).minimum, first.minimum) << command.name;
            EXPECT_EQ(field(move.field).maximum, first.maximum) << command.name;
            EXPECT_EQ(field(move.field).initial, first.initial) << command.name;
            EXPECT_EQ(field(move.field).unit.name, first.unit.name) << command.name;
        }
    }
}

TEST(CommandsTest, EveryJointOfTheLabTurnsBothWaysByKeysAtOneRate)
{
    for (FieldId id :
         {FieldId::turret, FieldId::main_gun, FieldId::secondary_gun, FieldId::secondary_gun_pitch,
          FieldId::wheels_left, FieldId::wheels_right, FieldId::heading}) {
        double sum = 0.0;
        int ways = 0;
        for (const Command& command : commands()) {
            for (const Move& move : command.moves) {
                if (command.kind == CommandKind::hold && move.field == id) {
                    EXPECT_NE(command.keys[0], Key::none) << command.name;
                    sum += move.rate;
                    ++ways;
                }
            }
        }
        EXPECT_EQ(ways, 2) << field(id).name;
        EXPECT_EQ(sum, 0.0) << field(id).name;
    }
}

} // namespace
} // namespace app
