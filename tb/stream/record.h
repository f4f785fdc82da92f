// What is kept of a run for a person: the clocks around a finding, and the wave.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tb/show/wave.h"
#include "tb/sim/mismatch.h"
#include "tb/stream/run.h"

namespace cosim {

class StreamDut;

/// The traces around a finding: of each interface valid, ready and its fields.
class TraceRecorder final : public StreamObserver {
 public:
  TraceRecorder(const StreamShape& shape, const StreamFinding& finding, Window window);
  bool clock(std::uint64_t clock, const std::vector<Word>& edges,
             const std::vector<InterfaceSeen>& in, const std::vector<InterfaceSeen>& out) override;
  Mismatch take() { return std::move(mismatch_); }
  /// How many of each stream had gone in by the end of the clock of the finding.
  const std::vector<std::size_t>& taken() const { return taken_; }

 private:
  void add(const Interface& i);
  void keep(std::size_t& at, const Interface& i, const InterfaceSeen& seen);

  const StreamShape& shape_;
  StreamFinding finding_;
  Window window_;
  Mismatch mismatch_;
  std::vector<std::size_t> taken_;
};

/// The RTL's hierarchy, of several clocks on which steps they take their edge, and of each
/// interface valid, ready, the number of its transaction, its fields, those expected, its text
/// where the model has one, and NAME_fails, which is 1 where the finding is.
class WaveRecorder final : public StreamObserver {
 public:
  /// Of a run of `dut` that goes as `known`, for `sink`: all of it or what is around its finding.
  WaveRecorder(const StreamShape& shape, const std::string& title, const StreamDut& dut,
               const StreamResult& known, Window around, WaveSink& sink);
  bool clock(std::uint64_t clock, const std::vector<Word>& edges,
             const std::vector<InterfaceSeen>& in, const std::vector<InterfaceSeen>& out) override;
  void end() { sink_.end(range_); }

 private:
  const char* kept(std::string name) { return names_.emplace_back(std::move(name)).c_str(); }

  const StreamShape& streams_;
  std::optional<StreamFinding> finding_;
  std::deque<std::string> names_;
  WaveShape shape_;
  WaveRange range_;
  std::vector<Signal> rtl_;
  std::vector<Word> edges_;  // of several clocks, on the clock that is shown
  WaveSink& sink_;
};

}  // namespace cosim
