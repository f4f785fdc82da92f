// The RTL of one design at one set of parameters, with its mutants, attacked in lanes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tb/mutation/lanes.h"
#include "tb/mutation/mutants.h"
#include "tb/proof/rtl_nets.h"
#include "tb/proof/yosys.h"

namespace cosim::mutation {

// Mutants as yosys plants them: small faults in a design's RTL, each turned on by its number on a
// further input, mutsel.
class Planted {
 public:
  /// The list of at most `count` mutants, all there are where these are fewer. InputError where
  /// yosys cannot be run or cannot read the RTL.
  Planted(proof::Source source, unsigned count);

  const proof::Source& source() const { return source_; }
  /// What each mutant is, in the words of yosys's `mutate`, with files without their folders; that
  /// of mutsel = 1 first.
  const std::vector<std::string>& mutants() const { return mutants_; }

  /// The RTL as one flat module that has these mutants: as nets, and as Verilog.
  proof::RtlNets nets(const std::vector<unsigned>& numbers) const;
  void write_verilog(const std::vector<unsigned>& numbers, const std::filesystem::path& file) const;

 private:
  std::string prepared() const;
  void run(const std::vector<unsigned>& numbers, const std::string& then) const;

  proof::Source source_;
  std::vector<std::string> commands_;  // what plants each
  std::vector<std::string> mutants_;
};

// Some mutants of a bench's RTL in lanes, attacked case by case.
using Decide = std::function<void(unsigned mutant, Outcome)>;

class Batch {
 public:
  explicit Batch(const std::vector<unsigned>& numbers) : mutants(numbers) {}
  virtual ~Batch() = default;
  /// Calls killed(mutant, outcome) for each that the case kills, which is then 0 in `mutants`.
  /// InputError where RTL and model differ without a mutant.
  virtual void run(const Case& c, const Decide& killed) = 0;

  std::vector<unsigned> mutants;
};

/// The RTL with its mutants, tied to what the bench knows of it.
PlantedNets planted_nets(const AnyBench& bench, proof::RtlNets nets);
/// How many mutants go into a batch.
std::size_t batch_size(const AnyBench& bench);
/// `rtl` is of planted_nets(); both must outlive it.
std::unique_ptr<Batch> batch_of(const AnyBench& bench, const PlantedNets& rtl,
                                const std::vector<unsigned>& mutants);

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
