// A variant behind its adapter: what the sources made by CMake instantiate.
#pragma once

#include "tests/rtl/variant.h"

namespace cosim::test {

template <class Adapter>
class AdapterMachine final : public Machine<typename Adapter::Design> {
  using Base = Machine<typename Adapter::Design>;

 public:
  explicit AdapterMachine(std::uint32_t power_up) : adapter_(power_up) {}
  void drive(const typename Base::Inputs& in) override { adapter_.drive(in); }
  void eval(bool clk) override { adapter_.eval(clk); }
  typename Base::Outputs outputs() const override { return adapter_.outputs(); }
  typename Base::Registers registers() const override { return adapter_.registers(); }

 private:
  Adapter adapter_;
};

/// Inputs that are known beforehand.
template <class Design>
struct Scripted {
  std::span<const typename Design::template Inputs<Word>> left;

  bool next(typename Design::template Inputs<Word>& in,
            const typename Design::template Outputs<Word>&) {
    if (left.empty()) return false;
    in = left.front();
    left = left.subspan(1);
    return true;
  }
};

template <class Adapter>
class AdapterVariant final : public Variant<typename Adapter::Design> {
  using Design = typename Adapter::Design;
  using Base = Variant<Design>;

 public:
  using Base::Base;
  const Bench<Design>& bench() const override { return bench_; }
  std::unique_ptr<AnyBench> make_bench() const override {
    return std::make_unique<AdapterBench<Adapter>>();
  }
  Run run_inputs(std::span<const typename Base::Inputs> inputs,
                 std::uint32_t power_up) const override {
    return run<Adapter>(Scripted<Design>{inputs}, power_up);
  }
  std::unique_ptr<Machine<Design>> machine(std::uint32_t power_up) const override {
    return std::make_unique<AdapterMachine<Adapter>>(power_up);
  }

 private:
  AdapterBench<Adapter> bench_;
};

template <class Adapter>
void add_variant(const char* name, const char* what) {
  using Design = typename Adapter::Design;
  variant_list<Design>().push_back(std::make_unique<AdapterVariant<Adapter>>(name, what));
}

}  // namespace cosim::test
