#include "checks/capture_json.h"

#include "base/json_writer.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace checks {
namespace {

constexpr int DECIMALS = 6;
constexpr double STEPS = 1e6;
constexpr double LARGEST = 9e12; // more steps than that are no whole 64-bit number

void write_number(base::JsonWriter& json, double value)
{
    if (!(std::fabs(value) < LARGEST)) {
        json.null(); // JSON has no infinity and no NaN
    } else {
        json.decimal(std::llround(value * STEPS), DECIMALS);
    }
}

/// Counts the vertices from a glBegin to its glEnd; `index` then is at the glEnd, or at the end of it all.
std::uint64_t skip_primitive(std::span<const LegacyGLCall> calls, std::size_t& index)
{
    std::uint64_t vertices = 0;
    for (++index; index < calls.size(); ++index) {
        const std::string_view name = calls[index].name;
        if (name == "glEnd") {
            break;
        }
        vertices += name.starts_with("glVertex") ? 1u : 0u;
    }
    return vertices;
}

void write_call(base::JsonWriter& json, const LegacyGLCall& call)
{
    json.key("name").string(call.name);
    json.key("list_depth").number(static_cast<std::int64_t>(call.list_depth));
    json.key("arguments").begin_array();
    for (int i = 0; i < call.argument_count; ++i) {
        write_number(json, call.arguments[i]);
    }
    json.end_array();
}

} // namespace

std::string capture_json(std::span<const LegacyGLCall> calls)
{
    base::JsonWriter json;
    json.begin_array();
    for (std::size_t i = 0; i < calls.size(); ++i) {
        const LegacyGLCall& call = calls[i];
        const std::string_view name = call.name;
        json.begin_object();
        write_call(json, call);
        if (name == "glCallList") {
            json.key("modelview").begin_array();
            for (float entry : call.modelview) {
                write_number(json, static_cast<double>(entry));
            }
            json.end_array();
        } else if (name == "glBegin" && call.list_depth > 0) {
            json.key("vertices").number(skip_primitive(calls, i));
        }
        json.end_object();
    }
    json.end_array();
    return json.take();
}

} // namespace checks
