// Verdicts and findings in the forms that CI services show: JUnit's XML, SARIF, and the annotations
// of GitHub.
#pragma once

#include <string>
#include <vector>

namespace cosim::ci {

/// One thing that was checked.
struct Verdict {
  enum class End { passed, failure, error };

  std::string name;
  End end = End::passed;
  std::string type{};  ///< of a failure or an error, a word
  std::string text{};  ///< lines: the first is its message
  double seconds = 0;
};

/// What a tool says of a place in a file, or of none.
struct Finding {
  std::string tool, rule;
  bool is_error = false;
  std::string file;  ///< empty: of no file
  int line = 0;      ///< from 1 on; 0: of no line
  std::string text;  ///< one line
};

/// One suite of these tests. What XML cannot hold becomes "?".
std::string junit_text(const std::string& suite, const std::vector<Verdict>& all);

/// A log of SARIF 2.1.0 with a run for each tool, also of `tools` that found nothing.
std::string sarif_text(const std::vector<std::string>& tools, const std::vector<Finding>& all);

/// The line that GitHub shows in a list of the run's errors and warnings; of a finding, at its
/// file.
std::string annotation(const std::string& suite, const Verdict& verdict);
std::string annotation(const Finding& finding);

/// Whether this is a run of GitHub's, whose log it reads: GITHUB_ACTIONS is true.
bool is_on_github();

/// The findings in what Verilator, Icarus Verilog or yosys prints, a line each; a line that names
/// no place and no level belongs to the one before it.
std::vector<Finding> findings_in(const std::string& tool, const std::string& text);

}  // namespace cosim::ci
