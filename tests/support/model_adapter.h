// The golden model in the RTL's place: an adapter without Verilator, for every stimulus, sweep and
// check of the testbench to run on the model alone.
#pragma once

#include <cstdint>

#include "tb/sim/design_bench.h"

namespace cosim::test {

template <class D, typename D::Params P>
class ModelAdapter : public Dut<D> {
 public:
  static constexpr typename D::Params params = P;

  explicit ModelAdapter(std::uint32_t /*power_up*/) {}
  void drive(const typename D::template Inputs<Word>& in) override { in_ = in; }
  void eval(bool clk) override {
    if (clk && !clk_) state_ = D::next(P, state_, in_).state;
    clk_ = clk;
  }
  typename D::template Outputs<Word> outputs() const override {
    return D::next(P, state_, in_).outputs;
  }
  typename D::template Registers<Word> registers() const override {
    return D::registers(P, state_);
  }

 private:
  typename D::template State<Word> state_ = reset_state_of<D, Word>(P);
  typename D::template Inputs<Word> in_{};
  bool clk_ = false;
};

/// The bench with the model of that shape on both sides.
template <class D, typename D::Params P>
const Bench<D>& model_bench() {
  static const DesignBench<D> bench(dut_maker<ModelAdapter<D, P>>());
  return bench;
}

}  // namespace cosim::test
