// The adapter of a design whose nets have any name and lie anywhere in the hierarchy: each field is
// found by its net when an instance is made. For a class Verilated with --vpi --public-flat-rw.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/core/design.h"
#include "model/core/reset.h"
#include "tb/dut/adapter.h"
#include "tb/dut/said.h"

namespace cosim {

/// Where the value of a cell lies: in 1, 2, 4 or 8 bytes that hold nothing else, or in some bits of
/// a wide net. One that the shape does not have lies nowhere, and is 0.
struct Net {
  void* data = nullptr;
  int bytes = 0;           ///< 0: not whole bytes
  int low = 0, width = 0;  ///< the bits, where it is not whole bytes

  Word get() const {
    switch (bytes) {
      case 1:
        return *static_cast<const std::uint8_t*>(data);
      case 2:
        return *static_cast<const std::uint16_t*>(data);
      case 4:
        return *static_cast<const std::uint32_t*>(data);
      case 8:
        return static_cast<Word>(*static_cast<const std::uint64_t*>(data));
      default:
        return width == 0 ? 0 : get_bits();
    }
  }
  void set(Word value) const {
    switch (bytes) {
      case 1:
        *static_cast<std::uint8_t*>(data) = static_cast<std::uint8_t>(value);
        break;
      case 2:
        *static_cast<std::uint16_t*>(data) = static_cast<std::uint16_t>(value);
        break;
      case 4:
        *static_cast<std::uint32_t*>(data) = static_cast<std::uint32_t>(value);
        break;
      case 8:
        *static_cast<std::uint64_t*>(data) = static_cast<std::uint64_t>(value);
        break;
      default:
        if (width != 0) set_bits(value);
    }
  }

 private:
  Word get_bits() const;
  void set_bits(Word value) const;
};

/// What a design says of its pins.
struct Ports {
  std::string title;  ///< of the shape, for errors
  const char* clock;  ///< the pin's name
  std::vector<Field> inputs, outputs;
  const char* extra = "";  ///< an input that no table names, or ""
};

/// The cells of the pins of the top module in the order of `ports`: inputs, then outputs, then the
/// clock. InputError if a port of the RTL, or a bit of one, is in neither table, if one in a table
/// is no such port, and if a width differs.
std::vector<Net> find_ports(VerilatedContext& context, const Ports& ports);
/// The cells of the design's registers and memories. InputError if there is no net of that path and
/// width.
std::vector<Net> find_registers(VerilatedContext& context, const std::string& title,
                                std::span<const Field> cells);

/// `Trait` has Design, params, and the names of the shape and of the clock: title, clock.
template <class Top, class Trait>
class NamedAdapter : public VerilatedInstance<Top, has_clear<typename Trait::Design>> {
  using Base = VerilatedInstance<Top, has_clear<typename Trait::Design>>;
  template <class Record>
  using Nets = std::array<Net, Record::size>;

 public:
  using Design = typename Trait::Design;
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using Registers = typename Design::template Registers<Word>;
  static constexpr typename Design::Params params = Trait::params;

  explicit NamedAdapter(std::uint32_t power_up) : Base(power_up) {
    const auto in = Inputs::fields(params);
    const auto out = Outputs::fields(params);
    Ports ports{Trait::title, Trait::clock, {in.begin(), in.end()}, {out.begin(), out.end()}};
    if constexpr (requires { Trait::extra_input; }) ports.extra = Trait::extra_input;
    const auto nets = find_ports(this->context(), ports);
    for (std::size_t i = 0; i < in.size(); ++i) inputs_[i] = nets[i];
    for (std::size_t i = 0; i < out.size(); ++i) outputs_[i] = nets[in.size() + i];
    clock_ = nets.back();
    const auto held = Registers::fields(params);
    const auto registers = find_registers(this->context(), Trait::title, held);
    std::copy(registers.begin(), registers.end(), registers_.begin());
  }

  /// Sets a register's net. Behind the first eval, which sets initial values; to be followed by
  /// another one.
  void load(const Field& field, Word value) {
    if (!settled_) eval(false);
    const auto held = Registers::fields(params);
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (held[i].index == field.index && std::string_view(held[i].name) == field.name) {
        registers_[i].set(value);
      }
    }
  }
  void eval(bool clk) {
    settled_ = true;
    clock_.set(clk ? 1 : 0);
    this->top().eval();
    if (rtl_said) [[unlikely]]
      hear();
  }
  const RtlSaid* said() const { return said_ ? &*said_ : nullptr; }
  void begin() {
    said_.reset();
    Base::begin();
  }
  void drive(const Inputs& in) {
    for_each_cell<Inputs>([&](auto cell, std::size_t i) { inputs_[i].set(cell(in)); });
  }
  std::vector<Signal> signals() const { return Base::signals(Trait::clock); }
  Outputs outputs() const { return read<Outputs>(outputs_); }
  Registers registers() const { return read<Registers>(registers_); }

 private:
  [[gnu::noinline, gnu::cold]] void hear() {
    RtlSaid now = take_said();
    if (!said_) said_ = std::move(now);
  }
  template <class Record>
  static Record read(const Nets<Record>& nets) {
    Record r;
    for_each_cell<Record>([&](auto cell, std::size_t i) { cell(r) = nets[i].get(); });
    return r;
  }

  Nets<Inputs> inputs_;
  Nets<Outputs> outputs_;
  Nets<Registers> registers_;
  Net clock_;
  bool settled_ = false;
  std::optional<RtlSaid> said_;
};

}  // namespace cosim
