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
  bool same = false;       ///< proved by as many engines as are needed
  bool refuted = false;    ///< shown not to be, from a state that may never be reached
  bool timed_out = false;  ///< more time might help
  std::string verdict;
};

/// Has the engines judge mutants of one machine. yosys-abc is asked of many at once; what it shows
/// to differ nobody else is asked.
class Judge {
 public:
  /// `model`: the machine as nets; null where yosys-abc is not to be asked. Both must outlive it.
  /// `top`: the module of the RTL.
  Judge(const MachineFormula& machine, const nets::Model* model, std::string top, Asking asking);

  /// Those of a Verilog file as of Mutants; none is decided where what the model says of the states
  /// that are reached is not proved. May be called from several threads. InputError where an
  /// engine or yosys is missing.
  std::vector<Judged> judge(const std::filesystem::path& verilog,
                            const std::vector<unsigned>& numbers);
  /// A state and inputs that tell one of them from the RTL without it, as to_text() writes them;
  /// "" where no engine that reads scripts has one. The state may be one that is never reached.
  std::string told_apart(const std::filesystem::path& verilog, unsigned number) const;

 private:
  void ask_reached();
  std::vector<std::vector<Opinion>> opinions_of_abc(const std::filesystem::path& verilog,
                                                    const std::vector<unsigned>& numbers) const;
  Judged judged_by(const Claim& step, const Claim& base_case, std::vector<Opinion> opinions,
                   const std::vector<Engine>& engines, std::size_t needed) const;

  const MachineFormula& machine_;
  const nets::Model* model_;
  std::string top_;
  Asking asking_;
  std::once_flag once_;
  std::string not_reached_;  // why what is said of all states reached does not hold by induction
};

}  // namespace cosim::proof
