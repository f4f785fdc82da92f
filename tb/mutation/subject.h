// The RTL of one design at one set of parameters, with its mutants, attacked in lanes.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tb/mutation/batch.h"
#include "tb/mutation/mutants.h"
#include "tb/mutation/planted.h"

namespace cosim::mutation {

class Subject {
 public:
  /// At most `count` mutants of the RTL that `bench`, which must outlive it, has without any. The
  /// cases run on that bench.
  Subject(const AnyBench& bench, Cases cases, proof::Source source, unsigned count)
      : bench_(bench), cases_(std::move(cases)), planted_(std::move(source), count) {}

  const AnyBench& bench() const { return bench_; }
  const Cases& cases() const { return cases_; }
  /// What each mutant is, in the words of yosys's `mutate`; number 1 first.
  const std::vector<std::string>& mutants() const { return planted_.mutants(); }
  /// A Verilog file that holds these; its input `mutsel` chooses one.
  void write_verilog(const std::vector<unsigned>& mutants,
                     const std::filesystem::path& file) const {
    planted_.write_verilog(mutants, file);
  }
  /// Runs cases first .. last - 1 on each of these mutants, on `threads` threads, until one kills
  /// it; calls decide(mutant, outcome), from several threads, for those that are killed, and for
  /// those that are unread, which are given no case. InputError where RTL and model differ without
  /// a mutant.
  void attack(const std::vector<unsigned>& mutants, std::size_t first, std::size_t last,
              unsigned threads, const Decide& decide) const;
  /// One case on one of them, on the calling thread; open where it does not kill it.
  Outcome attack(unsigned mutant, const Case& one) const;
  /// Those of the mutants that a reset leaves as they powered up, in part; of a bench in lockstep.
  std::vector<unsigned> not_reset(const std::vector<unsigned>& mutants) const;

 private:
  const AnyBench& bench_;
  Cases cases_;
  Planted planted_;
};

}  // namespace cosim::mutation
