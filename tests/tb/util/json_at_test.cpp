// What is read back and is not so is named with its file and its place.
#include "tb/util/json_at.h"

#include <gtest/gtest.h>

#include <functional>

#include "tb/util/json.h"
#include "tests/support/error_of.h"

namespace cosim {
namespace {

const JsonAt plan("run.json", R"({"tasks": [{}, {"units": -1, "name": 7, "yes": 1.5}],
                                  "none": null, "most": 18446744073709551615})");

TEST(JsonAt, NamesTheFileAndThePlace) {
  const JsonAt task = plan.at("tasks").list()[1];
  const auto expect = [](const std::string& said, const std::function<void()>& read) {
    EXPECT_EQ(test::error_of(read), "run.json: " + said);
  };
  expect("tasks[1].units is -1, not a whole number from 1 to 1000",
         [&] { task.at("units").whole(1, 1000); });
  expect("tasks[1].units is -1, not 3", [&] { task.at("units").whole(3, 3); });
  expect("tasks[1].units is -1, not a number from 0 to 2.5",
         [&] { task.at("units").number(0, 2.5); });
  expect("tasks[1].name is 7, not a text", [&] { task.at("name").text(); });
  expect("tasks[1].yes is 1.5, not true or false", [&] { task.at("yes").yes(); });
  expect("tasks[1] has no 'minutes'", [&] { task.at("minutes"); });
  expect("none is null, not a list", [&] { plan.at("none").list(); });
  expect("tasks is a list of 2, not of 3 or more", [&] { plan.at("tasks").list(3); });
  expect("tasks is a list of 2, not of at most 1", [&] { plan.at("tasks").list(0, 1); });
  expect("tasks is a list of 2, not of 5", [&] { plan.at("tasks").list(5, 5); });
  expect("tasks is a list of 2, not an object", [&] { plan.at("tasks").at("x"); });
  expect("it is an object, not a text", [&] { plan.text(); });
}

TEST(JsonAt, GivesWhatIsThere) {
  EXPECT_EQ(plan.at("most").whole(), ~std::uint64_t{0});
  EXPECT_EQ(plan.at("tasks").list(2, 2).size(), 2U);
  EXPECT_FALSE(plan.find("title"));
  EXPECT_EQ(JsonAt("x", R"(["a", "b"])").list()[1].text(), "b");
  EXPECT_TRUE(JsonAt("x", "true").yes());
  EXPECT_EQ(JsonAt("x", "2").number(0, 2), 2);
}

TEST(JsonAt, RefusesWhatIsNoJson) {
  const auto refused = [](const std::string& text) {
    return test::error_of([&] { JsonAt("a.json", text); });
  };
  EXPECT_EQ(refused("{").find("a.json: no JSON: at line 1, column 2: "), 0U) << refused("{");
  EXPECT_EQ(refused("1e999").find("a.json: no JSON: "), 0U) << refused("1e999");
  EXPECT_EQ(refused(R"([{"a": 1, "a": 2}])"), "a.json: 'a': occurs twice in an object");
  const auto nested = [](int levels) {
    const auto size = static_cast<std::size_t>(levels);
    return std::string(size, '[') + std::string(size, ']');
  };
  EXPECT_EQ(refused(nested(most_json_levels)), "");
  EXPECT_EQ(refused(nested(most_json_levels + 1)), "a.json: no JSON, or more than 100 levels deep");
  EXPECT_EQ(refused(nested(1'000'000)), "a.json: no JSON, or more than 100 levels deep");
}

// A terminal is shown no control character.
TEST(JsonAt, IsOneLineOfPrintableText) {
  const JsonAt hostile("a\n.json", R"({"\u001b[2J\n": "x\u001b"})");
  const std::string line = test::error_of([&] { hostile.at("\x1b[2J\n").whole(); });
  EXPECT_EQ(line.find_first_of("\x1b\n"), std::string::npos) << line;
}

}  // namespace
}  // namespace cosim
