// Runs a stimulus for somebody who looks: in lockstep, on RTL whose whole hierarchy can be seen.
#pragma once

#include <vector>

#include "tb/show/wave.h"
#include "tb/sim/replay.h"

namespace cosim {

/// Gives the sink the clocks of `around` the stimulus's first difference, all where none differs.
template <class Design>
[[gnu::cold]] void record_wave(const DutMaker<Design>& maker, const Stimulus& stimulus,
                               Window around, const WaveShape& shape, WaveSink& sink) {
  WaveRange range;
  range.clocks = stimulus.clocks.size();
  range.last = range.clocks - 1;
  range.mismatch = differing_clock(maker, stimulus);
  if (range.mismatch) {
    range.first = *range.mismatch > around.before ? *range.mismatch - around.before : 0;
    range.last = std::min(range.last, *range.mismatch + around.after);
  }

  const auto lockstep = started(maker, stimulus);
  const std::vector<Signal> signals = lockstep->dut().signals();
  sink.begin(shape, range, signals);
  ViewOf<Design> expected, actual;
  Rows<Design> rows(maker.params, stimulus);
  typename Design::template Inputs<Word> in;
  const Cells<typename Design::template Registers<Word>> registers(maker.params);
  const Cells<typename Design::template Outputs<Word>> outputs(maker.params);
  const auto words = [&](const Compared<Design>& seen) {
    std::vector<Word> all = registers.words(seen.registers);
    const std::vector<Word> more = outputs.words(seen.outputs);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  for (WaveClock now; now.clock <= range.last; ++now.clock) {
    const auto state = lockstep->state();
    rows.next(in, {});
    lockstep->clock(in, [&](const Compared<Design>& model, const Compared<Design>& rtl) {
      expected.clock(maker.params, state, model.outputs);
      actual.clock(maker.params, state, rtl.outputs);
      if (now.clock < range.first) return;
      now.inputs = stimulus.clocks[now.clock];
      now.expected = words(model);
      now.actual = words(rtl);
      const auto expected_probes = expected.values(), actual_probes = actual.values();
      now.expected_probes.assign(expected_probes.begin(), expected_probes.end());
      now.actual_probes.assign(actual_probes.begin(), actual_probes.end());
      now.compared.clear();
      now.differs.clear();
      for (std::size_t i = 0; i < now.expected.size(); ++i) {
        now.compared.push_back(lockstep->mask().of_cell(i));
        now.differs.push_back(now.compared.back() && now.expected[i] != now.actual[i]);
        if (range.signal.empty() && now.differs.back()) range.signal = label_of(shape.compared[i]);
      }
      sink.clock(now);
    });
  }
  sink.end(range);
}

}  // namespace cosim
