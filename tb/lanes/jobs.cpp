// All lanes run until one is done, or differs: one whose case goes on is given its next job, and
// all go on. Where a sixteenth of the lanes have come to the end of their cases, all of these begin
// the next ones together (dynamic refill): so what begins cases is done for many at a time, and the
// clocks on which any lane writes and starts come together, too (quiet.h). A case begins in the
// state after a reset, which was computed once, and is copied into the lanes that begin. Where a
// register keeps what it powered up with, that state is computed for each case. After a failure
// only the cases before it go on, so that the first of all is found.
#include "tb/lanes/jobs.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "model/core/input_error.h"
#include "tb/lanes/lane_bits.h"
#include "tb/lanes/sweep.h"
#include "tb/sim/lane_jobs.h"
#include "tb/util/interrupt.h"
#include "tb/util/random.h"

namespace cosim::lanes {
namespace {

/// One thread's lanes at the cases of a sweep.
class JobPlayer {
 public:
  JobPlayer(const AnyBench& bench, const Built& built, const LaneJobs& jobs)
      : bench_(bench),
        built_(built),
        layout_(jobs.layout()),
        at_work_(jobs.begin(static_cast<std::size_t>(built.lanes))),
        words_(static_cast<std::size_t>(built.lanes) / 64),
        lanes_(static_cast<std::size_t>(built.lanes)),
        begins_(layout_.begins),
        figures_(layout_.figure_widths),
        codes_(std::max(layout_.begins.size(), layout_.figure_widths.size())),
        packed_(lanes_.size() * begins_.words()),
        most_clocks_(jobs.most_clocks()),
        left_out_(built.layout.counters) {
    constexpr std::size_t line = 64;
    const std::size_t all = planes() + 4 + 2 * machine_planes();
    const std::size_t bytes = all * words_ * sizeof(std::uint64_t);
    memory_.reset(
        static_cast<std::uint64_t*>(std::aligned_alloc(line, (bytes + line - 1) / line * line)));
    if (!memory_) throw std::bad_alloc();
    active_ = &memory_[planes() * words_];
    differ_ = active_ + words_;
    fresh_ = differ_ + words_;
    begun_ = fresh_ + words_;
    reset_state_ = begun_ + words_;
    kept_ = reset_state_ + machine_planes() * words_;
    std::fill_n(memory_.get(), all * words_, 0);
    reset();
    is_reset_ = is_reset();
  }

  struct Failed {
    std::uint64_t index = 0, clock = 0;  ///< of the case, and in it
    std::size_t lane = 0;
  };
  /// Runs cases first .. first + count - 1 to their ends, or those before and with the first that
  /// fails.
  std::optional<Failed> run(std::uint64_t first, std::uint64_t count) {
    next_ = first;
    end_ = first + count;
    constexpr std::uint64_t some = 1 << 10;
    const std::size_t few = lanes_.size() / 16;
    while (true) {
      InterruptGuard::check();
      if (lanes_.size() - working_ >= few) begin_cases();
      if (working_ == 0) break;
      put_begun();
      if (clock_ >= next_look_) find_endless(clock_ + some);
      const std::int64_t at =
          built_.run(memory_.get(), active_, clock_, clock_ + some, differ_, left_out_.data());
      if (at < 0) {
        clock_ += some;
        continue;
      }
      clock_ = static_cast<std::uint64_t>(at) + 1;
      for (std::size_t w = 0; w < words_; ++w) {
        for (std::uint64_t left = differ_[w] & active_[w]; left != 0; left &= left - 1) {
          failed(64 * w + static_cast<std::size_t>(std::countr_zero(left)));
        }
        for (std::uint64_t left = memory_[w] & active_[w] & ~differ_[w]; left != 0;
             left &= left - 1) {
          job_over(64 * w + static_cast<std::size_t>(std::countr_zero(left)));
        }
      }
    }
    return failed_;
  }
  std::uint64_t clocks() const { return clocks_; }
  Checked checked() const { return at_work_->checked(); }
  const std::vector<std::uint64_t>& left_out() const { return left_out_; }

 private:
  struct Lane {
    std::uint64_t index = 0, begun = 0;  // its case, and the clock that is the first of it
    std::uint64_t job = 0;               // and of its job
  };

  std::size_t planes() const { return built_.layout.planes.size(); }
  std::size_t machine_planes() const { return planes() - built_.layout.state; }

  void reset() {
    Random random(1);
    const auto& first = built_.layout.planes;
    for (std::size_t i = built_.layout.state; i < first.size(); ++i) {
      for (std::size_t w = 0; w < words_; ++w) {
        memory_[i * words_ + w] = first[i] == Layout::First::anything ? random.next()
                                  : first[i] == Layout::First::yes    ? ~std::uint64_t{0}
                                                                      : 0;
      }
    }
    built_.reset(memory_.get());
    built_.take_over(memory_.get());
    std::copy_n(&memory_[built_.layout.state * words_], machine_planes() * words_, reset_state_);
  }

  // Whether nothing is left of what the RTL powered up with.
  bool is_reset() const {
    for (std::size_t i = 0; i < machine_planes() * words_; ++i) {
      const std::uint64_t first =
          (reset_state_[i / words_ * words_] & 1) != 0 ? ~std::uint64_t{0} : 0;
      if (reset_state_[i] != first) return false;
    }
    return true;
  }

  // What jobs begin with is written, all else of them is 0.
  void put_begun() {
    if (!any_begun_) return;
    built_.clear(&memory_[words_], begun_, built_.layout.state - 1);
    for (std::size_t w = 0; w < words_; ++w) {
      for (std::uint64_t left = begun_[w]; left != 0; left &= left - 1) {
        const std::size_t lane = 64 * w + static_cast<std::size_t>(std::countr_zero(left));
        begins_.put(&packed_[lane * begins_.words()], &memory_[words_], words_, lane);
      }
    }
    std::fill_n(begun_, words_, 0);
    any_begun_ = false;
    if (any_fresh_) put_fresh();
  }

  // Those that begin a case are as after a reset.
  void put_fresh() {
    std::uint64_t* machine = &memory_[built_.layout.state * words_];
    built_.choose(machine, fresh_, reset_state_, machine_planes());
    if (!is_reset_) {
      // What is left of the power-up is to be that of the same case in the Verilated class; the
      // model takes it over in these lanes alone.
      for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
        if ((fresh_[lane / 64] & bit_of(lane)) == 0) continue;
        const auto power_up = static_cast<std::uint32_t>(lanes_[lane].index);
        put_registers(built_.layout, memory_.get(), words_, lane, bench_.begun(power_up));
      }
      std::copy_n(machine, machine_planes() * words_, kept_);
      built_.take_over(memory_.get());
      for (std::size_t w = 0; w < words_; ++w) fresh_[w] = ~fresh_[w];
      built_.choose(machine, fresh_, kept_, machine_planes());
    }
    std::fill_n(fresh_, words_, 0);
    any_fresh_ = false;
  }

  // One whose driver waits for ever fails: run again by itself, it says so.
  void find_endless(std::uint64_t next_look) {
    next_look_ = next_look;
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
      const bool works = (active_[lane / 64] & bit_of(lane)) != 0;
      if (works && clock_ - lanes_[lane].job > most_clocks_) failed(lane);
    }
  }

  static std::uint64_t bit_of(std::size_t lane) { return std::uint64_t{1} << (lane % 64); }

  // In all lanes without a case the next ones that have a job.
  void begin_cases() {
    for (std::size_t lane = 0; lane < lanes_.size() && next_ < end_ && !failed_; ++lane) {
      if ((active_[lane / 64] & bit_of(lane)) == 0) begin_case(lane);
    }
  }
  void begin_case(std::size_t lane) {
    while (next_ < end_) {
      lanes_[lane] = {next_, clock_, clock_};
      at_work_->open(lane, next_++);
      if (!begin_job(lane)) continue;
      fresh_[lane / 64] |= bit_of(lane);
      any_fresh_ = true;
      active_[lane / 64] |= bit_of(lane);
      ++working_;
      return;
    }
  }
  void retire(std::size_t lane) {
    active_[lane / 64] &= ~bit_of(lane);
    --working_;
  }

  bool begin_job(std::size_t lane) {
    if (!at_work_->next(lane, std::span(codes_).first(layout_.begins.size()))) return false;
    begins_.pack(codes_, &packed_[lane * begins_.words()]);
    lanes_[lane].job = clock_;
    begun_[lane / 64] |= bit_of(lane);
    any_begun_ = true;
    return true;
  }

  void job_over(std::size_t lane) {
    figures_.get(&memory_[layout_.figures * words_], words_, lane, codes_);
    at_work_->over(lane, std::span(codes_).first(layout_.figure_widths.size()));
    if (begin_job(lane)) return;
    clocks_ += clock_ - lanes_[lane].begun;
    retire(lane);
  }

  // Cases behind it are of no interest any more.
  void failed(std::size_t lane) {
    const Lane& at = lanes_[lane];
    if (!failed_ || at.index < failed_->index) {
      failed_ = Failed{at.index, clock_ - 1 - at.begun, lane};
    }
    for (std::size_t other = 0; other < lanes_.size(); ++other) {
      const bool works = (active_[other / 64] & bit_of(other)) != 0;
      if (works && lanes_[other].index >= failed_->index) retire(other);
    }
  }

  struct Free {
    void operator()(std::uint64_t* memory) const { std::free(memory); }
  };
  const AnyBench& bench_;
  const Built& built_;
  const JobLayout layout_;
  std::unique_ptr<JobsAtWork> at_work_;
  std::size_t words_;  // a plane
  std::vector<Lane> lanes_;
  Packed begins_, figures_;
  std::vector<Word> codes_;            // of one lane
  std::vector<std::uint64_t> packed_;  // of each lane that begins a job
  std::uint64_t most_clocks_;
  std::vector<std::uint64_t> left_out_;
  // The planes; who is at work, who differs, who begins a case, and who a job; the planes of a
  // reset machine, and of the others while some begin.
  std::unique_ptr<std::uint64_t[], Free> memory_;
  std::uint64_t *active_ = nullptr, *differ_ = nullptr, *fresh_ = nullptr, *begun_ = nullptr,
                *reset_state_ = nullptr, *kept_ = nullptr;
  bool is_reset_ = false, any_fresh_ = false, any_begun_ = false;
  std::size_t working_ = 0;
  std::uint64_t next_ = 0, end_ = 0, clock_ = 0, next_look_ = 0, clocks_ = 0;
  std::optional<Failed> failed_;
};

class Cases {
 public:
  Cases(const AnyBench& bench, const Built& built, const Sweep& sweep)
      : bench_(bench), built_(built), sweep_(sweep) {}

  Result run(std::uint64_t first, std::uint64_t count) const {
    JobPlayer player(bench_, built_, *sweep_.in_lanes);
    if (const auto failed = player.run(first, count)) return confirmed(first, *failed);
    Result result;
    result.cases = count;
    result.clocks = player.clocks();
    result.left_out = player.left_out();
    result.checked = player.checked();
    return result;
  }

 private:
  Result confirmed(std::uint64_t first, const JobPlayer::Failed& failed) const {
    Result sum;
    if (failed.index > first) sum = run(first, failed.index - first);
    Result one = sweep_.run(failed.index);
    const bool same = one.mismatch ? one.mismatch->clock == failed.clock : !one.match();
    if (!same) {
      throw Unconfirmed(fmt::format(
          "{}: case {}, in lane {} of {}, fails on clock {} there, and one at a time {}: an error "
          "of the lanes; --lanes 0 runs without it",
          bench_.title(), failed.index, failed.lane, built_.lanes, failed.clock,
          one.mismatch ? fmt::format("on clock {}", one.mismatch->clock) : "nowhere"));
    }
    one.cases = 1;
    add(sum, std::move(one));
    return sum;
  }

  const AnyBench& bench_;
  const Built& built_;
  Sweep sweep_;
};

}  // namespace

Sweep job_sweep(const AnyBench& bench, const Built& built, const Sweep& sweep) {
  Sweep all = sweep;
  all.at_once = static_cast<std::uint64_t>(built.lanes) * sweep.in_lanes->cases_a_lane();
  all.run_some = [cases = Cases(bench, built, sweep)](std::uint64_t first, std::uint64_t count) {
    return cases.run(first, count);
  };
  return all;
}

}  // namespace cosim::lanes
