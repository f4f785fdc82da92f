// One case as an order, and what it gives: what goes in is driven, what comes out is drained and
// compared with what must come.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tb/sim/transactions.h"
#include "tb/stream/sequence.h"
#include "tb/stream/shape.h"

namespace cosim {

/// What is wrong, first.
struct StreamFinding {
  enum class Kind {
    value,     ///< another value than expected
    extra,     ///< one more than expected
    missing,   ///< all that goes in is taken, what comes out is not all there, and nothing moves
    hung,      ///< what goes in is not taken, or valid waits for ready, and nothing moves
    late,      ///< later than the stated latency
    unsteady,  ///< what was offered was taken back or changed, or what stays high
    said,      ///< the RTL itself says that something is wrong
    credit,    ///< more given than there was credit for, or more credit than there can be
  };
  Kind kind = Kind::value;
  bool goes_in = false;    ///< which stream
  std::size_t stream = 0;  ///< its number among those
  std::size_t number = 0;  ///< the transaction, from 0
  std::size_t cell = 0;    ///< of a value: the first that differs
  /// From the end of the reset on; where nothing moves, the first clock of that.
  std::uint64_t clock = 0;
  /// Where nothing moves, a stream that comes out whose ready waits for valid.
  std::optional<std::size_t> waits = {};

  bool operator==(const StreamFinding&) const = default;
};

/// The signal that it names: of a value its cell, else its stream.
std::string signal_of(const StreamShape& shape, const StreamFinding& finding);

struct StreamResult {
  std::uint64_t clocks = 0;
  std::vector<Transactions> streams;  ///< of each that goes in, then of each that comes out
  std::optional<StreamFinding> finding;
  std::string said;  ///< by the RTL, where that is the finding
  Sequence came{1};  ///< where it was asked for, all that came out at the finding's stream
};

/// An interface on one clock.
struct InterfaceSeen {
  bool valid = false, ready = false;
  std::size_t number = 0;              ///< of the transaction that is next or under way
  std::vector<Word> actual, expected;  ///< its cells; of one that goes in the same
  std::vector<bool> compared;          ///< of each cell of one that comes out
};

class StreamObserver {
 public:
  virtual ~StreamObserver() = default;
  /// False: seen enough.
  /// `edges`: of each of several clocks 1 where it takes its edge; on a clock without that of its
  /// own an interface stands still. Empty where there is one.
  virtual bool clock(std::uint64_t clock, const std::vector<Word>& edges,
                     const std::vector<InterfaceSeen>& in,
                     const std::vector<InterfaceSeen>& out) = 0;
};

/// Writes into `sizes` how many come out of each stream for the first so many of each that goes in.
using StreamSizes =
    std::function<void(std::span<const std::size_t> taken, std::span<std::size_t> sizes)>;

struct StreamOrder {
  const StreamCase& given;
  const std::vector<Sequence>& expected;  ///< of each stream that comes out
  /// What must have come out. Asked only where a latency is stated and something is waited for
  /// longer than that, of ever more.
  StreamSizes due;
  std::uint32_t noise = 1;  ///< seed of the values of fields while nothing is offered
  std::uint64_t budget = ~std::uint64_t{0};  ///< clocks after which it ends once something moves
  bool gather = false;  ///< goes on after a wrong value, for StreamResult::came
  StreamObserver* observer = nullptr;
};

/// The finding as one line, from what came out and what was expected: a wrong value may be one that
/// is lost, doubled, reordered or one too many.
std::string to_text(const StreamShape& shape, const StreamOrder& order, const StreamResult& result);

}  // namespace cosim
