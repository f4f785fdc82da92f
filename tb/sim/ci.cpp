#include "tb/sim/ci.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "tb/util/json.h"
#include "tb/util/markup.h"
#include "tb/util/pattern.h"
#include "tb/util/words.h"

namespace cosim::ci {
namespace {

using End = Verdict::End;

std::string junit_case(const std::string& suite, const Verdict& one) {
  std::string lines;
  for (const std::string& line : lines_in(one.text)) lines += markup(one_line(line)) + '\n';
  std::string inner = fmt::format("<system-out>{}</system-out>", lines);
  if (one.end != End::passed) {
    inner = fmt::format("<{0} type=\"{1}\" message=\"{2}\">{3}</{0}>",
                        one.end == End::failure ? "failure" : "error", markup(one_line(one.type)),
                        lines.substr(0, lines.find('\n')), lines);
  }
  return fmt::format("<testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">{}</testcase>\n",
                     suite, markup(one_line(one.name)), one.seconds, inner);
}

// A text as a line of GitHub's takes it: as a value of a property, or behind them.
std::string escaped(std::string_view text, bool is_property) {
  std::string safe;
  for (const char c : text) {
    const bool is_special = c == '%' || c == '\r' || c == '\n';
    if (is_special || (is_property && (c == ':' || c == ','))) {
      safe += fmt::format("%{:02X}", static_cast<unsigned>(c));
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace

std::string junit_text(const std::string& suite, const std::vector<Verdict>& all) {
  const auto ends = [&](End end) { return std::ranges::count(all, end, &Verdict::end); };
  const std::string name = markup(one_line(suite));
  double seconds = 0;
  std::string cases;
  for (const Verdict& one : all) {
    seconds += one.seconds;
    cases += junit_case(name, one);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\" "
      "time=\"{:.3f}\">\n{}</testsuite>\n",
      name, all.size(), ends(End::failure), ends(End::error), seconds, cases);
}

std::string sarif_text(const std::vector<std::string>& tools, const std::vector<Finding>& all) {
  Json runs = Json::array();
  for (const std::string& tool : tools) {
    Json results = Json::array();
    for (const Finding& one : all) {
      if (one.tool != tool) continue;
      Json result{{"level", one.is_error ? "error" : "warning"},
                  {"message", {{"text", one_line(one.text)}}}};
      if (!one.rule.empty()) result["ruleId"] = one_line(one.rule);
      if (!one.file.empty()) {
        Json place{{"artifactLocation", {{"uri", one_line(one.file)}}}};
        if (one.line > 0) place["region"] = {{"startLine", one.line}};
        result["locations"] = Json::array({{{"physicalLocation", place}}});
      }
      results.push_back(result);
    }
    runs.push_back({{"tool", {{"driver", {{"name", tool}}}}}, {"results", results}});
  }
  return json_text({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                    {"version", "2.1.0"},
                    {"runs", runs}},
                   1) +
         '\n';
}

std::string annotation(const std::string& suite, const Verdict& verdict) {
  return fmt::format(
      "::error title={}::{}\n", escaped(suite + ": " + verdict.name, true),
      escaped(verdict.text.substr(0, verdict.text.find_last_not_of('\n') + 1), false));
}

std::string annotation(const Finding& finding) {
  std::string place;
  if (!finding.file.empty()) place += ",file=" + escaped(finding.file, true);
  if (finding.line > 0) place += fmt::format(",line={}", finding.line);
  return fmt::format("::{} title={}{}::{}\n", finding.is_error ? "error" : "warning",
                     escaped(finding.tool, true), place, escaped(finding.text, false));
}

bool is_on_github() {
  const char* const value = std::getenv("GITHUB_ACTIONS");
  return value != nullptr && std::string_view(value) == "true";
}

std::vector<Finding> findings_in(const std::string& tool, const std::string& text) {
  // %Warning-WIDTHTRUNC: a.v:12:3: ...   a.v:12: warning: ...   a.v:12: syntax error
  static const Pattern verilator(
      "%(Warning|Error)(-([A-Z0-9_]+))?: (([^:]+):([0-9]+):([0-9]+:)?)? ?(.*)");
  static const Pattern others("([^: ][^:]*):([0-9]+): (.*)");
  static const Pattern without("(ERROR|Warning|warning|error): (.*)");
  std::vector<Finding> all;
  for (const std::string& line : lines_in(text)) {
    if (const auto part = verilator.whole(line); !part.empty()) {
      if (part[8].starts_with("Exiting due to")) continue;
      const int number = part[6].empty() ? 0 : std::atoi(part[6].c_str());
      all.push_back({tool, part[3], part[1] == "Error", part[5], number, part[8]});
    } else if (const auto at = others.whole(line); !at.empty()) {
      const bool is_warning = at[3].starts_with("warning");
      all.push_back({tool, "", !is_warning, at[1], std::atoi(at[2].c_str()), at[3]});
    } else if (const auto said = without.whole(line); !said.empty()) {
      all.push_back({tool, "", said[1] == "ERROR" || said[1] == "error", "", 0, said[2]});
    }
  }
  const bool is_empty = text.find_first_not_of(" \n") == std::string::npos;
  if (all.empty() && !is_empty) all.push_back({tool, "", true, "", 0, lines_in(text).front()});
  return all;
}

}  // namespace cosim::ci
