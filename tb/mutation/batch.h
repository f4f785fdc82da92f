// Some mutants of a bench's RTL in lanes, attacked case by case.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "tb/mutation/lanes.h"
#include "tb/mutation/mutants.h"

namespace cosim::mutation {

using Decide = std::function<void(unsigned mutant, Outcome)>;

class Batch {
 public:
  explicit Batch(const std::vector<unsigned>& numbers) : mutants(numbers) {}
  virtual ~Batch() = default;
  /// Calls killed(mutant, outcome) for each that the case kills, which is then 0 in `mutants`.
  /// InputError where RTL and model differ without a mutant.
  virtual void run(const Case& c, const Decide& killed) = 0;

  std::vector<unsigned> mutants;
};

/// The RTL with its mutants, tied to what the bench knows of it.
PlantedNets planted_nets(const AnyBench& bench, proof::RtlNets nets);
/// How many mutants go into a batch.
std::size_t batch_size(const AnyBench& bench);
/// `rtl` is of planted_nets(); both must outlive it.
std::unique_ptr<Batch> batch_of(const AnyBench& bench, const PlantedNets& rtl,
                                const std::vector<unsigned>& mutants);

}  // namespace cosim::mutation
