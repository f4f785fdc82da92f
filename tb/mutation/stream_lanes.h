// Mutants in lanes as the RTL of a bench of streams.
//
// What goes in depends on when the RTL takes it, so a case is run on one lane, and all others get
// its inputs. As long as a lane puts out what the chosen one does, they are the inputs that it
// would be given itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tb/mutation/lanes.h"
#include "tb/stream/dut.h"

namespace cosim::mutation {

class StreamLanes final : public StreamDut {
 public:
  /// Mutant numbers[l] is in lane l. Both must outlive it. InputError as of Lanes.
  StreamLanes(const PlantedNets& rtl, const StreamShape& shape,
              const std::vector<unsigned>& numbers);

  /// The lane that it shows, from the next restart() on; at first number 0.
  void choose(std::size_t lane) {
    lane_ = lane;
    parted_ = {};
  }
  /// Whether a lane has put out, where it is looked at, something else than the chosen one since
  /// that was chosen; what comes between restart() and begin() does not count.
  bool has_parted(std::size_t lane) const { return parted_.lane(lane); }

  std::vector<Net> nets(const Ports& ports) override;
  /// The inputs that it is given before the edges of clocks stay until behind them. Of the outputs
  /// those are set that a bench looks at, cells where their valid is 1.
  void eval() override;
  bool restart(std::uint32_t power_up, bool is_reset) override;
  void begin() override { has_begun_ = true; }

 private:
  void look_at(const StreamShape& shape);
  void show();

  Ports ports_;
  Lanes lanes_;
  std::vector<Word> inputs_, driven_, outputs_;
  Word clock_ = 0;
  struct Looked {
    std::size_t output = 0;
    std::optional<std::size_t> where{};  ///< another output, which must be 1
  };
  std::vector<Looked> looked_;
  std::size_t lane_ = 0;
  bool has_begun_ = false;
  nets::Plane parted_;
};

}  // namespace cosim::mutation
