// An instance of a class that is Verilated with the whole hierarchy open (--vpi --public-flat-rw),
// whatever the class.
#pragma once

#include <cstdint>
#include <vector>

#include "tb/dut/adapter.h"
#include "tb/dut/port_net.h"

namespace cosim {

class OpenInstance {
 public:
  virtual ~OpenInstance() = default;
  virtual VerilatedContext& context() = 0;
  virtual std::vector<PortNet> ports() = 0;
  virtual void eval() = 0;
  /// The reset has ended.
  virtual void begin() = 0;
};

template <class Top, bool is_reset>
class OpenInstanceOf final : public OpenInstance, VerilatedInstance<Top, is_reset> {
  using Base = VerilatedInstance<Top, is_reset>;

 public:
  explicit OpenInstanceOf(std::uint32_t power_up) : Base(power_up) {}
  VerilatedContext& context() override { return Base::context(); }
  std::vector<PortNet> ports() override { return ports_of(this->top()); }
  void eval() override { this->top().eval(); }
  void begin() override { Base::begin(); }
};

/// What a library of such classes has for each, open_ID. The caller owns what it gives.
using MakeOpen = OpenInstance* (*)(std::uint32_t power_up);

}  // namespace cosim
