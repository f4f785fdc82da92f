// The ways through clock() as points of coverage, each with its line of the source. Exporter alone.
#pragma once

#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "model/clocked/source_line.h"
#include "model/clocked/ways.h"

namespace cosim::clocked {

struct WayPoint {
  const char* kind;  ///< "way"; "branch": a condition, and what it is
  SourceLine at;     ///< of the condition; of the last one on the way
  /// What that is, its line, and what the conditions before it on the way are, by their lines:
  /// "false: if (in.valid); after 36 false, 38 true".
  std::string what;
  Id holds;
};

class WayPoints {
 public:
  /// Of what ways.join() kept last: its ways, and branches of the blocks of merge(); or, where it
  /// lists no ways, all branches. A function that has one way has none.
  std::vector<WayPoint> all() {
    const std::vector<Way> listed = ways.listed();
    const std::vector<Branch> branches = ways.branches();
    std::vector<const void*> addresses;
    for (const Branch& b : branches) addresses.push_back(b.decision.from);
    lines_ = source_lines(addresses);
    std::vector<WayPoint> points;
    for (const Way& way : listed) {
      if (way.decisions.empty() || is_never(way.holds)) continue;
      const Decision& last = way.decisions.back();
      points.push_back({"way", lines_[last.from], words(last) + before(way), way.holds});
    }
    // A line that is compiled twice, in a loop say, is one.
    std::map<std::tuple<std::string, int, bool>, WayPoint> by_line;
    for (const Branch& b : branches) {
      if ((!listed.empty() && !b.is_in_block) || is_never(b.holds)) continue;
      const SourceLine& at = lines_[b.decision.from];
      const auto [place, is_new] = by_line.try_emplace(
          {at.path, at.line, b.decision.yes}, WayPoint{"branch", at, words(b.decision), b.holds});
      Id& holds = place->second.holds;
      if (!is_new) holds = graph.make(Op::bor, 1, holds, b.holds);
    }
    for (const auto& [line, point] : by_line) points.push_back(point);
    return points;
  }

 private:
  static bool is_never(Id holds) {
    const Wide* value = graph.known(holds);
    return value != nullptr && *value == Wide(0);
  }
  static const char* word(bool yes) { return yes ? "true" : "false"; }

  std::string words(const Decision& decision) {
    return std::string(word(decision.yes)) + ": " + text(lines_[decision.from]);
  }
  // "; after 36 false, 38 true twice", of another file than the last one's "timer.h:36".
  std::string before(const Way& way) {
    const std::string& path = lines_[way.decisions.back().from].path;
    std::string words;
    const std::size_t last = way.decisions.size() - 1;
    for (std::size_t i = 0; i < last;) {
      const Decision& decision = way.decisions[i];
      const SourceLine& at = lines_[decision.from];
      std::size_t times = 0;
      while (i < last && lines_[way.decisions[i].from].line == at.line &&
             lines_[way.decisions[i].from].path == at.path && way.decisions[i].yes == decision.yes)
        ++i, ++times;
      words += words.empty() ? "; after " : ", ";
      if (at.path != path) words += at.file() + ':';
      words += std::to_string(at.line) + ' ' + word(decision.yes);
      if (times > 1) words += " (" + std::to_string(times) + " times)";
    }
    return words;
  }
  // The line of the source, without the braces around it.
  std::string text(const SourceLine& at) {
    std::vector<std::string>& lines = texts_[at.path];
    if (lines.empty()) {
      std::ifstream file(at.path);
      lines.emplace_back();
      for (std::string line; std::getline(file, line);) lines.push_back(line);
    }
    std::string line = std::size_t(at.line) < lines.size() ? lines[std::size_t(at.line)] : "";
    const std::size_t first = line.find_first_not_of(" \t}");
    line = first == std::string::npos ? "" : line.substr(first);
    line = line.substr(0, line.find_last_not_of(" \t\r{;") + 1);
    for (char& c : line) c = c == '\t' ? ' ' : c;
    constexpr std::size_t most = 80;
    return line.size() > most ? line.substr(0, most - 3) + "..." : line;
  }

  std::map<const void*, SourceLine> lines_;
  std::map<std::string, std::vector<std::string>> texts_;
};

}  // namespace cosim::clocked
