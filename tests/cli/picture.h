// What an SVG of --plot shows, read back.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tb/util/pattern.h"
#include "tests/cli/program.h"

namespace cosim::cli {

inline bool can_plot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

/// A dot: pixels to the right and down, and its colour as "r,g,b".
struct Dot {
  double x = 0;
  double y = 0;
  std::string colour;
};

class Picture {
 public:
  /// Of the command, which has to match.
  explicit Picture(Arguments command) {
    const Folder folder;
    command.insert(command.end(), {"--plot", folder.path("a.svg")});
    ends(0, cosim(command));
    svg_ = folder.text("a.svg");
  }

  bool has(const std::string& text) const { return svg_.find(text) != std::string::npos; }

  /// The dots of a path, or those below its bars; panels count from 0.
  std::vector<Dot> path(int panel) const { return dots("$spots" + std::to_string(panel)); }
  std::vector<Dot> bars(int panel) const { return dots("$bars" + std::to_string(panel)); }
  /// The corners of the curve in the first panel.
  std::vector<Dot> curve() const {
    static const Pattern corner(R"(([\d.]+),([\d.]+))");
    const std::size_t at = svg_.find(" d='", svg_.find("<title>$ideal "));
    const std::string line = svg_.substr(at, svg_.find("'/>", at) - at);
    std::vector<Dot> found;
    for (const auto& one : corner.all(line)) {
      found.push_back({std::stod(one[1]), std::stod(one[2]), ""});
    }
    return found;
  }

 private:
  // Those of what is drawn of `data`: up to the next title.
  std::vector<Dot> dots(const std::string& data) const {
    static const Pattern dot(
        R"(<use [^>]*translate\(([\d.]+),([\d.]+)\)[^>]*color='rgb\( *(\d+), *(\d+), *(\d+)\)')");
    std::vector<Dot> found;
    for (std::size_t at = svg_.find("<title>" + data + " "); at != std::string::npos;
         at = svg_.find("<title>" + data + " ", at + 1)) {
      const std::string group = svg_.substr(at, svg_.find("<title>", at + 1) - at);
      for (const auto& m : dot.all(group)) {
        found.push_back({std::stod(m[1]), std::stod(m[2]), m[3] + "," + m[4] + "," + m[5]});
      }
    }
    return found;
  }

  std::string svg_;
};

}  // namespace cosim::cli
