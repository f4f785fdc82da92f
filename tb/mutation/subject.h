// Mutants in a Verilated class, one at a time, from the adapter that lockstep uses: a mutant is
// found like any other difference.
#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tb/bench/design_bench.h"
#include "tb/mutation/cases.h"
#include "tb/mutation/mutants.h"
#include "tb/support/parallel.h"
#include "tb/support/read_file.h"
#include "tb/support/replace_file.h"

namespace cosim::mutation {

/// What plant.sh made: a Verilog file, and the list of what is in it; "" where nobody asks for it.
class VerilatedSubject : public Subject {
 public:
  VerilatedSubject(std::string verilog, const std::string& list) : verilog_(std::move(verilog)) {
    if (list.empty()) return;
    std::istringstream lines(read_file(list));
    for (std::string line; std::getline(lines, line);) mutants_.push_back(line);
  }

  /// Chooses the mutant, from 1, for all machines that the calling thread makes from now on; 0 is
  /// the unchanged RTL.
  virtual void choose(unsigned mutant) const = 0;

  const std::vector<std::string>& mutants() const override { return mutants_; }
  void write_verilog(const std::vector<unsigned>&,
                     const std::filesystem::path& file) const override {
    replace_file(file.string(), read_file(verilog_));
  }
  void attack(const std::vector<unsigned>& mutants, std::size_t first, std::size_t last,
              unsigned threads, const Decide& killed) const override {
    if (const Outcome o = attack(0, 0, cases().quick); o.end != Outcome::End::open) {
      throw InputError(bench().title() + ": RTL and model differ without a mutant: " + o.stimulus +
                       ", " + o.signal);
    }
    in_parallel(mutants.size(), threads, [&](std::uint64_t i) {
      Outcome outcome = attack(mutants[i], first, last);
      if (outcome.end != Outcome::End::open) killed(mutants[i], std::move(outcome));
      return true;
    });
  }
  /// One of them with these cases; open where none kills it.
  Outcome attack(unsigned mutant, std::size_t first, std::size_t last) const {
    for (std::size_t i = first; i < last; ++i) {
      Outcome outcome = attack(mutant, cases().all[i]);
      if (outcome.end != Outcome::End::open) return outcome;
    }
    return {};
  }
  Outcome attack(unsigned mutant, const Case& one) const override {
    choose(mutant);
    const Run run = one.run();
    if (!run.mismatch) return {};
    return {Outcome::End::killed, one.name, run.mismatch->clock, run.mismatch->signal};
  }

 private:
  std::string verilog_;
  std::vector<std::string> mutants_;
};

/// An adapter whose RTL has the input `mutsel`. Between a register and its net there may be a
/// mutant: synchronizers take the old value.
template <class Base>
class MutantAdapter : public Base {
 public:
  explicit MutantAdapter(std::uint32_t power_up) : Base(power_up) {
    this->top().mutsel = static_cast<std::uint16_t>(chosen);
  }
  bool turns() const final { return false; }
  static inline thread_local unsigned chosen = 0;
};

template <class Base>
class AdapterSubject final : public VerilatedSubject {
  using Adapter = MutantAdapter<Base>;

 public:
  using VerilatedSubject::VerilatedSubject;

  const AnyBench& bench() const override { return bench_; }
  void choose(unsigned mutant) const override { Adapter::chosen = mutant; }
  const Cases& cases() const override { return cases_; }

 private:
  DesignBench<typename Base::Design> bench_{dut_maker<Adapter>()};
  Cases cases_ = cases_of<typename Base::Design>(bench_);
};

}  // namespace cosim::mutation
