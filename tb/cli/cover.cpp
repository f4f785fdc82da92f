// PROGRAM cover: what of the RTL, and which cases and ways of the model, the sweeps of a design
// never reach.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/cli/commands.h"
#include "tb/cli/common.h"
#include "tb/cli/full.h"
#include "tb/cli/number.h"
#include "tb/cli/outputs.h"
#include "tb/cli/registry.h"
#include "tb/sim/asked.h"
#include "tb/sim/main_of.h"
#include "tb/sim/progress.h"
#include "tb/sim/report.h"
#include "tb/util/json.h"
#include "tb/util/process.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;
using coverage::Answer;
using coverage::Answers;
using coverage::Point;
using coverage::Points;
using Benches = std::vector<const AnyBench*>;

struct CoverOptions {
  Common common;
  std::vector<std::string> words;
  Text hostile, random, counts, seconds, stimuli;
  bool close = false;

  std::string stimuli_folder() const { return stimuli.value_or("stimuli"); }
  int seconds_each() const {
    return static_cast<int>(whole("--seconds", seconds.value_or("60"), 1, 1000000));
  }
};

bool is_toggle(const Point& p) { return p.kind == "toggle"; }
bool is_cover(const Point& p) { return p.kind == "user"; }
bool is_way(const Point& p) { return p.kind == "model way"; }
bool is_branch(const Point& p) { return p.kind == "model branch"; }
bool is_model_line(const Point& p) { return p.kind == "model line"; }
bool is_condition(const Point& p) { return p.kind == "model condition"; }
bool is_line(const Point& p) { return !is_toggle(p) && !is_cover(p) && !is_of_model(p); }

struct Kind {
  const char* name;
  bool (*is)(const Point&);
};
constexpr Kind kinds_of_rtl[] = {{"lines", is_line}, {"toggles", is_toggle}, {"covers", is_cover}};
constexpr Kind kinds_of_model[] = {{"ways", is_way},
                                   {"branches", is_branch},
                                   {"lines of the model", is_model_line},
                                   {"conditions of the model", is_condition}};

// "24 of 24 lines"; nothing where there is none.
void add_part(std::string& text, Json& json, const char* name, std::uint64_t reached,
              std::uint64_t all) {
  if (all == 0) return;
  text += fmt::format("{}{} of {} {}", text.empty() ? "" : ", ", reached, all, name);
  json[name] = {{"reached", reached}, {"all", all}};
}

// What is known of it, to stand behind the point; nothing where nothing was asked.
std::string known(const std::vector<Answer>& answers, std::size_t i) {
  if (answers.empty() || answers[i] == Answer::reached) return "";
  if (answers[i] == Answer::not_asked) return ": not asked";
  return answers[i] == Answer::open ? ": open" : ": unreachable, proved";
}

std::string never_taken(const Point& p, const std::string& answer) {
  if (is_model_line(p) || is_condition(p)) {
    const char* what = is_condition(p) ? "always the same" : "never runs";
    return fmt::format("{}:{}: {}{}: {}", p.file, p.line, what, answer, p.what);
  }
  const std::size_t colon = p.what.find(':');  // "false: if (x); after 36 true"
  return fmt::format("{}:{}: never {}{}{}", p.file, p.line, p.what.substr(0, colon), answer,
                     p.what.substr(colon));
}

// One line a place; bits of one declaration that never toggle share it.
std::vector<std::string> never_reached(const Points& points, const Answers& answers) {
  std::vector<std::string> lines;
  std::string place;
  for (std::size_t i = 0; i < points.places.size(); ++i) {
    const Point& p = points.places[i];
    if (p.hits != 0 || is_of_model(p)) continue;
    const std::string answer = known(answers.places, i);
    const std::string here = fmt::format("{}:{}:{}{}", p.file, p.line, p.column, answer);
    if (is_toggle(p) && here == place) {
      lines.back() += ' ' + p.what;
      continue;
    }
    place = is_toggle(p) ? here : "";
    const char* what = is_toggle(p) ? "never toggles" : is_cover(p) ? "never holds" : "never runs";
    lines.push_back(fmt::format("{}:{}: {}{}: {}", p.file, p.line, what, answer, p.what));
  }
  for (std::size_t i = 0; i < points.cases.size(); ++i) {
    if (points.cases[i].hits != 0) continue;
    lines.push_back(
        fmt::format("never happens{}: {}", known(answers.cases, i), points.cases[i].name));
  }
  for (std::size_t i = 0; i < points.places.size(); ++i) {
    const Point& p = points.places[i];
    if (p.hits == 0 && is_of_model(p)) lines.push_back(never_taken(p, known(answers.places, i)));
  }
  return lines;
}

// How many of all points have each answer.
Json closed(const Points& points, const Answers& answers) {
  std::map<Answer, std::size_t> sums;
  for (const Answer a : answers.places) ++sums[a];
  for (const Answer a : answers.cases) ++sums[a];
  std::string text =
      fmt::format("{} reached, {} unreachable, {} open", sums[Answer::reached],
                  sums[Answer::unreachable], sums[Answer::open] + sums[Answer::not_asked]);
  if (sums[Answer::not_asked] != 0) {
    text += fmt::format(", {} of these not asked", sums[Answer::not_asked]);
    if (!answers.is_refused) text += ": no lines are, nor bits that yosys has no net of";
  }
  fmt::print("of {}: {}\n", count(points.places.size() + points.cases.size(), "point"), text);
  return {{"reached", sums[Answer::reached]},
          {"unreachable", sums[Answer::unreachable]},
          {"open", sums[Answer::open]},
          {"not_asked", sums[Answer::not_asked]}};
}

std::string first_line(const std::string& path) {
  std::string line;
  std::ifstream file(path);
  return std::getline(file, line) ? line : "begins";
}

// Runs the counted program of a shape, which is built, and leaves its counts in the folder. False
// where RTL and model differ.
bool counted(const Registry& registry, const AnyBench& bench, const std::string& folder,
             const std::vector<std::string>& words) {
  const OnDemand& program = on_demand(registry.covers(), bench.built_as());
  std::vector<std::string> command{path_of(program), folder};
  command.insert(command.end(), words.begin(), words.end());
  const Ended ended = [&] {
    StateLine line;
    line.show([&] { return bench.title() + ", " + first_line(folder + coverage::progress_file); });
    return cosim::run_program(command);
  }();
  if (ended.status > 1) throw InputError(ended.text.substr(0, ended.text.find('\n')));
  fmt::print("{}", ended.text);
  return ended.status == 0;
}

// What is found after a long time is to find its place.
void check_stimuli(const std::string& folder) {
  std::error_code error;
  fs::path there = fs::absolute(folder, error);
  while (there.has_relative_path() && !fs::exists(there, error)) there = there.parent_path();
  if (!folder.empty() && fs::is_directory(there, error) && access(there.c_str(), W_OK) == 0) return;
  throw InputError("--stimuli: " + in_quotes(folder) + " is no folder that can be written to");
}

// The counts are left in a new folder in `folder`, a folder for each shape.
Json covered(const CoverOptions& o, const Registry& registry, const Benches& benches,
             const std::vector<std::string>& work, const std::string& folder) {
  const std::string design = benches.front()->design();
  const std::string counts = folder + '/' + design;
  fs::create_directory(counts);
  const auto folder_of = [&](const AnyBench& bench) {
    std::string name = bench.title();
    std::replace(name.begin(), name.end(), ' ', '-');
    return counts + '/' + name;
  };
  bool differed = false;
  coverage::Asking asking{
      {}, o.seconds_each(), o.stimuli_folder(), [&](const AnyBench& bench, const auto& files) {
        std::vector<std::string> words{"replay"};
        words.insert(words.end(), files.begin(), files.end());
        differed = !counted(registry, bench, folder_of(bench), words) || differed;
        return coverage::read_points(counts);
      }};
  std::vector<OnDemand> programs;
  for (const AnyBench* bench : benches) {
    programs.push_back(on_demand(registry.covers(), bench->built_as()));
  }
  build(registry, programs);
  for (const AnyBench* bench : benches) {
    fs::create_directory(folder_of(*bench));
    differed = !counted(registry, *bench, folder_of(*bench), work) || differed;
    asking.shapes.push_back({bench, coverage::read_points(folder_of(*bench))});
  }
  Points points = coverage::read_points(counts);
  const Answers answers = o.close ? form().ask_points(asking, points) : Answers{};
  Json json{{"design", design}, {"shapes", benches.size()}, {"differs", differed}};
  std::string text;
  const auto add_kind = [&](const Kind& kind) {
    const auto all = std::ranges::count_if(points.places, kind.is);
    const auto reached = std::ranges::count_if(
        points.places, [&](const Point& p) { return kind.is(p) && p.hits != 0; });
    add_part(text, json, kind.name, static_cast<std::uint64_t>(reached),
             static_cast<std::uint64_t>(all));
  };
  for (const Kind& kind : kinds_of_rtl) add_kind(kind);
  const auto hit =
      std::ranges::count_if(points.cases, [](const auto& one) { return one.hits != 0; });
  add_part(text, json, "cases", static_cast<std::uint64_t>(hit), points.cases.size());
  for (const Kind& kind : kinds_of_model) add_kind(kind);
  fmt::print("{}, {}: reached {}\n", design, count(benches.size(), "configuration"), text);
  const auto left = never_reached(points, answers);
  for (const std::string& line : left) fmt::print("{}\n", line);
  json["never_reached"] = left;
  if (o.close) json["closed"] = closed(points, answers);
  return json;
}

// Nothing is left to find a stimulus for.
bool is_done(const Json& design) {
  if (design.at("differs")) return false;
  if (!design.contains("closed")) return design.at("never_reached").empty();
  const Json& closed = design.at("closed");
  return closed.at("open") == 0 && closed.at("not_asked") == 0;
}

int run(const CoverOptions& o, const Registry& registry) {
  const InterruptGuard interrupts;
  constexpr std::uint64_t most = std::uint64_t{1} << 32;
  const std::uint64_t clocks = whole("--hostile", o.hostile.value_or("100000"), 1, most);
  const std::uint64_t jobs = whole("--random", o.random.value_or("1000"), 1, most);
  const Benches chosen = chosen_shapes(o.words);
  if (!o.close && (o.seconds || o.stimuli)) {
    throw InputError(fmt::format("--{}: only with --close", o.seconds ? "seconds" : "stimuli"));
  }
  o.seconds_each();
  check_outputs(o.common);
  std::error_code error;
  if (o.counts && fs::exists(*o.counts, error)) {
    throw InputError("--counts: " + one_line(*o.counts) + ": exists; name a new folder");
  }
  if (o.counts && !fs::is_directory(fs::absolute(*o.counts, error).parent_path(), error)) {
    throw InputError("--counts: " + one_line(*o.counts) + ": the folder around it is not there");
  }
  if (o.close) {
    check_stimuli(o.stimuli_folder());
    form().become_full(registry);
  }
  const Scratch scratch;
  Json all = Json::array();
  bool reached = true;
  const std::vector<std::string> work{fmt::format("{}", o.common.seed()), fmt::format("{}", clocks),
                                      fmt::format("{}", jobs)};
  for (auto first = chosen.begin(); first != chosen.end();) {
    const auto last = std::find_if(first, chosen.end(), [&](const AnyBench* bench) {
      return bench->design() != (*first)->design();
    });
    all.push_back(covered(o, registry, {first, last}, work, scratch.path()));
    reached = is_done(all.back()) && reached;
    first = last;
  }
  if (o.counts) fs::copy(scratch.path(), *o.counts, fs::copy_options::recursive, error);
  if (error) throw InputError("--counts: " + one_line(*o.counts) + ": " + error.message());
  write_report(o.common.report.value_or(""), json_text(all, 1) + '\n');
  return reached ? 0 : 1;
}

}  // namespace

void add_cover(const Command& program, const Registry& registry) {
  if (!registry.has_designs()) return;
  auto o = std::make_shared<CoverOptions>();
  const Command command = program.sub(
      "cover", "Which lines and bits of the RTL, cases, ways of the model no sweep reaches");
  command.arguments("MACHINE", o->words, "A design, or a line of 'list'; default all");
  command.text("--hostile", o->hostile, "CLOCKS",
               "How many hostile clocks each configuration gets; default 100000");
  command.text("--random", o->random, "JOBS",
               "How many random jobs, where the design declares some; default 1000");
  command.text("--counts", o->counts, "FOLDER",
               "Leave the counts in this new folder, for verilator_coverage");
  command.flag("--close", o->close,
               "Ask an engine for the rest: a stimulus, or a proof that it is unreachable");
  command.text("--seconds", o->seconds, "S",
               "Seconds of search for each configuration; default 60");
  command.text("--stimuli", o->stimuli, "FOLDER",
               "The folder for the stimuli that it finds; default stimuli");
  add_report(command, o->common);
  add_seed(command, o->common);
  command.footer(fmt::format(
      "Verilator counts lines, toggles of each bit and cover statements, over all instances and\n"
      "configurations of a design, but not between '// verilator coverage_off' and '// verilator\n"
      "coverage_on'. The program with counters is built when it is first needed.\n"
      "Ways are the paths through clock() of the model. A model with more than 256 ways has\n"
      "branches instead, the values of each condition, and so have blocks of merge(). A way is\n"
      "printed by the line of its last condition. A model of streams alone has lines of its\n"
      "headers, and conditions, each of which has to be true once and false once.\n"
      "--close asks for each bit, cover statement, case and way whether it can happen from reset;\n"
      "its stimuli are kept, and run in the RTL with counters.\n"
      "Exit status: 0 all reached, or proved unreachable; 1 something was not; 2 bad input.\n"
      "Example: {0} cover {1} --hostile 10000",
      program_name(), benches().front()->built_as()));
  command.action([o, &registry] { return run(*o, registry); });
}

}  // namespace cosim::cli
