// The adapter of a Verilated class: the ports are its members, and the registers, which have any
// name and lie anywhere in the hierarchy, are in its table of public nets. Where each field lies is
// found when the first instance is made: Verilator keeps all nets of an instance in one object, so
// that a net lies at the same place in each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/core/design.h"
#include "model/core/reset.h"
#include "model/core/synchronizer.h"
#include "tb/dut/adapter.h"
#include "tb/dut/dut.h"
#include "tb/dut/nets.h"
#include "tb/dut/said.h"

namespace cosim {

/// Where the cells of a record lie in an instance of Top, from its first byte on. The compiler
/// knows it of those that known_nets has; the others are parts of nets, words of memories, or in a
/// class whose whole hierarchy is open.
template <class Top, class Record, const auto& fields, bool are_ports>
class CellPlaces {
 public:
  /// Those that `nets` has of the instance that begins at `base`. std::logic_error where it has one
  /// elsewhere than the compiler knows.
  CellPlaces(const std::byte* base, const Net* nets) {
    for (std::size_t i = 0; i < Record::size; ++i) {
      nets_[i] = nets[i];
      if (nets_[i].data != nullptr) at_[i] = static_cast<std::byte*>(nets_[i].data) - base;
      if (known[i] >= 0 && known[i] != at_[i]) {
        throw std::logic_error(std::string(fields[i].net) + " is not where its class has it");
      }
    }
  }

  Record read(std::byte* base) const {
    Record r;
    for_each_member<Record>([&](auto member, auto first) {
      if constexpr (elements<decltype(member)> != 0) {
        for (int i = 0; i < elements<decltype(member)>; ++i) {
          (r.*member)[i] = net(base, first + static_cast<std::size_t>(i)).get();
        }
      } else if constexpr (known[first] >= 0) {
        r.*member = static_cast<Word>(number<decltype(first)::value>(base));
      } else {
        r.*member = net(base, first).get();
      }
    });
    return r;
  }
  void write(std::byte* base, const Record& r) const {
    for_each_member<Record>([&](auto member, auto first) {
      if constexpr (elements<decltype(member)> != 0) {
        for (int i = 0; i < elements<decltype(member)>; ++i) {
          net(base, first + static_cast<std::size_t>(i)).set((r.*member)[i]);
        }
      } else if constexpr (known[first] >= 0) {
        auto& to = number<decltype(first)::value>(base);
        to = static_cast<std::remove_reference_t<decltype(to)>>(r.*member);
      } else {
        net(base, first).set(r.*member);
      }
    });
  }
  /// The cell of that number in the instance.
  Net net(std::byte* base, std::size_t cell) const {
    Net n = nets_[cell];
    if (n.data != nullptr) n.data = base + at_[cell];
    return n;
  }

 private:
  template <class Member>
  static constexpr int elements = detail::elements_at<Record, Member>;

  // By cell; -1: not known.
  static constexpr auto known = known_places<Top>(fields, are_ports);
  // What Verilator keeps a net in, by its width.
  template <std::size_t cell>
  static auto& number(std::byte* base) {
    constexpr int width = fields[cell].width;
    using Number = std::conditional_t<
        width <= 8, std::uint8_t,
        std::conditional_t<width <= 16, std::uint16_t,
                           std::conditional_t<width <= 32, std::uint32_t, std::uint64_t>>>;
    return *reinterpret_cast<Number*>(base + known[cell]);
  }

  std::array<Net, Record::size> nets_{};  // of the instance that was looked at
  std::array<std::ptrdiff_t, Record::size> at_{};
};

/// `Trait` has Design, params, and the names of the shape and of the clock: title, clock ("": it
/// has none, or several, in clocks as Ports has them).
template <class Top, class Trait>
class NamedAdapter : public Dut<typename Trait::Design>,
                     public VerilatedInstance<Top, has_reset<typename Trait::Design>, true> {
  using Base = VerilatedInstance<Top, has_reset<typename Trait::Design>, true>;

 public:
  using Design = typename Trait::Design;
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using Registers = typename Design::template Registers<Word>;
  static constexpr typename Design::Params params = Trait::params;

  explicit NamedAdapter(std::uint32_t power_up) : Base(power_up) {}

  void eval([[maybe_unused]] bool clk) final {
    if constexpr (has_clock) {
      constexpr std::ptrdiff_t known = known_place<Top>(Trait::clock, true, 1);
      const std::ptrdiff_t clock = known >= 0 ? known : places_.clock;
      *reinterpret_cast<std::uint8_t*>(base_ + clock) = clk ? 1 : 0;
    }
    for_each_clock([&](auto member, auto cell) {
      const bool falls = driven[cell].edge == Edge::falling;
      places_.inputs.net(base_, cell).set((clk && given_.*member != 0) != falls ? 1 : 0);
    });
    this->top().eval();
    if (rtl_said) [[unlikely]]
      hear();
  }
  const RtlSaid* said() const final { return said_ ? &*said_ : nullptr; }
  std::vector<Signal> signals() const final { return Base::signals(Trait::clock); }
  void begin() final {
    said_.reset();
    Base::begin();
  }
  /// Of several clocks the next eval() makes levels.
  void drive(const Inputs& in) final {
    places_.inputs.write(base_, in);
    if constexpr (clocks_of<Design> != 0) given_ = in;
  }
  Outputs outputs() const final { return places_.outputs.read(base_); }
  Registers registers() const final { return places_.registers.read(base_); }
  bool turns() const override { return true; }
  void turn(const Registers& bits) final {
    const auto words = to_words(bits);
    for (std::size_t i = 0; i < places_.sources.size(); ++i) {
      if (words[i] == 0) continue;
      const Source& source = places_.sources[i];
      Net n = source.net;
      n.data = base_ + source.at;
      n.set(n.get() ^ words[i]);
    }
  }

 private:
  static constexpr bool has_clock = *Trait::clock != '\0';
  static constexpr auto driven = Inputs::fields(params);
  static constexpr auto seen = Outputs::fields(params);
  static constexpr auto held = Registers::fields(params);

  // What carries a register's value may be another net than the register.
  struct Source {
    Net net;
    std::ptrdiff_t at;
  };
  struct Places {
    CellPlaces<Top, Inputs, driven, true> inputs;
    CellPlaces<Top, Outputs, seen, true> outputs;
    CellPlaces<Top, Registers, held, false> registers;
    std::ptrdiff_t clock;
    std::vector<Source> sources;  // of a design with synchronizers, by cell
  };
  // The member of each input that is a clock, and its number.
  template <class Visit>
  static constexpr void for_each_clock([[maybe_unused]] Visit visit) {
    if constexpr (clocks_of<Design> != 0) {
      for_each_member<Inputs>([&](auto member, auto cell) {
        if constexpr (driven[decltype(cell)::value].edge != Edge::none) visit(member, cell);
      });
    }
  }
  static std::byte* base_of(Top& top) { return reinterpret_cast<std::byte*>(top.rootp); }
  [[gnu::cold]] static Places find(Top& top, VerilatedContext& context) {
    const std::byte* base = base_of(top);
    Ports given{
        Trait::title, Trait::clock, {driven.begin(), driven.end()}, {seen.begin(), seen.end()}};
    if constexpr (requires { Trait::extra_input; }) given.extra = Trait::extra_input;
    if constexpr (requires { Trait::clocks; }) given.clocks = Trait::clocks;
    for (const char* pattern : Design::unobserved) given.unobserved.emplace_back(pattern);
    const auto ports = find_ports(ports_of(top), given);
    const auto registers = find_registers(context, Trait::title, held);
    return {{base, ports.data()},
            {base, ports.data() + driven.size()},
            {base, registers.data()},
            has_clock ? static_cast<std::byte*>(ports.back().data) - base : 0,
            sources(base, context)};
  }
  static std::vector<Source> sources(const std::byte* base, VerilatedContext& context) {
    std::vector<Source> all;
    if constexpr (synchronizers_of<Design> != 0) {
      for (const Net& n : find_registers(context, Trait::title, held, Trait::registers)) {
        all.push_back({n, n.data == nullptr ? 0 : static_cast<std::byte*>(n.data) - base});
      }
    }
    return all;
  }
  static const Places& places(Top& top, VerilatedContext& context) {
    static const Places all = find(top, context);
    return all;
  }

  [[gnu::noinline, gnu::cold]] void hear() {
    RtlSaid now = take_said();
    if (!said_) said_ = std::move(now);
  }

  const Places& places_ = places(this->top(), this->context());
  std::byte* base_ = base_of(this->top());
  Inputs given_{};  // where there are several clocks
  std::optional<RtlSaid> said_;
};

}  // namespace cosim
