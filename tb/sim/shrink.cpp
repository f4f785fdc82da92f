#include "tb/sim/shrink.h"

#include <algorithm>
#include <utility>

namespace cosim {
namespace {

using Clock = std::chrono::steady_clock;
using Rows = std::vector<std::vector<Word>>;

class Shrinker {
 public:
  Shrinker(const AnyBench& bench, Stimulus stimulus, std::chrono::milliseconds budget)
      : bench_(bench),
        rest_(bench.rest()),
        end_(Clock::now() + budget),
        best_(std::move(stimulus)) {}

  Stimulus run() {
    take(best_.clocks);
    for (bool again = true; again && in_time();) {
      again = fewer_clocks();
      again |= other_rows();
      again |= calmer_pins();
      again |= lower_values();
      again |= next_values();
    }
    return std::move(best_);
  }

 private:
  bool in_time() const { return Clock::now() < end_; }

  // Keeps the rows if they fail, up to the clock where they do.
  bool take(Rows rows) {
    if (rows.empty()) return false;
    Stimulus tried = best_;
    tried.clocks = std::move(rows);
    const auto clock = bench_.first_difference(tried);
    if (!clock) return false;
    tried.clocks.resize(*clock + 1);
    best_ = std::move(tried);
    return true;
  }

  // Delta debugging: without each of the pieces that the clocks are cut into, ever smaller ones,
  // from the end on.
  bool fewer_clocks() {
    bool any = false;
    for (std::size_t piece = best_.clocks.size() / 2; piece >= 1; piece /= 2) {
      for (std::size_t end = best_.clocks.size(); end > 0 && in_time();) {
        const std::size_t begin = end > piece ? end - piece : 0;
        Rows rows = best_.clocks;
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(begin),
                   rows.begin() + static_cast<std::ptrdiff_t>(std::min(end, rows.size())));
        any |= take(std::move(rows));
        end = std::min(begin, best_.clocks.size());
      }
    }
    return any;
  }

  // Without a row in a way that the bench knows, from the end on.
  bool other_rows() {
    bool any = false;
    for (std::size_t n = best_.clocks.size(); n-- > 0 && in_time();) {
      if (n >= best_.clocks.size()) continue;
      for (Rows& rows : bench_.without(best_.clocks, n)) {
        if (!take(std::move(rows))) continue;
        any = true;
        break;
      }
    }
    return any;
  }

  bool calmer_pins() {
    bool any = false;
    for (std::size_t pin = 0; pin < rest_.size() && in_time(); ++pin) {
      Rows rows = best_.clocks;
      for (auto& row : rows) row[pin] = rest_[pin];
      if (rows != best_.clocks) any |= take(std::move(rows));
    }
    for (std::size_t c = 0; c < best_.clocks.size() && in_time(); ++c) {
      if (best_.clocks[c] != rest_) any |= set(c, rest_);
      for (std::size_t pin = 0; pin < rest_.size() && c < best_.clocks.size(); ++pin) {
        if (best_.clocks[c][pin] == rest_[pin]) continue;
        std::vector<Word> row = best_.clocks[c];
        row[pin] = rest_[pin];
        any |= set(c, std::move(row));
      }
    }
    return any;
  }

  // Wide values, one bit less at a time, the highest first.
  bool lower_values() {
    bool any = false;
    for (std::size_t c = 0; c < best_.clocks.size() && in_time(); ++c) {
      for (std::size_t pin = 0; pin < rest_.size(); ++pin) {
        for (int i = 63; i >= 0 && c < best_.clocks.size() && in_time(); --i) {
          const Word value = best_.clocks[c][pin];
          if (value == rest_[pin] || (value >> i & 1) == 0) continue;
          std::vector<Word> row = best_.clocks[c];
          row[pin] = value ^ static_cast<Word>(std::uint64_t{1} << i);
          any |= set(c, std::move(row));
        }
      }
    }
    return any;
  }

  // The value after a wide one, which may be the address of another register, where that fails
  // sooner.
  bool next_values() {
    bool any = false;
    const std::vector<Field> pins = bench_.inputs();
    for (std::size_t c = 0; c < best_.clocks.size() && in_time(); ++c) {
      for (std::size_t pin = 0; pin < rest_.size() && c < best_.clocks.size(); ++pin) {
        if (pins[pin].width == 1) continue;
        const Stimulus before = best_;
        std::vector<Word> row = before.clocks[c];
        row[pin] = low_bits(add(row[pin], 1), pins[pin].width);
        if (!set(c, std::move(row))) continue;
        if (best_.clocks.size() < before.clocks.size()) {
          any = true;
        } else {
          best_ = before;
        }
      }
    }
    return any;
  }

  bool set(std::size_t clock, std::vector<Word> row) {
    Rows rows = best_.clocks;
    rows[clock] = std::move(row);
    return take(std::move(rows));
  }

  const AnyBench& bench_;
  std::vector<Word> rest_;
  Clock::time_point end_;
  Stimulus best_;
};

}  // namespace

Stimulus shrink(const AnyBench& bench, Stimulus stimulus, std::chrono::milliseconds budget) {
  return Shrinker(bench, std::move(stimulus), budget).run();
}

}  // namespace cosim
