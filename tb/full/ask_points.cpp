#include "tb/full/ask_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "model/core/input_error.h"
#include "tb/full/machine_of.h"
#include "tb/full/trusted.h"
#include "tb/proof/from_reset.h"
#include "tb/sim/failure.h"
#include "tb/sim/progress.h"
#include "tb/sim/stimulus_text.h"
#include "tb/util/output_file.h"
#include "tb/util/parallel.h"
#include "tb/util/process.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;
using coverage::Answer;
using coverage::Point;
using proof::Watched;

// What the shapes said of one point.
struct Told {
  bool is_never = false, is_open = false, is_missing = false;

  Answer answer(std::uint64_t hits) const {
    if (hits != 0) return Answer::reached;
    if (is_open) return Answer::open;
    return is_missing || !is_never ? Answer::not_asked : Answer::unreachable;
  }
};

class Asker {
 public:
  Asker(const coverage::Asking& asking, coverage::Points& points)
      : asking_(asking),
        points_(points),
        places_(points.places.size()),
        cases_(points.cases.size()) {}

  coverage::Answers ask() {
    for (const auto& shape : asking_.shapes) ask(shape);
    coverage::Answers all{{}, {}, is_refused_};
    for (std::size_t i = 0; i < places_.size(); ++i) {
      all.places.push_back(places_[i].answer(points_.places[i].hits));
    }
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      all.cases.push_back(cases_[i].answer(points_.cases[i].hits));
    }
    return all;
  }

 private:
  // The points that the shape has and nothing has reached.
  void ask(const coverage::Asking::Shape& shape) {
    std::vector<std::size_t> places, cases;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto same = [&](const Point& other) { return is_same(points_.places[i], other); };
      const auto& its = shape.points.places;
      if (points_.places[i].hits == 0 && std::ranges::any_of(its, same)) places.push_back(i);
    }
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      if (points_.cases[i].hits == 0) cases.push_back(i);
    }
    if (places.empty() && cases.empty()) return;
    try {
      ask(*shape.bench, places, cases);
    } catch (const InputError& error) {
      if (!is_installed("yosys") || !is_installed("yosys-abc")) throw;
      fmt::print("{}: nothing can be asked of it\n", error.what());
      is_refused_ = true;
      for (const std::size_t i : places) places_[i].is_missing = true;
      for (const std::size_t i : cases) cases_[i].is_missing = true;
    }
  }

  void ask(const AnyBench& bench, const std::vector<std::size_t>& places,
           const std::vector<std::size_t>& cases) {
    const proof::BuiltMachine& machine = machine_of(bench);
    if (!machine.is_provable()) {
      throw InputError(bench.title() + ": " + kind_of_model(machine));
    }
    const nets::Model model = machine.nets();
    proof::Source source = source_for(model, source_of(bench));
    require_read(model, source);
    source.keeps_statements = true;
    const proof::RtlNets nets(source);
    watched_.clear();
    tell_.clear();
    for (const std::size_t i : places) {
      Watched watched = watched_of(points_.places[i], nets);
      if (watched.toggles.empty() && watched.holds.empty() && watched.model_case.empty()) {
        places_[i].is_missing = true;
      } else {
        watch(std::move(watched), places_[i], words_for(points_.places[i]));
      }
    }
    for (const std::size_t i : cases) {
      watch({{}, {}, points_.cases[i].name}, cases_[i], points_.cases[i].name);
    }
    if (!watched_.empty()) answer(bench, proof::FromReset(machine.covered(), nets, {}, watched_));
  }

  // The point in the head of a stimulus.
  static std::string words_for(const Point& point) {
    if (!is_of_model(point)) return point.what;
    const std::string file = fs::path(point.file).filename().string();
    return fmt::format("{}:{} {}", file, point.line, point.what);
  }

  static Watched watched_of(const Point& point, const proof::RtlNets& rtl) {
    Watched watched;
    if (is_of_model(point)) watched.model_case = name_in_model(point);
    if (point.kind == "toggle") {
      for (const std::string& instance : point.instances) {
        const auto nets = rtl.nets_in(instance, point.what);
        watched.toggles.insert(watched.toggles.end(), nets.begin(), nets.end());
      }
    }
    if (point.kind != "user") return watched;
    // By its label, or by the file and the line that stand for one.
    const std::string place = fmt::format(":{}", point.line);
    for (const auto& [name, net] : rtl.covered()) {
      const std::string last = name.substr(name.rfind('.') + 1);
      const std::size_t line = name.rfind(place);
      const bool is_here =
          line != std::string::npos && !isdigit(name[line + place.size()]) &&
          fs::path(name.substr(0, line)).filename() == fs::path(point.file).filename();
      if (is_here || last == point.what) watched.holds.push_back(net);
    }
    return watched;
  }

  void watch(Watched watched, Told& told, const std::string& what) {
    watched_.push_back(std::move(watched));
    tell_.push_back({&told, what});
  }

  void answer(const AnyBench& bench, const proof::FromReset& machine) {
    StateLine state;
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(asking_.seconds);
    const auto found = machine.ask_watched(until, cores(), [&](std::size_t left) {
      state.show(fmt::format("{}: {} to be decided, asked from reset, at most {} s", bench.title(),
                             count(left, "point"), asking_.seconds));
    });
    std::vector<std::string> files;
    for (std::size_t i = 0; i < found.stimuli.size(); ++i) {
      std::string reaches;
      for (std::size_t p = 0; p < tell_.size(); ++p) {
        const auto& point = found.points[p];
        if (point.ever != proof::Ever::yes || point.stimulus != i) continue;
        reaches += (reaches.empty() ? "reaches " : ", ") + tell_[p].what;
      }
      const Stimulus stimulus{bench.title(), reaches, 1, {}, found.stimuli[i]};
      const std::string name = failure_name(bench, fmt::format("reach {}", i + 1)) + ".stim";
      files.push_back((fs::path(asking_.stimuli) / name).string());
      std::error_code ignored;  // of the file it is said
      fs::create_directories(asking_.stimuli, ignored);
      write_file(files.back(), to_text(stimulus, bench));
    }
    if (!files.empty()) points_ = asking_.run(bench, files);
    for (std::size_t p = 0; p < tell_.size(); ++p) {
      Told& told = *tell_[p].told;
      (found.points[p].ever == proof::Ever::never ? told.is_never : told.is_open) = true;
    }
  }

  struct Tell {
    Told* told;
    std::string what;
  };
  const coverage::Asking& asking_;
  coverage::Points& points_;
  std::vector<Told> places_, cases_;
  bool is_refused_ = false;
  std::vector<Watched> watched_;  // in the shape that is asked
  std::vector<Tell> tell_;        // and whom it is told
};

}  // namespace

coverage::Answers ask_points(const coverage::Asking& asking, coverage::Points& points) {
  return Asker(asking, points).ask();
}

}  // namespace cosim::cli
