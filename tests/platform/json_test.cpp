#include "checks/capture_json.h"
#include "checks/check_json.h"

#include "checks/frame_capture.h"

#include <limits>

#include <gtest/gtest.h>

namespace {

LegacyGLCall call(const char* name, int list_depth, std::initializer_list<double> arguments = {})
{
    LegacyGLCall call{};
    call.name = name;
    call.list_depth = list_depth;
    for (double argument : arguments) {
        call.arguments[call.argument_count++] = argument;
    }
    return call;
}

TEST(CaptureJson, ListsCallsWithTheirArguments)
{
    const LegacyGLCall calls[] = {call("glPushMatrix", 0), call("glTranslatef", 0, {1.5, -2.0, 0.25})};
    EXPECT_EQ(checks::capture_json(calls),
              R"([{"name":"glPushMatrix","list_depth":0,"arguments":[]},)"
              R"({"name":"glTranslatef","list_depth":0,"arguments":[1.5,-2,0.25]}])");
}

TEST(CaptureJson, GivesTheMatrixThatAListIsCalledUnder)
{
    LegacyGLCall list = call("glCallList", 0, {3});
    for (int i = 0; i < 16; ++i) {
        list.modelview[i] = static_cast<float>(i) / 2.0f;
    }
    EXPECT_NE(checks::capture_json({&list, 1}).find(R"("modelview":[0,0.5,1,1.5,2,2.5,3,)"),
              std::string::npos);
}

TEST(CaptureJson, CountsTheVerticesOfListsAndListsThoseOfTheProgram)
{
    const LegacyGLCall calls[] = {call("glBegin", 1, {4}), call("glNormal3f", 1), call("glVertex4f", 1),
                                  call("glVertex4f", 1),   call("glEnd", 1),      call("glBegin", 0, {1}),
                                  call("glVertex3f", 0),   call("glEnd", 0)};
    EXPECT_EQ(checks::capture_json(calls),
              R"([{"name":"glBegin","list_depth":1,"arguments":[4],"vertices":2},)"
              R"({"name":"glBegin","list_depth":0,"arguments":[1]},)"
              R"({"name":"glVertex3f","list_depth":0,"arguments":[]},)"
              R"({"name":"glEnd","list_depth":0,"arguments":[]}])");
}

TEST(CaptureJson, WritesNumbersThatJsonHasNotAsNull)
{
    const LegacyGLCall calls[] = {call(
        "f", 0, {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e300})};
    EXPECT_NE(checks::capture_json(calls).find("[null,null,null]"), std::string::npos);
}

TEST(TaskJson, HasNullUntilATaskIsChecked)
{
    const std::string json = checks::task_json("1.3", {});
    EXPECT_NE(json.find(R"("id":"1.3")"), std::string::npos) << json;
    EXPECT_NE(json.find(R"("link":"task=1.3")"), std::string::npos) << json;
    EXPECT_NE(json.find(R"("passed":null,"evidence":[])"), std::string::npos) << json;
}

TEST(TaskJson, HasWhatTheCheckFound)
{
    checks::CheckResults results;
    checks::remember(results, {"1.3", true, {"All is well."}});
    checks::remember(results, {"1.3", false, {"A \"wheel\" is lost."}});
    EXPECT_NE(checks::task_json("1.3", results).find(R"("passed":false,"evidence":["A \"wheel\" is lost."])"),
              std::string::npos);
    EXPECT_NE(checks::tasks_json(results).find(R"("passed":false)"), std::string::npos);
}

TEST(TaskJson, OfAFigureHasNoVerdict)
{
    const std::string json = checks::task_json("5b", {});
    EXPECT_NE(json.find(R"("kind":"figure")"), std::string::npos) << json;
    EXPECT_NE(json.find(R"("passed":null)"), std::string::npos) << json;
}

TEST(TaskJson, OfAnUnknownTaskIsNull)
{
    EXPECT_EQ(checks::task_json("9.9", {}), "null");
}

} // namespace
