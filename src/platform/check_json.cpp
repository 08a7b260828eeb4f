#include "platform/check_json.h"

#include "app/json_writer.h"
#include "app/tasks.h"

namespace platform {
namespace {

void write_result(app::JsonWriter& json, const CheckResult* result)
{
    json.key("passed");
    if (result == nullptr) {
        json.null();
    } else {
        json.boolean(result->passed);
    }
    json.key("evidence").begin_array();
    if (result != nullptr) {
        for (const std::string& sentence : result->evidence) {
            json.string(sentence);
        }
    }
    json.end_array();
}

void write_task(app::JsonWriter& json, const app::Task& task, const CheckResults& results)
{
    json.begin_object();
    json.key("id").string(task.id);
    json.key("title").string(task.title);
    json.key("text").string(task.text);
    json.key("commands").begin_array();
    for (std::string_view command : task.commands) {
        if (!command.empty()) {
            json.string(command);
        }
    }
    json.end_array();
    json.key("link").string(std::string(app::link_key(task.kind)) + "=" + std::string(task.id));
    json.key("source").string(task.source);
    write_result(json, find_result(results, task.id));
    json.end_object();
}

} // namespace

std::string task_json(std::string_view id, const CheckResults& results)
{
    app::JsonWriter json;
    if (const auto row = app::find_task(app::TaskKind::task, id)) {
        write_task(json, app::tasks()[*row], results);
    } else {
        json.null();
    }
    return json.take();
}

std::string tasks_json(const CheckResults& results)
{
    app::JsonWriter json;
    json.begin_array();
    for (const app::Task& task : app::tasks()) {
        if (task.kind == app::TaskKind::task) {
            write_task(json, task, results);
        }
    }
    json.end_array();
    return json.take();
}

} // namespace platform
