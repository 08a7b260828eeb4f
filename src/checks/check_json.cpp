#include "checks/check_json.h"

#include "app/report/tables_json.h"

namespace checks {
namespace {

void write_result(base::JsonWriter& json, const CheckResult* result)
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

void write_checked_task(base::JsonWriter& json, const app::Task& task, const CheckResults& results)
{
    json.begin_object();
    app::write_task(json, task);
    write_result(json, find_result(results, task.id));
    json.end_object();
}

} // namespace

std::string task_json(std::string_view id, const CheckResults& results)
{
    base::JsonWriter json;
    for (const app::Task& task : app::tasks()) {
        if (task.id == id) {
            write_checked_task(json, task, results);
            return json.take();
        }
    }
    return json.null().take();
}

std::string tasks_json(const CheckResults& results)
{
    base::JsonWriter json;
    json.begin_array();
    for (const app::Task& task : app::tasks()) {
        write_checked_task(json, task, results);
    }
    json.end_array();
    return json.take();
}

} // namespace checks
