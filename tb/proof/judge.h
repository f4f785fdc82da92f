// Whether mutants are the same machine as the RTL without one: the engines are asked.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "tb/proof/decide.h"

namespace cosim::proof {

/// What is known of a mutant.
struct Judged {
  bool same = false;       ///< proved by all engines
  bool refuted = false;    ///< shown not to be, from a state that may never be reached
  bool timed_out = false;  ///< more time might help
  std::string verdict;
};

/// Has the engines judge mutants of one machine, many at a time. What one shows to differ no other
/// is asked.
class Judge {
 public:
  /// `model` must outlive it. `top`: the module of the RTL.
  Judge(const nets::Model& model, std::string top, Asking asking);

  /// Those of a Verilog file, one module with the input `mutsel` of 16 bits: 0 turns none on, k the
  /// mutant of that number. None is decided where what the model says of the states that are
  /// reached is not proved. May be called from several threads. InputError where an engine or yosys
  /// is missing.
  std::vector<Judged> judge(const std::filesystem::path& verilog,
                            const std::vector<unsigned>& numbers);
  /// A state and inputs that tell one of them from the RTL without it, as to_text() writes them;
  /// "" where no engine has one. The state may be one that is never reached.
  std::string told_apart(const std::filesystem::path& verilog, unsigned number) const;

 private:
  void ask_reached();
  RtlNets nets_of(const std::filesystem::path& verilog) const;
  std::vector<Judged> judged(const RtlNets& rtl, const std::vector<unsigned>& numbers) const;

  const nets::Model& model_;
  std::string top_;
  Asking asking_;
  std::once_flag once_;
  std::string not_reached_;  // why what is said of all states reached does not hold by induction
};

}  // namespace cosim::proof
