// Nothing is left out of the comparison: the RTL's flip-flops, as Yosys finds them, are exactly the
// registers in the design's table.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/support/root.h"
#include "tests/tb/shape.h"

namespace cosim::test {
namespace {

namespace fs = std::filesystem;
using Param = const AnyBench*;

// The bits of a synthesised design that are flip-flops: all of them, and those of each net, by its
// path.
struct FlipFlops {
  int bits = 0;
  std::map<std::string, int> named;
};

FlipFlops synthesised(const AnyBench& bench, const fs::path& folder) {
  const fs::path json = folder / "netlist.json";
  std::string parameters;
  for (const Parameter& p : bench.parameters()) {
    parameters += " -chparam " + std::string(p.name) + " " + std::to_string(p.value);
  }
  const std::string command = "cd '" + (project_root() / "rtl" / bench.design()).string() +
                              "' && yosys -q -p 'read_verilog *.v; hierarchy -check -top " +
                              bench.design() + parameters +
                              "; proc; flatten; opt_clean; write_json \"" + json.string() + "\"'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  const auto modules = nlohmann::json::parse(std::ifstream(json))["modules"];
  EXPECT_EQ(modules.size(), 1U);
  const auto& module = modules.front();

  std::set<nlohmann::json> driven;
  for (const auto& cell : module["cells"]) {
    const std::string type = cell["type"];
    EXPECT_EQ(type.find("latch"), std::string::npos) << type;
    EXPECT_EQ(type.find("mem"), std::string::npos) << type;
    if (type.find("ff") == std::string::npos) continue;
    for (const auto& bit : cell["connections"]["Q"]) driven.insert(bit);
  }
  FlipFlops found{static_cast<int>(driven.size()), {}};
  for (const auto& [name, net] : module["netnames"].items()) {
    for (const auto& bit : net["bits"]) found.named[name] += driven.count(bit) != 0;
  }
  return found;
}

class Registers : public testing::TestWithParam<Param> {};
TEST_P(Registers, AreTheFlipFlopsOfTheRtl) {
  if (std::system("yosys -V > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no yosys";
  const fs::path folder = fs::path(testing::TempDir()) /
                          ("registers_" + shape_name(*GetParam()) + std::to_string(getpid()));
  fs::create_directories(folder);
  FlipFlops found = synthesised(*GetParam(), folder);
  fs::remove_all(folder);

  int bits = 0;
  const std::vector<Field> compared = GetParam()->compared();
  for (std::size_t i = 0; i < GetParam()->registers(); ++i) {
    EXPECT_EQ(found.named[compared[i].net], compared[i].width) << compared[i].net;
    bits += compared[i].width;
  }
  EXPECT_EQ(found.bits, bits);
}
INSTANTIATE_TEST_SUITE_P(Yosys, Registers, testing::ValuesIn(all_benches()), name_of_bench);

}  // namespace
}  // namespace cosim::test
