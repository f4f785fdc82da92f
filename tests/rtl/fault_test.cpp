#include <gtest/gtest.h>
#include "model/linear/machine.h"
#include "model/linear/host.h"
#include "tests/rtl/variant.h"
namespace cosim { namespace {
TEST(X, y) {
  for (auto& v : variants<linear::Design>()) {
    Run r;
    r = v->bench().run_hostile({});
    std::cout << v->name() << " " << v->what() << " " << (r.mismatch ? to_text(*r.mismatch) : "none") << "\n";
  }
}
}}
