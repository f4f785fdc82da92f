// What designs and studies add to the program. Each defines one function in its folder cli,
//
//   void cosim::NAME::add_to(cosim::cli::Registry& registry);
//
// and CMake makes the source that calls them all: the designs in the order of rtl/shipped.txt, then
// the studies by name. The harness itself names none of them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tb/cli/command.h"
#include "tb/cli/shape.h"
#include "tb/sim/sweep.h"

namespace cosim::cli {

/// PROGRAM sweep DESIGN.
struct DesignSweeps {
  std::string design;
  std::string help;     ///< what is swept: "Lines of any slope"
  std::string example;  ///< the words behind "PROGRAM sweep DESIGN"
  std::vector<ShapeOption> shape;
  /// Every case there is, one at a time or in lanes; empty if the bench is too wide for that.
  std::function<std::vector<Sweep>(const AnyBench&, bool in_lanes)> exhaustive;
  std::string exhaustible;  ///< the shapes that are not too wide: "M <= 8, or 14 with --lanes auto"
  /// `count` cases, which the seed decides.
  std::function<Sweep(const AnyBench&, std::uint64_t seed, std::uint64_t count)> random;
};

/// A command line that shows what a design or a study is for.
struct Example {
  std::string title;
  std::vector<std::string>
      words;  ///< behind the program, run in the project's folder; none has spaces
};

/// A program for one design or shape that is built when a command needs it.
struct OnDemand {
  std::string title;   ///< of what it is: "NAME M=5 N=2"
  std::string target;  ///< of the build folder
  std::string folder;  ///< where it leaves its program of the same name, and what it was made of
};

class Registry {
 public:
  /// `program`: how the program is called in what it says.
  explicit Registry(std::string program) : program_(std::move(program)) {}

  const std::string& program() const { return program_; }
  /// `add` adds one command to the program.
  void command(std::function<void(const Command& program)> add) {
    commands_.push_back(std::move(add));
  }
  void sweeps(DesignSweeps sweeps) { sweeps_.push_back(std::move(sweeps)); }
  void example(Example example) { examples_.push_back(std::move(example)); }

  /// Where OnDemand is built: CMake's program, and a folder that it made.
  void builds(std::string cmake, std::string folder) {
    cmake_ = std::move(cmake);
    build_ = std::move(folder);
  }
  /// The full program, full.h; one that attacks mutants of any shape; and one for each shape that
  /// counts what is reached.
  void full(OnDemand program) { full_ = std::move(program); }
  void attacks(OnDemand program) { attacks_ = std::move(program); }
  void cover(OnDemand program) { covers_.push_back(std::move(program)); }

  const std::string& cmake() const { return cmake_; }
  const std::string& build_folder() const { return build_; }
  const OnDemand& full() const { return full_; }
  const OnDemand& attacks() const { return attacks_; }
  const std::vector<OnDemand>& covers() const { return covers_; }
  bool has_designs() const { return !covers_.empty(); }
  const std::vector<std::function<void(const Command&)>>& commands() const { return commands_; }
  const std::vector<DesignSweeps>& sweeps() const { return sweeps_; }
  const std::vector<Example>& examples() const { return examples_; }

 private:
  std::string program_;
  std::vector<std::function<void(const Command&)>> commands_;
  std::vector<DesignSweeps> sweeps_;
  std::vector<Example> examples_;
  std::string cmake_, build_;
  OnDemand full_, attacks_;
  std::vector<OnDemand> covers_;
};

/// Makes a function of the design's own benches one of any bench.
template <class Design, class F>
auto for_bench_of(F f) {
  return [f](const AnyBench& bench, auto... more) {
    return f(dynamic_cast<const Bench<Design>&>(bench), more...);
  };
}

/// All that was built. Made by CMake, from program.cpp.in.
const Registry& registry();

/// That of the title. InputError where there is none.
const OnDemand& on_demand(const std::vector<OnDemand>& all, const std::string& title);

/// Builds them at once. InputError where that fails, with what was said on standard error.
void build(const Registry& registry, const std::vector<OnDemand>& programs);

/// Where it is then.
std::string path_of(const OnDemand& program);

}  // namespace cosim::cli
