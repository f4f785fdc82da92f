// mutants_table OUT RESULTS...: prints the outcomes of several runs as a table, those of one shape
// in one row; writes all results to OUT, a JSON array. Status: 0
// none survived, 1 some did, 2 bad input.
#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <map>
#include <vector>

#include "tb/support/json.h"
#include "tb/support/json_at.h"
#include "tb/support/read_file.h"
#include "tb/support/replace_file.h"

namespace {

using cosim::Json;
using cosim::JsonAt;

struct Row {
  std::size_t mutants = 0, killed = 0, equivalent = 0, survived = 0;
  double seconds = 0;
};

std::string shape_of(const JsonAt& results) {
  std::string text;
  for (const auto& [name, value] : results.at("parameters").json().items()) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, cosim::json_ascii(value));
  }
  return text;
}

int run(const std::string& out, const std::vector<std::string>& paths) {
  Json all = Json::array();
  std::vector<std::string> order;
  std::map<std::string, Row> rows;
  std::size_t survived = 0;
  for (const std::string& path : paths) {
    const JsonAt results(path, cosim::read_file(path));
    all.push_back(results.json());
    const std::string name =
        fmt::format("| {} | {} |", results.at("design").text(), shape_of(results));
    if (!rows.contains(name)) order.push_back(name);
    Row& row = rows[name];
    row.mutants += results.at("mutants").whole();
    row.killed += results.at("killed").whole();
    row.equivalent += results.at("equivalent").whole();
    row.survived += results.at("survived").whole();
    row.seconds += results.at("seconds").number(0, 1e9);
    survived += results.at("survived").whole();
  }
  fmt::print(
      "| design | parameters | mutants | killed | proved equivalent | survived | seconds |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& name : order) {
    const Row& row = rows[name];
    fmt::print("{} {} | {} | {} | {} | {:.0f} |\n", name, row.mutants, row.killed, row.equivalent,
               row.survived, row.seconds);
  }
  cosim::replace_file(out, cosim::json_text(all, 1) + '\n');
  return survived == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "mutants_table: needs a file to write to and results\n");
    return 2;
  }
  try {
    return run(argv[1], {argv + 2, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "mutants_table: {}\n", error.what());
    return 2;
  }
}
