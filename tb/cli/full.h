// The two forms of a program. The small one simulates. The full one also proves, runs in lanes,
// plants mutants, runs regressions, compares RTL and makes projects: it is built when the small one
// is first asked for that, and takes over its command line.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "tb/cli/command.h"
#include "tb/sim/asked.h"
#include "tb/sim/sweep.h"

namespace cosim::cli {

class Registry;

/// A command that only the full program has.
struct FullCommand {
  const char* name;
  const char* help;
};

inline constexpr FullCommand prove_command{
    "prove", "Proves that RTL and model are the same, for every state and input"};
inline constexpr FullCommand mutate_command{
    "mutate", "Plants small faults in the RTL: each must be found or proved harmless"};
inline constexpr FullCommand regress_command{
    "regress", "Runs a plan of sweeps, proofs, mutants and more; resumable, on a cluster too"};
inline constexpr FullCommand lint_command{"lint", "Findings of other tools in the RTL"};
inline constexpr FullCommand equiv_command{
    "equiv", "Compares two versions of RTL: equal for ever, or a distinguishing stimulus"};
inline constexpr FullCommand new_command{"new",
                                         "A project for a design of your own, in a new folder"};
inline constexpr std::array full_commands{prove_command, mutate_command, regress_command,
                                          lint_command,  equiv_command,  new_command};

/// What the two forms do each in its way.
struct Form {
  /// Before the command line is read: becomes the full program where it names a command that only
  /// that has.
  void (*hand_over)(const Registry& registry);
  /// Adds these commands, in the small program for its help alone.
  void (*add_commands)(const Command& program, const Registry& registry);
  /// In the full program nothing. The small one builds the full one and becomes it, and does not
  /// come back. InputError where it cannot be built.
  void (*become_full)(const Registry& registry);
  /// The sweep of the bench in lanes, after become_full(). It prints a line, and is the sweep as it
  /// was, where lanes are not to be had. InputError where they were asked for.
  Sweep (*in_lanes)(const AnyBench& bench, const Sweep& sweep, std::uint64_t seed,
                    std::uint64_t clocks, const Text& lanes);
  /// Asks for each of the points that was not reached, after become_full(). `points` is then as
  /// after the stimuli that were found. InputError where there is no yosys-abc.
  coverage::Answers (*ask_points)(const coverage::Asking& asking, coverage::Points& points);
};

/// What main() does and gives back.
int run_form(int argc, char** argv, const Form& form);

/// That of this program, and its command line.
const Form& form();
char** command_line();

/// Whether a sweep runs in lanes, where `lanes` is what --lanes has, and `clocks` its hostile
/// clocks, 0 of another sweep. InputError for lanes that there are not.
bool is_for_lanes(std::uint64_t clocks, const Text& lanes);

/// How many lanes --lanes asks for, 0: none, on_gpu: those of a device of OpenCL; nothing: what is
/// better. InputError likewise.
inline constexpr int on_gpu = -1;
std::optional<int> lanes_asked(const Text& lanes);

}  // namespace cosim::cli
