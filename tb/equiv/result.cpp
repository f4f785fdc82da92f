#include "tb/equiv/result.h"

#include <fmt/format.h>

#include <set>

#include "tb/equiv/clocks.h"
#include "tb/sim/page.h"
#include "tb/util/draft.h"
#include "tb/util/json.h"
#include "tb/util/quoted.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

std::string clocks_text(std::size_t clocks) {
  return count(static_cast<std::uint64_t>(clocks), "clock");
}

const char* word_of(Verdict verdict) {
  return verdict == Verdict::equal       ? "equal"
         : verdict == Verdict::different ? "different"
                                         : "undecided";
}

// A binary number, short.
std::string hexadecimal(const std::string& binary) {
  if (binary.size() <= 3) return std::to_string(std::stoi(binary, nullptr, 2));
  std::string digits;
  for (std::size_t end = binary.size(), begin = 0; end > 0; end = begin) {
    begin = end > 4 ? end - 4 : 0;
    digits.insert(0, fmt::format("{:x}", std::stoi(binary.substr(begin, end - begin), nullptr, 2)));
  }
  return "0x" + digits;
}

// "q 1 clock later, r 2 clocks earlier"
std::string late_text(const Answer& a) {
  std::string text;
  for (const Late& late : a.late) {
    const bool is_later = late.clocks > 0;
    const int clocks = is_later ? late.clocks : -late.clocks;
    text +=
        fmt::format("{}{} {} {}", text.empty() ? "" : ", ", late.port,
                    clocks_text(static_cast<std::size_t>(clocks)), is_later ? "later" : "earlier");
  }
  return text;
}

// A name in a line whose parts commas separate.
std::string in_csv(std::string name) {
  if (name.find_first_of(",\"") == std::string::npos) return name;
  for (std::size_t at = 0; (at = name.find('"', at)) != std::string::npos; at += 2) {
    name.insert(at, 1, '"');
  }
  return '"' + name + '"';
}

std::string csv_of(const Answer& a) {
  const Row& last = a.clocks.back();
  std::string csv = "clock";
  for (const auto& [port, text] : last.inputs) csv += "," + in_csv(port);
  for (const auto& [port, text] : last.gold) {
    csv += fmt::format(",{},{}", in_csv("old " + port), in_csv("new " + port));
  }
  for (std::size_t i = 0; i < a.clocks.size(); ++i) {
    csv += fmt::format("\n{}", i);
    for (const auto& [port, text] : a.clocks[i].inputs) csv += "," + text;
    for (const auto& [port, text] : a.clocks[i].gold) {
      csv += fmt::format(",{},{}", text, a.clocks[i].gate.at(port));
    }
  }
  return csv + "\n";
}

Json check_json(const Answer& a) {
  if (!a.check) return nullptr;
  return {{"by", a.check->is_checked ? "cadical" : ""},
          {"missing", a.check->missing},
          {"equalities", a.check->equalities},
          {"clauses", a.check->clauses}};
}

// "the old RTL: read by yosys, as Icarus Verilog simulates it, on 2048 clocks; the new RTL: ..."
std::string read_text(const Question& q, const Answer& a) {
  std::string text;
  for (const auto& [side, trusted] :
       {std::pair(&q.gold, &a.gold_read), std::pair(&q.gate, &a.gate_read)}) {
    if (trusted->is.by.empty()) continue;
    text +=
        fmt::format("{}{}: read by {}, {} {} simulates it, on {}", text.empty() ? "" : "; ",
                    side->what(), name_of(trusted->front_end), trusted->is.agrees ? "as" : "not as",
                    trusted->is.by, clocks_text(static_cast<std::size_t>(trusted->is.clocks)));
  }
  return text;
}

std::string renamed_text(const Answer& a) {
  constexpr std::size_t most = 3;
  std::string text;
  std::size_t n = 0;
  for (const auto& [old_name, new_name] : a.renamed) {
    if (n++ < most) text += fmt::format("{}{} is {}", text.empty() ? "" : ", ", old_name, new_name);
  }
  if (n > most) text += fmt::format(", and {} more", n - most);
  return text;
}

std::string decided_text(const std::string& top, const Answer& a) {
  if (a.verdict == Verdict::equal) {
    return fmt::format("{}: equal for ever, by {}{}\n", top, a.by,
                       a.check ? "; " + to_text(*a.check) : "");
  }
  if (a.verdict == Verdict::undecided) {
    const std::string first =
        "equal for the first " + clocks_text(static_cast<std::size_t>(a.compared));
    return fmt::format("{}: undecided: {}{}\n", top,
                       a.compared > 0 || a.left.empty() ? first + "; " : "",
                       a.left.empty() ? "more is not known" : a.left);
  }
  const Row& last = a.clocks.back();
  std::string list;
  for (const std::string& port : a.differing) {
    list += fmt::format("{} {} is {}, was {}", list.empty() ? "" : ",", port, last.gate.at(port),
                        last.gold.at(port));
  }
  std::string text =
      fmt::format("{}: different on clock {}{}:{}; replayed {}\n", top, a.clocks.size() - 1,
                  a.least ? ", the first that can be" : "", list, a.replayed);
  if (!a.late.empty()) {
    text += fmt::format(
        "only the time differs on these clocks: the values in their order are the same, in the new "
        "{}\n",
        late_text(a));
  }
  return text;
}

Page page(const std::string& top, const Question& q, const Answer& a) {
  Page page;
  page.title = top;
  page.verdict = {word_of(a.verdict),
                  a.verdict == Verdict::equal       ? "good"
                  : a.verdict == Verdict::different ? "bad"
                                                    : "none",
                  verdict_text(top, q, a), assumed_text(q) + '\n'};
  return page;
}

}  // namespace

std::string assumed_text(const Question& q) {
  std::string text = q.resets ? "no reset: from the initial values" : "from any state";
  if (q.resets && !q.resets->empty()) {
    std::string list;
    for (const auto& [pin, level] : *q.resets) {
      list += fmt::format("{}{} is {}", list.empty() ? "" : " and ", pin, level ? 1 : 0);
    }
    text = fmt::format("from reset: {} for {}", list,
                       clocks_text(static_cast<std::size_t>(q.reset_clocks)));
  }
  if (q.steps) {
    std::set<std::string> clocks;
    for (const auto& [clock, falls] : q.gold.clocks) clocks.insert(clock);
    for (const auto& [clock, falls] : q.gate.clocks) clocks.insert(gold_name(q, clock));
    text += fmt::format("; clocks that have their edges on any steps, counted as clocks: {}",
                        fmt::join(clocks, ", "));
  }
  std::set<std::string> any;
  for (const Side* s : {&q.gold, &q.gate}) {
    for (const Register& r : s->registers) {
      if (r.any) any.insert(r.name.first);
    }
  }
  if (!any.empty()) {
    text += fmt::format("; {} without an initial value, which may begin with any",
                        count(any.size(), "register"));
  }
  for (const auto& [pin, value] : q.tied)
    text += fmt::format("; {} is {}", pin, hexadecimal(value));
  for (const std::string& pin : q.ignored) text += fmt::format("; {} is not compared", pin);
  for (const Assumption& one : q.assumed) text += "; assumed: " + one_line(one.text);
  if (q.latency > 0) {
    text += fmt::format("; the new outputs come {} later",
                        clocks_text(static_cast<std::size_t>(q.latency)));
  }
  return text;
}

std::string verdict_text(const std::string& top, const Question& q, const Answer& a) {
  const std::string read = read_text(q, a);
  const std::string renamed = renamed_text(a);
  return (read.empty() ? "" : read + '\n') +
         (renamed.empty() ? "" : "registers by other names in the new RTL: " + renamed + '\n') +
         decided_text(top, a);
}

std::string result_json(const std::string& top, const Question& q, const Answer& a) {
  Json clocks = Json::array();
  for (const Row& row : a.clocks) {
    clocks.push_back({{"inputs", row.inputs}, {"old", row.gold}, {"new", row.gate}});
  }
  Json assumptions = Json::array();
  for (const Assumption& one : q.assumed) assumptions.push_back(one.text);
  Json late = Json::object();
  for (const Late& one : a.late) late[one.port] = one.clocks;
  const Json json{{"top", top},
                  {"verdict", word_of(a.verdict)},
                  {"by", a.by},
                  {"check", check_json(a)},
                  {"replayed", a.replayed},
                  {"assumed", assumed_text(q)},
                  {"assumptions", assumptions},
                  {"read", read_text(q, a)},
                  {"registers_by_name", a.matched},
                  {"registers_renamed", a.renamed},
                  {"stimulus", clocks},
                  {"least", a.least},
                  {"differing", a.differing},
                  {"only_the_time_differs", !a.late.empty()},
                  {"later", late},
                  {"left", a.left},
                  {"equal_clocks", a.compared}};
  return json_text(json, 2) + "\n";
}

std::string page_of(const std::string& top, const Question& q, const Answer& a) {
  return page_text(page(top, q, a));
}

std::filesystem::path folder_of(const std::string& top, const std::filesystem::path& root) {
  return root / (top + "-equiv");
}

Kept keep(const std::string& top, const Question& q, const Answer& a,
          const std::filesystem::path& root, std::uint64_t after) {
  Draft draft(root, folder_of(top, root).filename());
  Kept kept{draft.target(), ""};
  draft.write("report.json", result_json(top, q, a));
  draft.write("report.txt", assumed_text(q) + '\n' + verdict_text(top, q, a));
  const std::string csv = csv_of(a);
  draft.write("stimulus.csv", csv);
  Page shown = page(top, q, a);
  const bool is_recorded = !a.recorded.gold.empty() && !a.recorded.gate.empty();
  shown.parts.push_back(
      {"The wave around the first difference",
       fmt::format("wave.fst has more clocks{}. They differ on clock {}, counted from 0. After "
                   "that the inputs stay as they are. A bit that the old RTL leaves x is "
                   "drawn as the new one has it.",
                   is_recorded ? ", and the hierarchies of both" : "", a.clocks.size() - 1),
       draw(q, a, after, (draft.folder() / "wave.fst").string()), csv});
  const std::string folder = for_shell(draft.target().string());
  shown.commands.push_back(
      {fmt::format("{} wave {}", for_shell(program_call()), folder), "The whole wave in GTKWave"});
  shown.commands.push_back({fmt::format("cd {} && gtkwave wave.fst wave.gtkw", folder),
                            "The same where there is only the folder"});
  kept.page = page_text(shown);
  draft.write("report.html", kept.page);
  draft.finish_replacing();
  return kept;
}

}  // namespace cosim::equiv
