// pairs SEED FOLDER [CLOCKS [CSV]]
//
// Writes a pair of RTLs: gold.v or gold.sv, gate.v or gate.sv; `options`, what cosim equiv needs of
// them; `planted`, the change in the gate, or nothing; tb.v, a testbench that prints the outputs of
// either on each clock; and `stimulus`, which it reads: CLOCKS of it by chance, or those of CSV, a
// stimulus.csv.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "tests/pairs/write.h"

namespace cosim::pairs {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

/// The pins that are driven, in their order: clocks, resets, inputs.
std::vector<Signal> pins(const Design& design) {
  std::vector<Signal> all;
  for (const Clock& clock : design.clocks) all.push_back({clock.name, {}, 0, false, true, ""});
  all.insert(all.end(), design.resets.begin(), design.resets.end());
  all.insert(all.end(), design.inputs.begin(), design.inputs.end());
  return all;
}

// All clocks that have an edge on a step have it at once; before it the outputs are looked at.
std::string testbench(const Design& design) {
  std::string text = "module tb;\n", connections, values, formats, together;
  const std::size_t clocks = design.clocks.size();
  for (std::size_t i = 0; i < clocks; ++i) {
    const Clock& clock = design.clocks[i];
    text += "  reg " + clock.name + " = " + (clock.falls ? "1" : "0") + ";\n";
    connections += "." + clock.name + '(' + clock.name + "), ";
  }
  for (const Signal& s : pins(design)) {
    if (together.empty() && s.name == design.clocks[0].name) together = "edges";
    const bool is_clock = std::any_of(design.clocks.begin(), design.clocks.end(),
                                      [&](const Clock& clock) { return clock.name == s.name; });
    if (is_clock) continue;
    text += "  reg " + range(s) + s.name + ";\n";
    connections += "." + s.name + '(' + s.name + "), ";
    together += ", " + s.name;
  }
  for (const Item& item : design.items) {
    if (!item.is_output) continue;
    text += "  wire " + range(item.target) + item.target.name + ";\n";
    connections += "." + item.target.name + '(' + item.target.name + "), ";
    formats += " %b";
    values += ", " + item.target.name;
  }
  connections.resize(connections.size() - 2);
  int width = 0;
  for (const Signal& s : pins(design)) width += s.type.width;
  text += "  t dut(" + connections + ");\n  reg " + range(static_cast<int>(clocks)) +
          "edges;\n  reg " + range(width) + "all;\n  integer file, clock;\n  initial begin\n" +
          "    file = $fopen(\"stimulus\", \"r\");\n    clock = 0;\n" +
          "    while ($fscanf(file, \"%b\", all) == 1) begin\n      {" + together +
          "} = all;\n      #1;\n";
  const std::string shown = design.resets.empty() ? "" : "if (clock >= 3) ";
  text += "      " + shown + "$display(\"" + formats.substr(1) + '"' + values + ");\n";
  for (const bool back : {false, true}) {
    text += "      #1;\n";
    for (std::size_t i = 0; i < clocks; ++i) {
      const std::string bit =
          clocks == 1 ? "edges" : "edges[" + std::to_string(clocks - 1 - i) + ']';
      text += "      if (" + bit + ") " + design.clocks[i].name + " = " +
              (design.clocks[i].falls == back ? "1" : "0") + ";\n";
    }
  }
  text += "      clock = clock + 1;\n    end\n    $finish(0);\n  end\nendmodule\n";
  return text;
}

std::string stimulus(const Design& design, Random& random, int clocks) {
  std::string text;
  std::string before;
  for (int k = 0; k < clocks; ++k) {
    std::string line;
    const bool many = random.percent(70);
    for (std::size_t i = 0; i < design.clocks.size(); ++i)
      line += k < 3 || many || random.percent(50) ? '1' : '0';
    for (const Signal& s : design.resets) {
      const bool resets = k < 3 || random.percent(4);
      line += resets != s.name.ends_with("_n") ? '1' : '0';
    }
    for (const Signal& s : design.inputs) {
      // Often as before, or with one bit changed.
      std::string bits = random.bits(s.type.width);
      const std::size_t width = bits.size();
      if (k > 0 && random.percent(40)) bits = before.substr(line.size(), width);
      if (random.percent(30)) {
        char& bit = bits[static_cast<std::size_t>(random.below(static_cast<int>(width)))];
        bit = bit == '0' ? '1' : '0';
      }
      line += bits;
    }
    before = line;
    text += line + '\n';
  }
  return text;
}

// Its columns are named.
std::string replayed(const Design& design, const std::string& csv) {
  std::ifstream in(csv);
  std::string line, cell, text;
  std::vector<std::string> names;
  while (std::getline(in, line)) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    while (std::getline(row, cell, ',')) cells.push_back(cell);
    if (names.empty()) {
      names = cells;
      continue;
    }
    for (const Signal& s : pins(design)) {
      const auto at = std::find(names.begin(), names.end(), s.name) - names.begin();
      const bool is_there = static_cast<std::size_t>(at) < cells.size();
      text += is_there ? cells[static_cast<std::size_t>(at)]
                       : std::string(static_cast<std::size_t>(s.type.width), '1');
    }
    text += '\n';
  }
  return text;
}

int run(const std::vector<std::string>& words) {
  const std::uint64_t seed = std::stoull(words.at(0));
  const fs::path folder = words.at(1);
  const int clocks = words.size() > 2 ? std::stoi(words[2]) : 3000;
  Random random(seed * 2654435761U + 17);
  const bool is_sv = random.percent(35), is_planted = random.percent(50);
  const Design gold = random_design(random, is_sv);
  Design gate = gold;
  // One that changes something is seen more often of two.
  std::string planted = is_planted ? plant(gate, random) : "";
  if (is_planted) planted += "; " + plant(gate, random);
  const Written old_rtl = write_rtl(gold, random, false), new_rtl = write_rtl(gate, random, true);
  const std::string suffix = is_sv ? ".sv" : ".v";
  fs::create_directories(folder);
  write(folder / ("gold" + suffix), old_rtl.text);
  write(folder / ("gate" + suffix), new_rtl.text);
  for (const Written* one : {&old_rtl, &new_rtl}) {
    for (const auto& [name, text] : one->files) write(folder / name, text);
  }
  write(folder / "planted", planted.empty() ? "" : planted + '\n');
  std::string options = "--gold gold" + suffix + " --gate gate" + suffix + " --top t";
  for (const Signal& s : gold.resets)
    options += " --reset " + s.name + (s.name.ends_with("_n") ? "=0" : "");
  write(folder / "options", options + '\n');
  write(folder / "tb.v", testbench(gold));
  Random chance(seed + static_cast<std::uint64_t>(clocks) * 1000003U);
  write(folder / "stimulus",
        words.size() > 3 ? replayed(gold, words[3]) : stimulus(gold, chance, clocks));
  return 0;
}

}  // namespace
}  // namespace cosim::pairs

int main(int argc, char** argv) {
  try {
    return cosim::pairs::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "pairs: needs SEED FOLDER [CLOCKS [CSV]]: " << error.what() << '\n';
    return 2;
  }
}
