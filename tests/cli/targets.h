// Where a G-code program wants to be after each of its blocks that move X or Y. A reader for tests:
// it trusts its program and knows only what moves X and Y.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace cosim::cli {

/// In millimetres.
struct Target {
  double x = 0;
  double y = 0;
};

inline std::vector<Target> targets_of(const std::string& program) {
  std::vector<Target> targets;
  Target at;
  double unit = 1;
  bool incremental = false, arc = false;
  for (std::string line : lines(program)) {
    while (line.find('(') != std::string::npos) {
      const std::size_t open = line.find('(');
      line.erase(open, line.find(')', open) - open + 1);
    }
    line.resize(std::min(line.size(), line.find(';')));
    bool turns = false, moves = false, ends = false;
    Target words{NAN, NAN};
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (std::isalpha(static_cast<unsigned char>(line[i])) == 0) continue;
      const double value = std::strtod(line.c_str() + i + 1, nullptr);
      const auto code = static_cast<int>(value);
      switch (std::toupper(static_cast<unsigned char>(line[i]))) {
        case 'G':
          if (code == 20) unit = 25.4;
          if (code == 21) unit = 1;
          if (code == 90) incremental = false;
          if (code == 91) incremental = true;
          if (code <= 3) arc = code >= 2;
          break;
        case 'M':
          ends = code == 2 || code == 30;
          break;
        case 'X':
          words.x = value;
          break;
        case 'Y':
          words.y = value;
          break;
        case 'I':
        case 'J':
          turns = true;
          break;
        default:
          break;
      }
    }
    const auto go = [&](double& coordinate, double word) {
      if (std::isnan(word)) return;
      const double reached = word * unit + (incremental ? coordinate : 0);
      moves |= std::abs(reached - coordinate) > 1e-9;
      coordinate = reached;
    };
    go(at.x, words.x);
    go(at.y, words.y);
    if (moves || (arc && turns)) targets.push_back(at);
    if (ends) break;
  }
  return targets;
}

}  // namespace cosim::cli
