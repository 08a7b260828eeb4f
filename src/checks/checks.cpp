#include "checks/checks.h"

#include "checks/lab_1_checks.h"
#include "checks/lab_2_checks.h"
#include "checks/lab_3_checks.h"

#include <algorithm>
#include <utility>

namespace checks {
namespace {

struct Check
{
    std::string_view id;
    void (*run)(const CheckSubject& subject, Evidence& evidence);
};

constexpr Check CHECKS[] = {
    {"1.1", check_assembly},   {"1.2", check_joints},       {"1.3", check_display_lists},
    {"1.4", check_draw_obj},   {"2.1", check_mesh_spheres}, {"2.2", check_sphere_hierarchy},
    {"2.3", check_point_test}, {"2.4", check_point_shown},  {"2.5", check_line_test},
    {"2.6", check_sparks},     {"3.1", check_low_tank},     {"3.2", check_threshold},
    {"3.3", check_switching},
};

} // namespace

void remember(CheckResults& results, CheckResult result)
{
    for (CheckResult& older : results) {
        if (older.id == result.id) {
            older = std::move(result);
            return;
        }
    }
    results.push_back(std::move(result));
}

const CheckResult* find_result(const CheckResults& results, std::string_view id)
{
    const auto found = std::find_if(results.begin(), results.end(),
                                    [id](const CheckResult& result) { return result.id == id; });
    return found == results.end() ? nullptr : &*found;
}

std::optional<CheckResult> run_check(std::string_view id, const CheckSubject& subject)
{
    for (const Check& check : CHECKS) {
        if (check.id == id) {
            Evidence evidence;
            check.run(subject, evidence);
            return CheckResult{std::string(id), evidence.passed(), evidence.sentences()};
        }
    }
    return std::nullopt;
}

} // namespace checks
