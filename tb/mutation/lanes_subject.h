// The mutants of a shape that are attacked in lanes.
#pragma once

#include "tb/mutation/mutants.h"
#include "tb/mutation/planted.h"

namespace cosim::mutation {

class LanesSubject final : public Subject {
 public:
  /// At most `count` mutants of the RTL that `bench`, which must outlive it, has without any. The
  /// cases run on that bench.
  LanesSubject(const AnyBench& bench, Cases cases, proof::Source source, unsigned count)
      : bench_(bench), cases_(std::move(cases)), planted_(std::move(source), count) {}

  const AnyBench& bench() const override { return bench_; }
  const Cases& cases() const override { return cases_; }
  const std::vector<std::string>& mutants() const override { return planted_.mutants(); }
  void write_verilog(const std::vector<unsigned>& mutants,
                     const std::filesystem::path& file) const override {
    planted_.write_verilog(mutants, file);
  }
  void attack(const std::vector<unsigned>& mutants, std::size_t first, std::size_t last,
              unsigned threads, const Decide& killed) const override;
  Outcome attack(unsigned mutant, const Case& one) const override;
  /// Those of the mutants that a reset leaves as they powered up, in part.
  std::vector<unsigned> not_reset(const std::vector<unsigned>& mutants) const;

 private:
  const AnyBench& bench_;
  Cases cases_;
  Planted planted_;
};

}  // namespace cosim::mutation
