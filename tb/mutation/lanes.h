// Mutants in lanes: the RTL of a shape as nets, run on planes, with another mutant in each lane.
//
// All lanes get the clocks of one run. Until a mutant differs from the model for the first time its
// outputs are the model's, and so is what a host makes of them: the run is that of the RTL without
// a mutant in lockstep, whatever the stimulus is. Its model is compared with each lane.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tb/nets/planes.h"
#include "tb/proof/rtl_nets.h"
#include "tb/sim/bench.h"

namespace cosim::mutation {

/// The nets of RTL with mutants planted in it, tied to tables of its pins and registers.
class PlantedNets {
 public:
  /// `title` is for errors. InputError where the RTL is not what the tables say.
  PlantedNets(std::string title, const BenchTables& tables, proof::RtlNets nets);

 private:
  friend class Lanes;
  std::vector<nets::Bits> nets_of(const char* kind, const std::vector<Field>& fields);
  void find_unreset(std::size_t registers);

  std::string title_;
  proof::RtlNets nets_;
  std::vector<Field> compared_;
  ResetInputs reset_inputs_;
  std::vector<nets::Bits> inputs_, wires_;  // of inputs, and of what is compared
  nets::Bits mutsel_, clocks_;              // all other inputs are clocks
  // A bit of a register that no reset reaches, without a mutant: between its net and its flip-flop
  // there may be mutants.
  struct Unreset {
    std::size_t wire = 0;  // of what is compared
    int bit = 0;
    std::size_t flip_flop = 0;
    bool is_inverted = false;
  };
  std::vector<Unreset> unreset_;
};

/// Up to nets::plane_lanes of them at work.
class Lanes {
 public:
  /// Mutant numbers[l] is in lane l. `rtl` must outlive it. InputError where the RTL clocks
  /// flip-flops by more than its clock, or reads the clock.
  Lanes(const PlantedNets& rtl, const std::vector<unsigned>& numbers);

  /// Powers up and resets; then all lanes are at work.
  void begin(std::uint32_t power_up);
  struct Killed {
    std::size_t lane = 0;
    std::string signal;  ///< the first that differs
  };
  /// The next clock. The lanes at work on which RTL and model differ; they are at work no longer.
  std::vector<Killed> clock(const Watched& seen);

  /// The same by hand: sets an input; settles with the clock low; has it rise.
  void drive(std::size_t input, Word value);
  void settle();
  void rise();
  /// What is compared, by its number, in a lane since the last settle(), and the lanes where it is
  /// something else.
  Word value(std::size_t compared, std::size_t lane) const;
  nets::Plane differing(std::size_t compared, Word value) const;

  /// The lanes in which what a reset leaves depends on how the RTL powered up, of which
  /// some are tried.
  nets::Plane not_reset();
  /// The lanes whose mutant changes a net, but has no way to anything that is compared, on that
  /// clock or a later one. Number 0, no mutant, must be in lane 0.
  nets::Plane unread() const;
  std::size_t gates() const { return planes_->gates(); }

 private:
  void place(const std::vector<unsigned>& numbers);
  void find_edges(const std::vector<std::uint32_t>& low, const std::vector<std::uint32_t>& high);
  std::vector<std::uint32_t> lane_constants(const std::vector<unsigned>& numbers, bool clock);
  nets::Plane constant(const std::vector<std::uint32_t>& all, nets::Bit bit) const;
  void power_up(const std::vector<bool>& held);
  void reset();
  void drive(const std::vector<Word>& inputs);

  const PlantedNets& rtl_;
  nets::Graph graph_;
  std::vector<std::vector<nets::Bit>> inputs_, wires_;
  std::vector<nets::Bit> held_, next_;  // of each flip-flop
  struct Edges {
    nets::Plane rising, falling;
  };
  std::vector<Edges> edges_;  // in which lanes each flip-flop takes them
  std::vector<nets::PlaneFlipFlop> rising_, falling_;
  std::vector<std::vector<nets::PlaneRoot>> compared_;
  std::vector<nets::Plane> constants_;  // that lanes have of their own
  std::vector<std::pair<nets::Bit, nets::Plane>> controls_;
  std::unique_ptr<nets::Planes> planes_;
  nets::Plane all_, at_work_;
  bool is_first_ = true, takes_over_ = true;
};

}  // namespace cosim::mutation
