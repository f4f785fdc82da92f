// The clock-by-clock table of a run: every register and output, one row a clock.
#pragma once

#include <fmt/core.h>

#include <cstdio>

#include "tb/bench/bench.h"
#include "tb/support/show.h"

namespace cosim {

/// Prints a heading on construction and a row for each clock it is shown.
template <class Design>
class Table final : public Observer<Design> {
  using Registers = typename Design::template Registers<Word>;
  using Outputs = typename Design::template Outputs<Word>;

 public:
  explicit Table(const typename Design::Params& p)
      : registers_(Registers::fields(p)), outputs_(Outputs::fields(p)) {
    fmt::print("{:>6}", "clock");
    const auto column = [](const Field& f) { fmt::print("  {:>{}}", f.name, width(f)); };
    for (const Field& f : registers_) column(f);
    for (const Field& f : outputs_) column(f);
    fmt::print("\n");
  }

  void clock(std::size_t, const Compared<Design>& seen) override {
    fmt::print("{:>6}", clock_++);
    const auto cell = [](const Field& f, Word w) {
      fmt::print("  {:>{}}", show_short(f, w), width(f));
    };
    const auto registers = to_words(seen.registers);
    const auto outputs = to_words(seen.outputs);
    for (std::size_t i = 0; i < registers.size(); ++i) cell(registers_[i], registers[i]);
    for (std::size_t i = 0; i < outputs.size(); ++i) cell(outputs_[i], outputs[i]);
    fmt::print("\n");
  }

 private:
  static std::size_t width(const Field& f) {
    return std::max(show_width(f), std::string_view(f.name).size());
  }
  std::array<Field, Registers::size> registers_;
  std::array<Field, Outputs::size> outputs_;
  std::uint64_t clock_ = 0;
};

}  // namespace cosim
