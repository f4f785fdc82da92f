// A DUT whose class is open as a whole, for replays, waves and tests. The class is data here, and
// its cells are looked up by name in each instance: what stands below is compiled once for a
// design, not for each shape.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "model/core/design.h"
#include "model/core/reset.h"
#include "tb/dut/adapter.h"
#include "tb/dut/dut.h"
#include "tb/dut/nets.h"
#include "tb/dut/open_instance.h"
#include "tb/dut/said.h"

namespace cosim {

/// The classes of a design whose whole hierarchy is open, as a library of its own. Only replays and
/// waves need it: it is built when one first asks for it.
struct OpenLibrary {
  const char* file;    ///< its path; the name has a hash of what it is made of
  const char* target;  ///< what makes it in the build folder
  const char *cmake, *build_folder;
};

/// What makes instances of the shape's class; `id` is that of the shape's Trait. Any thread may
/// call it. InputError where the library cannot be built, and where the RTL is no longer what the
/// program was built with.
MakeOpen open_maker_in(const OpenLibrary& library, const char* id);

/// A class, and what its shape's Trait says of it: see NamedAdapter.
struct OpenClass {
  std::unique_ptr<OpenInstance> (*make)(std::uint32_t power_up);
  const char *title, *clock;
  const char* registers = "";    ///< the text of cosim_rtl
  std::string_view clocks = "";  ///< as Ports has them
  bool loads = true;             ///< registers can be set
};

template <class Trait>
OpenClass open_class_by(std::unique_ptr<OpenInstance> (*make)(std::uint32_t power_up)) {
  OpenClass all{make, Trait::title, Trait::clock, Trait::registers};
  if constexpr (requires { Trait::clocks; }) all.clocks = Trait::clocks;
  return all;
}
/// Top, which the program has.
template <class Top, class Trait>
OpenClass open_class() {
  return open_class_by<Trait>([](std::uint32_t power_up) -> std::unique_ptr<OpenInstance> {
    return std::make_unique<OpenInstanceOf<Top, has_reset<typename Trait::Design>>>(power_up);
  });
}
/// That of the shape in `library`.
template <class Trait, const OpenLibrary& library>
OpenClass open_class_in() {
  return open_class_by<Trait>([](std::uint32_t power_up) {
    static const MakeOpen make = open_maker_in(library, Trait::id);
    return std::unique_ptr<OpenInstance>(make(power_up));
  });
}

template <class Design>
class OpenDut final : public Dut<Design> {
 public:
  using typename Dut<Design>::Inputs;
  using typename Dut<Design>::Outputs;
  using typename Dut<Design>::Registers;
  using Params = typename Design::Params;

  OpenDut(const OpenClass& of, const Params& p, std::uint32_t power_up)
      : class_(of), params_(p), instance_(of.make(power_up)) {
    const auto driven = Inputs::fields(p);
    const auto seen = Outputs::fields(p);
    Ports given{of.title,
                of.clock,
                {driven.begin(), driven.end()},
                {seen.begin(), seen.end()},
                "",
                std::string(of.clocks)};
    for (const char* pattern : Design::unobserved) given.unobserved.emplace_back(pattern);
    ports_ = find_ports(instance_->ports(), given);
    registers_ = find_registers(instance_->context(), of.title, Registers::fields(p));
    for (std::size_t i = 0; i < driven.size(); ++i) {
      if (driven[i].edge != Edge::none) {
        clocks_.push_back({i, driven[i].net, driven[i].edge == Edge::falling});
      }
    }
  }

  /// Of several clocks the next eval() makes levels.
  void drive(const Inputs& in) override {
    given_ = to_words(in);
    for (std::size_t i = 0; i < given_.size(); ++i) ports_[i].set(given_[i]);
  }
  void eval(bool clk) override {
    if (*class_.clock != '\0') ports_.back().set(clk ? 1 : 0);
    for (const Clock& c : clocks_) {
      ports_[c.input].set((clk && given_[c.input] != 0) != c.falls ? 1 : 0);
    }
    instance_->eval();
    if (!rtl_said) return;
    RtlSaid now = take_said();
    if (!said_) said_ = std::move(now);
  }
  Outputs outputs() const override { return read<Outputs>(ports_.data() + given_.size()); }
  Registers registers() const override { return read<Registers>(registers_.data()); }
  /// Sets a register's net. Behind the first eval, which sets initial values; to be followed by
  /// another one.
  void load(const Field& field, Word value) override {
    const auto held = Registers::fields(params_);
    if (sources_.empty()) eval(false);
    find_sources();
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (held[i].index == field.index && std::string_view(held[i].name) == field.name) {
        sources_[i].set(value);
      }
    }
  }
  bool turns() const override { return true; }
  void turn(const Registers& bits) override {
    find_sources();
    const auto words = to_words(bits);
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] != 0) sources_[i].set(sources_[i].get() ^ words[i]);
    }
  }
  std::vector<Signal> signals() const override {
    auto all = signals_of(instance_->context(), class_.clock);
    for (const Clock& c : clocks_) {
      for (Signal& s : all) {
        if (s.name != c.name) continue;
        s.is_clock = true;
        s.takes_edge = &given_[c.input];
        s.falls = c.falls;
      }
    }
    return all;
  }
  const RtlSaid* said() const override { return said_ ? &*said_ : nullptr; }
  void begin() override {
    said_.reset();
    instance_->begin();
  }

 private:
  /// One of several.
  struct Clock {
    std::size_t input;
    std::string_view name;
    bool falls;
  };
  void find_sources() {
    if (!sources_.empty()) return;
    sources_ = find_registers(instance_->context(), class_.title, Registers::fields(params_),
                              class_.registers);
  }
  template <class Record>
  static Record read(const Net* nets) {
    Record r;
    for_each_cell<Record>([&](auto cell, std::size_t i) { cell(r) = nets[i].get(); });
    return r;
  }

  OpenClass class_;
  Params params_;
  std::unique_ptr<OpenInstance> instance_;
  std::vector<Net> ports_;  // inputs, outputs, the clock
  std::vector<Net> registers_;
  std::vector<Net> sources_;  // what is loaded or turned over, once something is
  std::vector<Clock> clocks_;
  Words<Inputs> given_{};
  std::optional<RtlSaid> said_;
};

template <class Design>
DutMaker<Design> open_maker(const OpenClass& of, const typename Design::Params& p) {
  return {p, of.loads, [of, p](std::uint32_t power_up) -> std::unique_ptr<Dut<Design>> {
            return std::make_unique<OpenDut<Design>>(of, p, power_up);
          }};
}

}  // namespace cosim
