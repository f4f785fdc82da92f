// What a command tells a CI service: a verdict of each thing that it checked.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "tb/cli/common.h"
#include "tb/sim/ci.h"
#include "tb/sim/report.h"

namespace cosim::cli {

class Verdicts {
 public:
  /// `command`: its name, "sweep".
  Verdicts(const std::string& command, const Common& common);
  /// The seconds are those since the one before it, where it has none of its own.
  void add(ci::Verdict one);
  /// That of a run, in which nothing may be compared if `allows_nothing`.
  void add(const Outcome& outcome, bool allows_nothing, double seconds = 0);
  /// Writes all into the file of --junit, and, in a run of GitHub's, prints what failed as
  /// annotations.
  void write() const;

 private:
  std::string suite_;
  Text file_;
  std::vector<ci::Verdict> all_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// --junit.
void add_junit(const Command& command, Common& common);

/// Checks where `common` has outputs, runs a command that adds its verdicts, and writes them. An
/// InputError is one, too, of the name `subject`.
int with_verdicts(const std::string& command, const std::string& subject, const Common& common,
                  const std::function<int(Verdicts&)>& run);

}  // namespace cosim::cli
