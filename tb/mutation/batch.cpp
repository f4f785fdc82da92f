// In lockstep all lanes get the clocks of the RTL without a mutant, and each is compared with the
// model. What streams carry depends on when the RTL takes it: there the RTL without a mutant is in
// lane 0, and each mutant that ever puts out something else is run once more, on its own lane.
#include "tb/mutation/subject.h"

#include <algorithm>
#include <utility>

#include "model/core/input_error.h"
#include "tb/mutation/stream_lanes.h"
#include "tb/stream/bench.h"
#include "tb/util/interrupt.h"

namespace cosim::mutation {
namespace {

class LockstepBatch final : public Batch {
 public:
  LockstepBatch(const PlantedNets& rtl, const std::vector<unsigned>& numbers)
      : Batch(numbers), lanes_(rtl, numbers) {}

  void run(const Case& c, const Decide& killed) override {
    InterruptGuard::check();
    auto open = std::ranges::count_if(mutants, [](unsigned k) { return k != 0; });
    if (open == 0) return;
    std::uint64_t clock = 0;
    lanes_.begin(c.power_up);
    c.watch([&](const Watched& seen) {
      for (const auto& [lane, signal] : lanes_.clock(seen)) {
        unsigned& mutant = mutants[lane];
        if (mutant == 0) continue;
        killed(mutant, {Outcome::End::killed, c.name, clock, signal});
        mutant = 0;
        --open;
      }
      return open > 0 && ++clock < c.most_clocks;
    });
  }

 private:
  Lanes lanes_;
};

class StreamBatch final : public Batch {
 public:
  // Together with the RTL without a mutant a word of lanes: most runs are for one lane alone.
  static constexpr std::size_t most = 63;

  StreamBatch(const PlantedNets& rtl, const AnyStreamBench& bench,
              const std::vector<unsigned>& numbers)
      : Batch(numbers), bench_(bench), lanes_(rtl, bench.shape(), with_none(numbers)) {}

  void run(const Case& c, const Decide& killed) override {
    if (const Outcome o = on_lane(0, c); o.end != Outcome::End::open) {
      throw InputError(bench_.title() + ": RTL and model differ without a mutant: " + o.stimulus +
                       ", " + o.signal + "; sweep shows it, and must match before mutate");
    }
    std::vector<std::size_t> parted;
    for (std::size_t i = 0; i < mutants.size(); ++i) {
      if (mutants[i] != 0 && lanes_.has_parted(i + 1)) parted.push_back(i);
    }
    for (const std::size_t i : parted) {
      Outcome o = on_lane(i + 1, c);
      if (o.end != Outcome::End::open) killed(std::exchange(mutants[i], 0), std::move(o));
    }
  }

 private:
  static std::vector<unsigned> with_none(std::vector<unsigned> numbers) {
    numbers.insert(numbers.begin(), 0);
    return numbers;
  }
  Outcome on_lane(std::size_t lane, const Case& c) {
    InterruptGuard::check();
    lanes_.choose(lane);
    const auto found = c.finding_on(lanes_);
    if (!found) return {};
    return {Outcome::End::killed, c.name, found->clock, signal_of(bench_.shape(), *found)};
  }

  const AnyStreamBench& bench_;
  StreamLanes lanes_;
};

const AnyStreamBench* streams_of(const AnyBench& bench) {
  return dynamic_cast<const AnyStreamBench*>(&bench);
}

}  // namespace

PlantedNets planted_nets(const AnyBench& bench, proof::RtlNets nets) {
  const AnyStreamBench* streams = streams_of(bench);
  if (streams == nullptr) return {bench.title(), bench.tables(), std::move(nets)};
  const Ports ports = ports_of(streams->shape());
  BenchTables tables;
  tables.inputs = ports.inputs;
  tables.compared = ports.outputs;
  return {bench.title(), tables, std::move(nets)};
}

std::size_t batch_size(const AnyBench& bench) {
  return streams_of(bench) != nullptr ? StreamBatch::most : nets::plane_lanes;
}

std::unique_ptr<Batch> batch_of(const AnyBench& bench, const PlantedNets& rtl,
                                const std::vector<unsigned>& mutants) {
  if (const AnyStreamBench* streams = streams_of(bench)) {
    return std::make_unique<StreamBatch>(rtl, *streams, mutants);
  }
  return std::make_unique<LockstepBatch>(rtl, mutants);
}

}  // namespace cosim::mutation
