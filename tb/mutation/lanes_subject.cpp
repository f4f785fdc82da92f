// Fault dropping: a mutant that a case killed is given no other. When a quarter of the lanes is
// free the rest are put together anew, for fewer mutants are fewer gates.
#include "tb/mutation/lanes_subject.h"

#include <algorithm>
#include <memory>

#include "tb/mutation/lanes.h"
#include "tb/support/interrupt.h"
#include "tb/support/parallel.h"

namespace cosim::mutation {
namespace {

// A run of yosys plants so many: more take it longer than twice the time.
constexpr std::size_t planted_at_once = 2 * nets::plane_lanes;

// Some mutants case by case, each lane with one that no case has killed so far.
class Attack {
 public:
  Attack(const AnyBench& bench, const Planted& planted, std::vector<unsigned> mutants,
         const Subject::Decide& killed)
      : rtl_(bench, planted.nets(mutants)), left_(std::move(mutants)), killed_(killed) {}

  void run(const Case& c) {
    fill();
    std::vector<unsigned> left;
    for (Batch& batch : batches_) {
      run(c, batch);
      for (const unsigned mutant : batch.mutants) {
        if (mutant != 0) left.push_back(mutant);
      }
    }
    left_ = std::move(left);
  }
  bool is_done() const { return left_.empty(); }

 private:
  struct Batch {
    std::vector<unsigned> mutants;  // by lane; 0: killed
    std::unique_ptr<Lanes> lanes;
  };

  // The lanes of those that were killed go to others; fewer mutants are fewer gates.
  void fill() {
    if (!batches_.empty() && 4 * left_.size() > 3 * filled_) return;
    filled_ = left_.size();
    batches_.clear();
    for (std::size_t i = 0; i < left_.size(); i += nets::plane_lanes) {
      const auto begin = left_.begin() + static_cast<std::ptrdiff_t>(i);
      const auto count = std::min<std::size_t>(nets::plane_lanes, left_.size() - i);
      batches_.push_back({{begin, begin + static_cast<std::ptrdiff_t>(count)}, nullptr});
      batches_.back().lanes = std::make_unique<Lanes>(rtl_, batches_.back().mutants);
    }
  }

  void run(const Case& c, Batch& batch) const {
    InterruptGuard::check();
    std::size_t open = batch.mutants.size() - static_cast<std::size_t>(std::count(
                                                  batch.mutants.begin(), batch.mutants.end(), 0U));
    if (open == 0) return;
    std::uint64_t clock = 0;
    batch.lanes->begin(c.power_up);
    c.watch([&](const Watched& seen) {
      for (const auto& [lane, signal] : batch.lanes->clock(seen)) {
        unsigned& mutant = batch.mutants[lane];
        if (mutant == 0) continue;
        killed_(mutant, {Outcome::End::killed, c.name, clock, signal});
        mutant = 0;
        --open;
      }
      return open > 0 && ++clock < c.most_clocks;
    });
  }

  PlantedNets rtl_;
  std::vector<unsigned> left_;
  const Subject::Decide& killed_;
  std::vector<Batch> batches_;
  std::size_t filled_ = 0;
};

std::vector<std::vector<unsigned>> shares_of(const std::vector<unsigned>& mutants,
                                             unsigned threads) {
  // Fewer than a word of lanes take as long as one.
  const std::size_t each =
      std::clamp<std::size_t>((mutants.size() + threads - 1) / threads, 64, planted_at_once);
  std::vector<std::vector<unsigned>> all;
  for (std::size_t i = 0; i < mutants.size(); i += each) {
    const auto begin = mutants.begin() + static_cast<std::ptrdiff_t>(i);
    all.emplace_back(begin,
                     begin + static_cast<std::ptrdiff_t>(std::min(each, mutants.size() - i)));
  }
  return all;
}

}  // namespace

void LanesSubject::attack(const std::vector<unsigned>& mutants, std::size_t first, std::size_t last,
                          unsigned threads, const Decide& killed) const {
  const auto shares = shares_of(mutants, threads);
  in_parallel(shares.size(), threads, [&](std::uint64_t i) {
    Attack attack(bench_, planted_, shares[i], killed);
    for (std::size_t c = first; c < last && !attack.is_done(); ++c) attack.run(cases_.all[c]);
    return true;
  });
}

Outcome LanesSubject::attack(unsigned mutant, const Case& one) const {
  Outcome outcome;
  const Decide killed = [&](unsigned, Outcome is) { outcome = std::move(is); };
  Attack(bench_, planted_, {mutant}, killed).run(one);
  return outcome;
}

std::vector<unsigned> LanesSubject::not_reset(const std::vector<unsigned>& mutants) const {
  std::vector<unsigned> found;
  const PlantedNets rtl(bench_, planted_.nets(mutants));
  for (std::size_t i = 0; i < mutants.size(); i += nets::plane_lanes) {
    const auto begin = mutants.begin() + static_cast<std::ptrdiff_t>(i);
    const auto count = std::min<std::size_t>(nets::plane_lanes, mutants.size() - i);
    Lanes lanes(rtl, {begin, begin + static_cast<std::ptrdiff_t>(count)});
    const nets::Plane all = lanes.not_reset();
    for (std::size_t l = 0; l < count; ++l) {
      if (all.lane(l)) found.push_back(mutants[i + l]);
    }
  }
  return found;
}

}  // namespace cosim::mutation
