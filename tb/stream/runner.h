// What runs cases on one instance of the RTL, one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "tb/stream/dut.h"
#include "tb/stream/edges.h"
#include "tb/stream/run.h"
#include "tb/stream/shape.h"
#include "tb/stream/sides.h"
#include "tb/util/random.h"

namespace cosim {

/// It finds the ports once, and keeps its memory from case to case.
class StreamRunner {
 public:
  /// Both outlive it. InputError where the RTL has other ports.
  StreamRunner(const StreamShape& shape, StreamDut& dut);
  StreamRunner(const StreamRunner&) = delete;
  StreamRunner& operator=(const StreamRunner&) = delete;

  /// The instance has just powered up. After the last transaction some clocks are waited for one
  /// too many: 16 more than the longest time for which nothing moved before.
  StreamResult run(const StreamOrder& order);

 private:
  using Kind = StreamFinding::Kind;

  void start();
  template <bool plain>
  void set_clocks(bool after);
  void draw_edges();
  void reset();
  template <bool plain>
  void run_clocks();
  template <bool plain>
  bool clock();
  void note_taken();
  void found(Kind kind, bool goes_in, std::size_t stream, std::size_t number, std::size_t cell = 0);
  void answer();
  void eval();
  void hear();
  template <bool plain>
  void judge(Taker& t);
  void judge_steady(const Taker& t);
  void judge_value(const Taker& t);
  void judge_latency(Taker& t);
  void listen(bool moved);
  void judge_silence();
  bool pending() const;
  bool ends(bool moved);
  bool ends_found();
  Sequence& gathered(std::size_t s);
  bool show();
  std::size_t number_of(const Giver& g) const {
    return static_cast<std::size_t>(&g - givers_.data());
  }
  std::size_t number_of(const Taker& t) const {
    return static_cast<std::size_t>(&t - takers_.data());
  }

  const StreamShape& shape_;
  StreamDut& dut_;
  StreamNets nets_;
  std::vector<Giver> givers_;
  std::vector<Taker> takers_;
  std::unique_ptr<EdgesDrawn> edges_;  // where there are several clocks
  bool has_latency_ = false, is_steady_ = false, is_plain_ = true;

  // Of the case that runs.
  const StreamOrder* order_ = nullptr;
  Random noise_{0};
  std::vector<std::size_t> taken_;  // of each giver, after each clock on which one was taken
  std::vector<std::size_t> due_;    // of each taker, by the last answer
  bool held_ = false;               // by the harness, on this clock
  bool is_shown_ = false;       // the observer has what it wants; the run goes on to its finding
  std::uint64_t quiet_ = 0;     // clocks since something moved or was held; of several, of each
  std::uint64_t moved_at_ = 0;  // the clock after that
  std::uint64_t longest_ = 0, drained_ = 0;
  std::vector<Sequence> gathered_;
  StreamResult result_;
};

}  // namespace cosim
