// Which registers and outputs mean something on a clock, where a design says so with compared(p, s)
// and compared(p, s, in, out): only those are compared.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/core/design.h"
#include "model/core/input_error.h"

namespace cosim {

/// One bit a cell of the registers, then one a cell of the outputs: whether it is compared on the
/// present clock; and on how many clocks each was left out.
template <class Design>
class CompareMask {
  using Registers = typename Design::template Registers<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using State = typename Design::template State<Word>;
  using Inputs = typename Design::template Inputs<Word>;
  using Params = typename Design::Params;

 public:
  static constexpr bool any = compares_some_registers<Design> || compares_some_outputs<Design>;
  static constexpr std::size_t size = Registers::size + Outputs::size;

  /// InputError where compared() names a field that is not in its table.
  explicit CompareMask(const Params& p) {
    if constexpr (any) {
      compared_.fill(true);
      add_places<Registers>(p, 0);
      add_places<Outputs>(p, Registers::size);
      const auto registers = registers_compared_of<Word>(p, State{});
      const auto outputs = outputs_compared_of<Word>(p, State{}, Inputs{}, Outputs{});
      for (const auto& one : registers) find<Registers>(p, "register", one.sentence, 0);
      for (const auto& one : outputs) find<Outputs>(p, "output", one.sentence, Registers::size);
    }
  }

  /// To be called on every clock: the state before it, its inputs and the model's outputs.
  constexpr void clock(const Params& p, const State& s, const Inputs& in, const Outputs& out) {
    std::size_t i = 0;
    const auto put = [&](bool holds) {
      for (std::size_t cell = fields_[i].first; cell <= fields_[i].last; ++cell) {
        compared_[cell] = holds;
        left_out_[cell] += holds ? 0 : 1;
      }
      ++i;
    };
    for (const auto& one : registers_compared_of<Word>(p, s)) put(one.holds);
    for (const auto& one : outputs_compared_of<Word>(p, s, in, out)) put(one.holds);
  }

  /// Whether a cell of the records is compared: register i, or output i - Registers::size.
  constexpr bool operator[](std::size_t i) const {
    if constexpr (any) return compared_[i];
    return true;
  }
  /// The same of cell i of those that the shape has, the registers' and then the outputs'.
  bool of_cell(std::size_t i) const {
    if constexpr (any) return compared_[places_[i]];
    return true;
  }
  /// Of each of these, on how many clocks it was left out; empty for a design that compares all
  /// always.
  std::vector<std::uint64_t> left_out() const {
    std::vector<std::uint64_t> all;
    if constexpr (any) {
      for (const std::size_t place : places_) all.push_back(left_out_[place]);
    }
    return all;
  }

 private:
  struct Range {
    std::size_t first, last;  ///< cells of a field; both are in it
  };

  template <class Record>
  void add_places(const Params& p, std::size_t first) {
    const auto fields = Record::fields(p);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].width != 0) places_.push_back(first + i);
    }
  }
  template <class Record>
  void find(const Params& p, const char* what, std::string_view name, std::size_t first) {
    const auto fields = Record::fields(p);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].name != name) continue;
      std::size_t last = i;
      while (last + 1 < fields.size() && fields[last + 1].name == name) ++last;
      fields_.push_back({first + i, first + last});
      return;
    }
    throw InputError(std::string(Design::name) + ": compared() names " + std::string(name) +
                     ", which is no " + what + " of its tables");
  }

  std::array<bool, any ? size : 0> compared_{};
  std::array<std::uint64_t, any ? size : 0> left_out_{};
  std::vector<Range> fields_;        // in the order of compared()
  std::vector<std::size_t> places_;  // of the cells that the shape has
};

}  // namespace cosim
