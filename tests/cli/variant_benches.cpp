// The one machine to run on is RTL with a planted fault, DESIGN/KIND/NAME of $COSIM_VARIANT, in
// tests/designs/DESIGN/rtl/variants/KIND/NAME.cmake.
#include <cstdlib>

#include "model/core/input_error.h"
#include "tests/rtl/variant.h"
#include "tests/support/designs.h"

namespace cosim {
namespace {

template <class Design>
void add(std::vector<std::unique_ptr<AnyBench>>& all, const std::string& name) {
  for (const auto& v : test::variants<Design>()) {
    if (Design::name + ("/" + v.name) == name) all.push_back(v.make_bench());
  }
}

}  // namespace

const std::vector<std::unique_ptr<AnyBench>>& benches() {
  static const auto list = [] {
    const char* wanted = std::getenv("COSIM_VARIANT");
    const std::string name = wanted != nullptr ? wanted : "";
    std::vector<std::unique_ptr<AnyBench>> all;
    test::for_each_design([&]<class Design>() { add<Design>(all, name); });
    if (all.empty()) throw InputError("COSIM_VARIANT: there is no variant '" + name + "'");
    return all;
  }();
  return list;
}

}  // namespace cosim
