// The clock-by-clock table of a run: every register and output, one row a clock.
#pragma once

#include <fmt/core.h>

#include "tb/sim/bench.h"
#include "tb/sim/cells.h"
#include "tb/util/show.h"

namespace cosim {

/// Prints a heading on construction and a row for each clock it is shown.
template <class Design>
class Table final : public Observer<Design> {
  using Registers = typename Design::template Registers<Word>;
  using Outputs = typename Design::template Outputs<Word>;

 public:
  explicit Table(const typename Design::Params& p) : registers_(p), outputs_(p) {
    fmt::print("{:>6}", "clock");
    const auto column = [](const Field& f) { fmt::print("  {:>{}}", label_of(f), width(f)); };
    for (const Field& f : registers_.fields()) column(f);
    for (const Field& f : outputs_.fields()) column(f);
    fmt::print("\n");
  }

  void clock(std::size_t, const Compared<Design>& seen) override {
    fmt::print("{:>6}", clock_++);
    const auto row = [](const auto& cells, const auto& record) {
      const std::vector<Word> words = cells.words(record);
      for (std::size_t i = 0; i < words.size(); ++i) {
        const Field& f = cells.fields()[i];
        fmt::print("  {:>{}}", show_short(f, words[i]), width(f));
      }
    };
    row(registers_, seen.registers);
    row(outputs_, seen.outputs);
    fmt::print("\n");
  }

 private:
  static std::size_t width(const Field& f) { return std::max(show_width(f), label_of(f).size()); }
  Cells<Registers> registers_;
  Cells<Outputs> outputs_;
  std::uint64_t clock_ = 0;
};

}  // namespace cosim
