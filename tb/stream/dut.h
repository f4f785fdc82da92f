// The RTL of a design with a stream model: an instance whose ports are found by name.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tb/dut/named_adapter.h"
#include "tb/dut/open_dut.h"
#include "tb/stream/shape.h"

namespace cosim {

/// An instance of a Verilated class, or what a test puts in its place.
class StreamDut {
 public:
  virtual ~StreamDut() = default;
  /// Where the cells of the ports lie: of `inputs`, of `outputs`, then the clock. InputError where
  /// the RTL has others.
  virtual std::vector<Net> nets(const Ports& ports) = 0;
  /// Settles everything that depends on the inputs and the clock.
  virtual void eval() = 0;
  /// Powers up again from `power_up`: then it is as a new instance would be, with its nets where
  /// they were. False where that cannot be, and it stays as it is. Where coverage is counted and it
  /// `is_reset` next, its registers keep their values, for a new instance registers its points
  /// anew.
  virtual bool restart(std::uint32_t /*power_up*/, bool /*is_reset*/) { return false; }
  /// The reset has ended.
  virtual void begin() {}
  /// Empty if the instance does not show them.
  virtual std::vector<Signal> signals() const { return {}; }
};

template <class Top>
class VerilatedStreamDut : public StreamDut, protected VerilatedInstance<Top, false> {
  using Base = VerilatedInstance<Top, false>;

 public:
  explicit VerilatedStreamDut(std::uint32_t power_up) : Base(power_up) {}
  std::vector<Net> nets(const Ports& ports) override {
    return find_ports(ports_of(this->top()), ports);
  }
  void eval() override { this->top().eval(); }
  bool restart(std::uint32_t power_up, bool is_reset) override {
    if constexpr (coverage::measured) return is_reset;
    return Base::restart(power_up);
  }
  void begin() override { Base::begin(); }
};

/// One whose whole hierarchy is open.
class OpenStreamDut final : public StreamDut {
 public:
  OpenStreamDut(const OpenClass& of, std::uint32_t power_up)
      : clock_(of.clock), instance_(of.make(power_up)) {}
  std::vector<Net> nets(const Ports& ports) override {
    return find_ports(instance_->ports(), ports);
  }
  void eval() override { instance_->eval(); }
  void begin() override { instance_->begin(); }
  std::vector<Signal> signals() const override { return signals_of(instance_->context(), clock_); }

 private:
  const char* clock_;
  std::unique_ptr<OpenInstance> instance_;
};

/// The ports that a shape names, as find_ports() takes them; it outlives them.
Ports ports_of(const StreamShape& shape);

/// A port of one bit, which has a byte of its own, or none, which is 0.
class BitNet {
 public:
  BitNet() = default;
  explicit BitNet(const Net& net) : at_(static_cast<std::uint8_t*>(net.data)) {}
  bool get() const { return at_ != nullptr && *at_ != 0; }
  void set(bool value) const {
    if (at_ != nullptr) *at_ = value ? 1 : 0;
  }

 private:
  std::uint8_t* at_ = nullptr;
};

/// The ports of an interface in one instance.
struct InterfaceNets {
  BitNet valid, ready, credit, done;
  std::vector<Net> cells;
  std::vector<Net> drives = {}, reads = {};  ///< of a driver of its own, its cells
};

/// All ports of one instance.
struct StreamNets {
  StreamNets(const StreamShape& shape, StreamDut& dut);

  std::vector<InterfaceNets> in, out;
  std::vector<std::vector<Net>> pins;  ///< words of 64 bits each
  std::vector<BitNet> clocks;
};

}  // namespace cosim
