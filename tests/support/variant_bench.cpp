#include "tests/rtl/variant_of.h"

#include "tb/sim/design_bench.h"
#include "tests/support/designs.h"

namespace cosim::test {

template <class Design>
std::unique_ptr<Bench<Design>> bench_of(const OpenClass& variant,
                                        const typename Design::Params& p) {
  return std::make_unique<DesignBench<Design>>(open_maker<Design>(variant, p));
}

// Never called: here the compiler makes those of all designs.
void make_benches();

void make_benches() {
  for_each_design([]<class Design>() { bench_of<Design>({}, {}); });
}

}  // namespace cosim::test
