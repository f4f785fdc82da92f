#include "tb/sim/directed.h"

#include <cxxabi.h>
#include <fmt/core.h>

#include <cstdlib>
#include <string_view>

#include "model/core/input_error.h"
#include "tb/nets/legal.h"
#include "tb/show/picture.h"
#include "tb/sim/bench.h"
#include "tb/sim/failure.h"
#include "tb/sim/stimulus_text.h"
#include "tb/sim/wanted.h"
#include "tb/util/draft.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

FailureOptions where_kept() {
  FailureOptions options;
  if (const char* folder = std::getenv("COSIM_FAILURES")) options.root = folder;
  return options;
}

}  // namespace

const AnyBench& directed_choice(const std::vector<const AnyBench*>& benches,
                                std::type_index model) {
  for (const AnyBench* bench : benches) {
    if (bench->model() == model) return *bench;
  }
  std::string name = model.name();
  int status = 0;
  if (char* plain = abi::__cxa_demangle(model.name(), nullptr, nullptr, &status)) {
    name = plain;
    std::free(plain);
  }
  throw InputError(name + ": no design was built with it as its model in this configuration");
}

DirectedRecord::DirectedRecord(const AnyBench& bench, std::uint32_t power_up) : bench_(bench) {
  const PresentTest test = present_test == nullptr ? PresentTest{} : present_test();
  name_ = test.name.empty() ? "directed test" : test.name;
  stimulus_.machine = bench.title();
  stimulus_.origin = name_;
  stimulus_.power_up = power_up;
}

std::unique_ptr<AnyByHand> DirectedRecord::begin() const {
  return bench_.by_hand(stimulus_.power_up);
}

void DirectedRecord::clock(const std::vector<Word>& inputs, const char* broken) {
  IllegalClock{clocks(), broken}.refuse(bench_.title());
  stimulus_.clocks.push_back(inputs);
}

void DirectedRecord::differs() {
  kept_ = true;
  const Run run = bench_.replay(stimulus_);
  if (!run.mismatch) throw std::logic_error("the clocks of a difference do not show it again");
  std::string text = to_text(*run.mismatch) + '\n';
  try {
    text += to_text(leave_failure(bench_, name_, *run.mismatch, where_kept()));
  } catch (const InputError& error) {
    text += fmt::format("the failure is not kept: {}\n", error.what());
  }
  throw Differ(text);
}

void DirectedRecord::keep() const {
  const FailureOptions options = where_kept();
  Draft draft(options.root, failure_name(bench_, name_));
  draft.write("stimulus.stim", to_text(stimulus_, bench_));
  bench_.draw_wave((draft.folder() / "wave.fst").string(), stimulus_, {stimulus_.clocks.size(), 0});
  draft.finish_replacing();
  fmt::print("RTL and model are the same on all {}\nkept in: {}\n",
             count(stimulus_.clocks.size(), "clock"), draft.target().string());
}

void DirectedRecord::finish() noexcept {
  try {
    draw_if_wanted(bench_, [this] { return stimulus_; });
    const bool failed = present_test != nullptr && present_test().failed;
    const bool thrown = std::uncaught_exceptions() > exceptions_;
    if (kept_ || !(failed || thrown) || stimulus_.clocks.empty()) return;
    kept_ = true;
    keep();
  } catch (const std::exception& error) {
    complain(fmt::format("the failure is not kept: {}", error.what()));
  }
}

}  // namespace cosim
