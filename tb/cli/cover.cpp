// PROGRAM cover: what of the RTL, and which cases of the model, the sweeps of a design never reach.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "model/core/input_error.h"
#include "tb/cli/commands.h"
#include "tb/coverage/points.h"
#include "tb/program/chosen.h"
#include "tb/program/common.h"
#include "tb/program/number.h"
#include "tb/program/on_demand.h"
#include "tb/program/outputs.h"
#include "tb/report/report.h"
#include "tb/support/json.h"
#include "tb/support/process.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;
using coverage::Point;
using coverage::Points;
using Benches = std::vector<const AnyBench*>;

struct CoverOptions {
  Common common;
  std::vector<std::string> words;
  Text hostile, random, counts;
};

bool is_toggle(const Point& p) { return p.kind == "toggle"; }
bool is_cover(const Point& p) { return p.kind == "user"; }
bool is_line(const Point& p) { return !is_toggle(p) && !is_cover(p); }

struct Kind {
  const char* name;
  bool (*is)(const Point&);
};
constexpr Kind point_kinds[] = {{"lines", is_line}, {"toggles", is_toggle}, {"covers", is_cover}};

// "24 of 24 lines"; nothing where there is none.
void add_part(std::string& text, Json& json, const char* name, std::uint64_t reached,
              std::uint64_t all) {
  if (all == 0) return;
  text += fmt::format("{}{} of {} {}", text.empty() ? "" : ", ", reached, all, name);
  json[name] = {{"reached", reached}, {"all", all}};
}

// One line a place; bits of one declaration that never toggle share it.
std::vector<std::string> never_reached(const Points& points) {
  std::vector<std::string> lines;
  std::string place;
  for (const Point& p : points.rtl) {
    if (p.hits != 0) continue;
    const std::string here = fmt::format("{}:{}:{}", p.file, p.line, p.column);
    if (is_toggle(p) && here == place) {
      lines.back() += ' ' + p.what;
      continue;
    }
    place = is_toggle(p) ? here : "";
    const char* what = is_toggle(p) ? "never toggles" : is_cover(p) ? "never holds" : "never runs";
    lines.push_back(fmt::format("{}:{}: {}: {}", p.file, p.line, what, p.what));
  }
  for (const auto& one : points.cases) {
    if (one.hits == 0) lines.push_back("never happens: " + one.name);
  }
  return lines;
}

// The counts are left in a new folder in `folder`.
Json covered(const CoverOptions& o, const Registry& registry, const Benches& benches,
             std::uint64_t clocks, std::uint64_t jobs, const std::string& folder) {
  const std::string design = benches.front()->design();
  const std::string counts = folder + '/' + design;
  fs::create_directory(counts);
  bool differed = false;
  for (const AnyBench* bench : benches) {
    const OnDemand& program = on_demand(registry.covers(), bench->built_as());
    build(registry, program);
    const Ended ended =
        cosim::run_program({path_of(program), counts, fmt::format("{}", o.common.seed()),
                            fmt::format("{}", clocks), fmt::format("{}", jobs)});
    if (ended.status > 1) throw InputError(ended.text.substr(0, ended.text.find('\n')));
    differed = differed || ended.status == 1;
    fmt::print("{}", ended.text);
  }
  const Points points = coverage::read_points(counts);
  Json json{{"design", design}, {"shapes", benches.size()}, {"differs", differed}};
  std::string text;
  for (const Kind& kind : point_kinds) {
    const auto all = std::count_if(points.rtl.begin(), points.rtl.end(), kind.is);
    const auto reached = std::count_if(points.rtl.begin(), points.rtl.end(),
                                       [&](const Point& p) { return kind.is(p) && p.hits != 0; });
    add_part(text, json, kind.name, static_cast<std::uint64_t>(reached),
             static_cast<std::uint64_t>(all));
  }
  const auto hit = std::count_if(points.cases.begin(), points.cases.end(),
                                 [](const auto& one) { return one.hits != 0; });
  add_part(text, json, "cases", static_cast<std::uint64_t>(hit), points.cases.size());
  fmt::print("{}, {}: reached {}\n", design, count(benches.size(), "shape"), text);
  const auto left = never_reached(points);
  for (const std::string& line : left) fmt::print("{}\n", line);
  json["never_reached"] = left;
  return json;
}

int run(const CoverOptions& o, const Registry& registry) {
  const InterruptGuard interrupts;
  constexpr std::uint64_t most = std::uint64_t{1} << 32;
  const std::uint64_t clocks = whole("--hostile", o.hostile.value_or("100000"), 1, most);
  const std::uint64_t jobs = whole("--random", o.random.value_or("1000"), 1, most);
  const Benches chosen = chosen_shapes(o.words);
  check_outputs(o.common);
  std::error_code error;
  if (o.counts && (fs::exists(*o.counts, error) ||
                   !fs::is_directory(fs::absolute(*o.counts, error).parent_path(), error))) {
    throw InputError("--counts: " + one_line(*o.counts) +
                     ": is not a new folder in one that is there");
  }
  const Scratch scratch;
  Json all = Json::array();
  bool reached = true;
  for (auto first = chosen.begin(); first != chosen.end();) {
    const auto last = std::find_if(first, chosen.end(), [&](const AnyBench* bench) {
      return bench->design() != (*first)->design();
    });
    all.push_back(covered(o, registry, {first, last}, clocks, jobs, scratch.path()));
    reached = reached && !all.back().at("differs") && all.back().at("never_reached").empty();
    first = last;
  }
  if (o.counts) fs::copy(scratch.path(), *o.counts, fs::copy_options::recursive, error);
  if (error) throw InputError("--counts: " + one_line(*o.counts) + ": " + error.message());
  write_report(o.common.report.value_or(""), json_text(all, 1) + '\n');
  return reached ? 0 : 1;
}

}  // namespace

void add_cover(const Command& program, const Registry& registry) {
  if (registry.covers().empty()) return;
  auto o = std::make_shared<CoverOptions>();
  const Command command = program.sub(
      "cover", "Which lines and bits of the RTL, and which cases, the sweeps never reach");
  command.arguments("MACHINE", o->words, "A design, or a line of 'list'; default all");
  command.text("--hostile", o->hostile, "CLOCKS",
               "How many hostile clocks each shape gets; default 100000");
  command.text("--random", o->random, "JOBS",
               "How many random jobs, where the design declares some; default 1000");
  command.text("--counts", o->counts, "FOLDER",
               "Leave the counts there, a new folder, for verilator_coverage");
  add_common(command, o->common);
  command.footer(fmt::format(
      "Lines, toggles of each bit and cover statements are counted by Verilator, over all "
      "instances\n"
      "and shapes of a design; not what stands between '// verilator coverage_off' and\n"
      "'// verilator coverage_on'. The program with counters is built when first asked for.\n"
      "Exit status: 0 all reached, 1 something was not, 2 bad input.\n"
      "Example: {} cover {} --hostile 10000",
      program_name(), benches().front()->built_as()));
  command.action([o, &registry] { return run(*o, registry); });
}

}  // namespace cosim::cli
