// The adapter of a design whose nets have any name and lie anywhere in the hierarchy: each field is
// found by its net when an instance is made. For a class Verilated with --vpi --public-flat-rw.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/core/design.h"
#include "tb/dut/adapter.h"

namespace cosim {

/// Where the value of a net lies: 1, 2, 4 or 8 bytes, as its width needs.
struct Net {
  void* data = nullptr;
  int bytes = 0;

  Word get() const {
    switch (bytes) {
      case 1:
        return *static_cast<const std::uint8_t*>(data);
      case 2:
        return *static_cast<const std::uint16_t*>(data);
      case 4:
        return *static_cast<const std::uint32_t*>(data);
      default:
        return static_cast<Word>(*static_cast<const std::uint64_t*>(data));
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
      default:
        *static_cast<std::uint64_t*>(data) = static_cast<std::uint64_t>(value);
    }
  }
};

/// What a design says of its pins.
struct Ports {
  std::string title;  ///< of the shape, for errors
  const char* clock;  ///< the pin's name
  std::vector<Field> inputs, outputs;
};

/// The pins of the top module in the order of `ports`: inputs, then outputs, then the clock.
/// InputError if a port of the RTL is in neither table, if one in a table is no such port, and if a
/// width differs.
std::vector<Net> find_ports(VerilatedContext& context, const Ports& ports);
/// A register of the design. InputError if there is no net of that path and width.
Net find_register(VerilatedContext& context, const std::string& title, const Field& field);

/// `Trait` has Design, params, and the names of the shape and of the clock: title, clock.
template <class Top, class Trait>
class NamedAdapter : public VerilatedInstance<Top> {
  template <class Record>
  using Nets = std::array<Net, Record::size>;

 public:
  using Design = typename Trait::Design;
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using Registers = typename Design::template Registers<Word>;
  static constexpr typename Design::Params params = Trait::params;

  explicit NamedAdapter(std::uint32_t power_up) : VerilatedInstance<Top>(power_up) {
    const auto in = Inputs::fields(params);
    const auto out = Outputs::fields(params);
    const auto nets =
        find_ports(this->context(),
                   {Trait::title, Trait::clock, {in.begin(), in.end()}, {out.begin(), out.end()}});
    for (std::size_t i = 0; i < in.size(); ++i) inputs_[i] = nets[i];
    for (std::size_t i = 0; i < out.size(); ++i) outputs_[i] = nets[in.size() + i];
    clock_ = nets.back();
    const auto held = Registers::fields(params);
    for (std::size_t i = 0; i < held.size(); ++i) {
      registers_[i] = find_register(this->context(), Trait::title, held[i]);
    }
  }

  void eval(bool clk) {
    clock_.set(clk ? 1 : 0);
    this->top().eval();
  }
  void drive(const Inputs& in) {
    for_each_member<Inputs>([&](auto member, std::size_t i) { inputs_[i].set(in.*member); });
  }
  Outputs outputs() const { return read<Outputs>(outputs_); }
  Registers registers() const { return read<Registers>(registers_); }

 private:
  template <class Record>
  static Record read(const Nets<Record>& nets) {
    Record r;
    for_each_member<Record>([&](auto member, std::size_t i) { r.*member = nets[i].get(); });
    return r;
  }

  Nets<Inputs> inputs_;
  Nets<Outputs> outputs_;
  Nets<Registers> registers_;
  Net clock_;
};

}  // namespace cosim
