#include "tb/sim/model_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "model/core/input_error.h"
#include "tb/dut/counts.h"
#include "tb/util/json.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tb/util/scratch.h"
#include "tb/util/words.h"

namespace cosim::coverage {
namespace {

namespace fs = std::filesystem;

struct Line {
  std::uint64_t hits = 0;
  bool is_condition = false;
  std::array<std::uint64_t, 2> branches{};  // hits of each
};

// What gcov prints of the counters, which are dumped into a folder of their own.
Json read_counters(const Counted& counted) {
  const Scratch scratch;
  setenv("GCOV_PREFIX", scratch.path().c_str(), 1);
  setenv("GCOV_PREFIX_STRIP", "1000", 1);
  counted.dump();
  const fs::directory_iterator dumped(scratch.path());  // one file has counters
  if (dumped == fs::directory_iterator()) throw InputError("the program has no counters");
  fs::path notes = dumped->path();
  fs::copy_file(counted.notes, notes.replace_extension(".gcno"));
  const Ended ended =
      run_program({counted.gcov, "--json-format", "--stdout", "--branch-probabilities", notes});
  const std::size_t begin = ended.text.find('{');
  if (ended.status != 0 || begin == std::string::npos) {
    throw InputError(fmt::format("{} does not read what the program counted: {}", counted.gcov,
                                 one_line(ended.text)));
  }
  return json_of(ended.text.substr(begin, ended.text.find('\n', begin) - begin));
}

// A condition that the compiler made two branches of: one of `&&`, or of a loop, has others.
void add_branches(Line& line, const Json& branches) {
  std::vector<std::uint64_t> taken;
  for (const Json& branch : branches) {
    if (!branch.at("throw").get<bool>()) taken.push_back(branch.at("count"));
  }
  if (taken.size() != 2) return;
  line.is_condition = true;
  for (std::size_t i = 0; i < 2; ++i) line.branches[i] += taken[i];
}

}  // namespace

void leave_lines(const Counted& counted, const std::string& design) {
  const auto is_within = [](const std::string& path, const std::string& folder) {
    return path.starts_with(folder + '/');
  };
  std::vector<Count> counts;
  const Json counters = read_counters(counted);
  for (const Json& file : counters.at("files")) {
    const std::string path = file.at("file");
    if (!is_within(path, counted.sources) || is_within(path, counted.build)) continue;
    std::set<std::string> ran;
    for (const Json& one : file.at("functions")) {
      if (one.at("execution_count") != 0) ran.insert(one.at("name"));
    }
    std::map<std::size_t, Line> lines;  // a template has each of its lines several times
    for (const Json& one : file.at("lines")) {
      if (!one.contains("function_name") || !ran.contains(one.at("function_name"))) continue;
      Line& line = lines[one.at("line_number")];
      line.hits += one.at("count").get<std::uint64_t>();
      add_branches(line, one.at("branches"));
    }
    const auto texts = lines_in(read_file(path));
    for (const auto& [number, line] : lines) {
      std::string text;
      if (number <= texts.size())
        text = fmt::format("{}", fmt::join(words_in(texts[number - 1]), " "));
      if (text.ends_with(':')) continue;  // a label
      const std::string place = fmt::format("{}\t{}\t{}", path, number, text);
      const auto add = [&](const char* kind, std::uint64_t hits) {
        counts.push_back({kind + ('\t' + place), hits});
      };
      add("line", line.hits);
      const bool is_condition =
          line.is_condition && (text.find("if (") != text.npos || text.find(" ? ") != text.npos);
      if (is_condition && line.hits != 0) add("condition", std::ranges::min(line.branches));
    }
  }
  if (!counts.empty()) leave("ways", design, counts);
}

}  // namespace cosim::coverage
