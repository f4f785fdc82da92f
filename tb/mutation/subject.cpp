// Fault dropping: a mutant that a case killed is given no other. When a quarter of the lanes is
// free the rest are put together anew, for fewer mutants are fewer gates.
#include "tb/mutation/subject.h"

#include <algorithm>
#include <memory>

#include "tb/util/parallel.h"

namespace cosim::mutation {
namespace {

// A run of yosys plants so many: more take it longer than twice the time.
constexpr std::size_t planted_at_once = 2 * nets::plane_lanes;

// Numbers, so many at a time.
std::vector<std::vector<unsigned>> shares_of(const std::vector<unsigned>& mutants,
                                             std::size_t each) {
  std::vector<std::vector<unsigned>> all;
  for (std::size_t i = 0; i < mutants.size(); i += each) {
    const auto begin = mutants.begin() + static_cast<std::ptrdiff_t>(i);
    all.emplace_back(begin,
                     begin + static_cast<std::ptrdiff_t>(std::min(each, mutants.size() - i)));
  }
  return all;
}

// Some mutants case by case, each lane with one that no case has killed so far.
class Attack {
 public:
  Attack(const AnyBench& bench, const Planted& planted, const std::vector<unsigned>& mutants,
         const Decide& decide)
      : bench_(bench), rtl_(planted_nets(bench, planted.nets(mutants))), decide_(decide) {
    for (auto& some : shares_of(mutants, nets::plane_lanes - 1)) {
      some.insert(some.begin(), 0);
      const nets::Plane unread = Lanes(rtl_, some).unread();
      for (std::size_t l = 1; l < some.size(); ++l) {
        if (unread.lane(l)) {
          decide_(some[l], {Outcome::End::unread, "", 0, ""});
        } else {
          left_.push_back(some[l]);
        }
      }
    }
  }

  void run(const Case& c) {
    fill();
    std::vector<unsigned> left;
    for (const auto& batch : batches_) {
      batch->run(c, decide_);
      for (const unsigned mutant : batch->mutants) {
        if (mutant != 0) left.push_back(mutant);
      }
    }
    left_ = std::move(left);
  }
  bool is_done() const { return left_.empty(); }

 private:
  // The lanes of those that were killed go to others; fewer mutants are fewer gates.
  void fill() {
    if (!batches_.empty() && 4 * left_.size() > 3 * filled_) return;
    filled_ = left_.size();
    batches_.clear();
    for (const auto& mutants : shares_of(left_, batch_size(bench_))) {
      batches_.push_back(batch_of(bench_, rtl_, mutants));
    }
  }

  const AnyBench& bench_;
  PlantedNets rtl_;
  std::vector<unsigned> left_;
  const Decide& decide_;
  std::vector<std::unique_ptr<Batch>> batches_;
  std::size_t filled_ = 0;
};

}  // namespace

void Subject::attack(const std::vector<unsigned>& mutants, std::size_t first, std::size_t last,
                     unsigned threads, const Decide& decide) const {
  // Fewer than a word of lanes take as long as one.
  const auto shares = shares_of(
      mutants,
      std::clamp<std::size_t>((mutants.size() + threads - 1) / threads, 64, planted_at_once));
  in_parallel(shares.size(), threads, [&](std::uint64_t i) {
    Attack attack(bench_, planted_, shares[i], decide);
    for (std::size_t c = first; c < last && !attack.is_done(); ++c) attack.run(cases_.all[c]);
    return true;
  });
}

Outcome Subject::attack(unsigned mutant, const Case& one) const {
  Outcome outcome;
  const Decide decide = [&](unsigned, Outcome is) { outcome = std::move(is); };
  Attack(bench_, planted_, {mutant}, decide).run(one);
  return outcome;
}

std::vector<unsigned> Subject::not_reset(const std::vector<unsigned>& mutants) const {
  std::vector<unsigned> found;
  const PlantedNets rtl = planted_nets(bench_, planted_.nets(mutants));
  for (const auto& some : shares_of(mutants, nets::plane_lanes)) {
    const nets::Plane all = Lanes(rtl, some).not_reset();
    for (std::size_t l = 0; l < some.size(); ++l) {
      if (all.lane(l)) found.push_back(some[l]);
    }
  }
  return found;
}

}  // namespace cosim::mutation
