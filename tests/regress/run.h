// A small regression in a folder, and the program that runs it.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace cosim::cli {

using Json = nlohmann::json;

class Regression : public testing::Test {
 protected:
  /// The arguments of a new run in the folder's `name`.
  Arguments fresh(const std::string& name, const Arguments& more = {}) const {
    return cli::joined({"regress", folder_.path("plan.json"), "--folder", folder_.path(name)},
                       more);
  }
  Arguments resumed(const std::string& name) const {
    return {"regress", "--resume", folder_.path(name)};
  }
  std::string report(const std::string& name) const { return folder_.text(name + "/report.json"); }
  nlohmann::json times(const std::string& name) const {
    return nlohmann::json::parse(folder_.text(name + "/times.json"));
  }
  /// All that the hosts of a run wrote.
  std::string results_of(const std::string& name) const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path(name + "/results"))) {
      return "results/" + entry.path().filename().string();
    }
    return "results";
  }
  void plan(const std::string& tasks) const {
    folder_.write("plan.json",
                  R"({"format": 1, "name": "small", "seed": 7, "tasks": [)" + tasks + "]}");
  }

  test::Folder folder_;
};

}  // namespace cosim::cli
