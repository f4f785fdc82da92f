// Benches with the model in the RTL's place, right at the smallest width and wrong at the largest
// from one clock on: so that the program has a mismatch to show.
// Needs: linear, circular
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "tb/sim/bench.h"
#include "tests/designs/circular/records.h"
#include "tests/designs/linear/records.h"
#include "tests/support/model_adapter.h"

namespace cosim {
namespace {

/// From clock `first` on, the lowest bit of register `index` is turned over.
template <class D, typename D::Params P, std::uint64_t first, std::size_t index>
class FaultyAdapter : public test::ModelAdapter<D, P> {
  using Base = test::ModelAdapter<D, P>;
  using Registers = typename D::template Registers<Word>;

 public:
  explicit FaultyAdapter(std::uint32_t power_up) : Base(power_up) {
    if (std::getenv("COSIM_FAULTY_THROWS") != nullptr) throw 7;
  }
  void eval(bool clk) override {
    edges_ += clk ? 1 : 0;
    if (const char* file = std::getenv("COSIM_FAULTY_LOOPS"); file != nullptr && edges_ > first) {
      std::ofstream(file) << "it loops\n";
      while (true) pause();
    }
    Base::eval(clk);
  }
  Registers registers() const override {
    auto words = to_words(Base::registers());
    if (edges_ > first) words[index] ^= 1;  // edge 1 is the reset's
    return from_words<Registers>(words);
  }

 private:
  std::uint64_t edges_ = 0;
};

}  // namespace

const std::vector<std::unique_ptr<AnyBench>>& benches() {
  static const auto list = [] {
    using Linear = linear::Design;
    using Circular = circular::Design;
    constexpr linear::Params narrow = linear::of(5, 2), wide = linear::of(32, 26);
    constexpr std::size_t counter4 = 3, ct7 = 3;
    std::vector<std::unique_ptr<AnyBench>> all;
    const auto add = [&]<class D>(const DutMaker<D>& dut) {
      all.push_back(std::make_unique<DesignBench<D>>(dut));
    };
    add(dut_maker<test::ModelAdapter<Linear, narrow>>());
    add(dut_maker<FaultyAdapter<Linear, wide, 20, counter4>>());
    add(dut_maker<test::ModelAdapter<Circular, circular::of_width(4)>>());
    add(dut_maker<FaultyAdapter<Circular, circular::of_width(32), 20, ct7>>());
    return all;
  }();
  return list;
}

}  // namespace cosim
