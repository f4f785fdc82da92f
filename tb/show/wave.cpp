#include "tb/show/wave.h"

#include <algorithm>
#include <bit>

#include "model/core/value.h"
#include "tb/show/fst.h"
#include "tb/show/view.h"

namespace cosim {
namespace {

// Opens and closes scopes so that those of `to` are open; `from` are.
void change_scope(Fst& fst, const std::vector<std::string>& from,
                  const std::vector<std::string>& to) {
  const auto [left, right] = std::mismatch(from.begin(), from.end(), to.begin(), to.end());
  for (auto i = left; i != from.end(); ++i) fst.close_scope();
  for (auto i = right; i != to.end(); ++i) fst.open_scope(*i);
}

std::vector<std::uint32_t> variables(Fst& fst, const char* scope, const WaveShape& shape,
                                     const std::vector<Bus>& buses) {
  fst.open_scope(scope);
  std::vector<std::uint32_t> handles;
  handles.reserve(buses.size());
  for (const Bus& b : buses) {
    handles.push_back(fst.variable(b.name, b.width, shape.range_of(b)));
  }
  fst.close_scope();
  return handles;
}

// The words of a wide number lie one behind the other, the lowest byte first.
static_assert(std::endian::native == std::endian::little);
void draw(Fst& fst, std::uint32_t handle, const Bus& bus, const std::vector<Word>& words) {
  fst.bytes(handle, bus.width, reinterpret_cast<const unsigned char*>(&words[bus.first]));
}

}  // namespace

Wave::Wave(const std::string& path) : path_(path), fst_(std::make_unique<Fst>(path)) {}

Wave::~Wave() = default;

void Wave::begin(const WaveShape& shape, const WaveRange& /*range*/,
                 const std::vector<Signal>& rtl) {
  shape_ = &shape;
  input_buses_ = buses_of(shape.inputs);
  buses_ = buses_of(shape.compared);
  rtl_ = rtl;
  Fst& fst = *fst_;
  fst.open_scope("cosim");
  clk_ = fst.variable("clk", 1);
  clock_ = fst.variable("clock", clock_width);
  inputs_ = variables(fst, "inputs", shape, input_buses_);
  expected_ = variables(fst, shape.sides.expected, shape, buses_);
  actual_ = variables(fst, shape.sides.actual, shape, buses_);
  fst.open_scope("mismatch");
  any_ = fst.variable("any", 1);
  for (const Bus& b : buses_) mismatch_.push_back(fst.variable(b.name, 1));
  fst.close_scope();
  if (!shape.texts.empty()) {
    fst.open_scope("text");
    for (const std::string& name : shape.texts) texts_.push_back(fst.text(name));
    fst.close_scope();
  }
  fst.open_scope("number");
  for (const Bus& b : buses_) {
    numbers_.push_back(has_number(b.field) ? fst.real(b.name) : 0);
    expected_numbers_.push_back(has_number(b.field) ? fst.real("expected_" + b.name) : 0);
  }
  fst.close_scope();
  std::vector<std::string> scope;
  for (const Probe& probe : shape.probes) {
    change_scope(fst, scope, {probe.scope});
    scope = {probe.scope};
    probes_.push_back(fst.variable(probe.name, probe.width));
    const bool both = probe.side == Probe::Side::both;
    expected_probes_.push_back(
        both ? fst.variable(std::string("expected_") + probe.name, probe.width) : 0);
  }
  change_scope(fst, scope, {});
  fst.close_scope();
  scope.clear();
  for (const Signal& s : rtl_) {
    change_scope(fst, scope, s.scope);
    scope = s.scope;
    rtl_handles_.push_back(fst.variable(s.name, s.width, s.range));
  }
  change_scope(fst, scope, {});
}

void Wave::clock(const WaveClock& now) {
  Fst& fst = *fst_;
  fst.time(now.clock * wave_period);
  fst.value(clk_, 1, 1);
  fst.value(clock_, clock_width, static_cast<Word>(now.clock));
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    draw(fst, inputs_[i], input_buses_[i], now.inputs);
  }
  for (std::size_t i = 0; i < expected_.size(); ++i) {
    const Bus& bus = buses_[i];
    draw(fst, expected_[i], bus, now.expected);
    draw(fst, actual_[i], bus, now.actual);
    fst.value(mismatch_[i], 1, now.differs_in(bus) ? 1 : 0);
    if (!has_number(bus.field)) continue;
    fst.number(numbers_[i], number_of(bus.field, now.actual[bus.first]));
    fst.number(expected_numbers_[i], number_of(bus.field, now.expected[bus.first]));
  }
  for (std::size_t i = 0; i < texts_.size(); ++i) fst.text(texts_[i], now.texts[i]);
  const auto& differs = now.differs;
  fst.value(any_, 1, std::ranges::find(differs, true) == differs.end() ? 0 : 1);
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const Probe& probe = shape_->probes[i];
    const bool expected = probe.side == Probe::Side::expected;
    fst.value(probes_[i], probe.width, expected ? now.expected_probes[i] : now.actual_probes[i]);
    if (probe.side == Probe::Side::both) {
      fst.value(expected_probes_[i], probe.width, now.expected_probes[i]);
    }
  }
  for (std::size_t i = 0; i < rtl_.size(); ++i) {
    // The clock is drawn as it looks, not as it stands when the signals are read.
    if (rtl_[i].is_clock) {
      const bool is_taken = rtl_[i].takes_edge == nullptr || *rtl_[i].takes_edge != 0;
      fst.value(rtl_handles_[i], 1, is_taken != rtl_[i].falls ? 1 : 0);
    } else {
      fst.bytes(rtl_handles_[i], rtl_[i].width, rtl_[i].bytes);
    }
  }
  fst.time(now.clock * wave_period + wave_period / 2);
  fst.value(clk_, 1, 0);
  for (std::size_t i = 0; i < rtl_.size(); ++i) {
    if (rtl_[i].is_clock) fst.value(rtl_handles_[i], 1, rtl_[i].falls ? 1 : 0);
  }
  end_ = (now.clock + 1) * wave_period;
}

void Wave::end(const WaveRange& range) {
  fst_->time(end_);
  fst_->close();
  write_view(path_, *shape_, range);
}

}  // namespace cosim
