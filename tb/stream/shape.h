// What is known of a design with a stream model, without its types: its interfaces and their ports.
// And what a case of it is: a stimulus whose rows are transactions.
//
//   x_give   1 where the row has a transaction for the stream x, which goes in
//   x_stall  the clocks for which it is held back, from the one before it on
//   x_FIELD  its fields
//   y_stall  the clocks for which the transaction of that number is not taken from the stream y,
//            which comes out, from the one before it on
//   y_waits  1 where it is not taken before its valid was seen either: ready waits for valid
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/clocked/stream.h"
#include "model/core/fields.h"
#include "tb/stream/own.h"
#include "tb/stream/sequence.h"

namespace cosim {

using clocked::Pin, clocked::StreamPorts;

/// Bits of a stall.
inline constexpr int stall_width = 8;

/// How a cell is drawn: from one of these, in proportion to their weights.
struct CellDraw {
  struct Share {
    std::int64_t low = 0, high = 0;
    std::uint64_t weight = 1;
    bool is_any = false;  ///< as a cell without a rule
  };
  std::vector<Share> shares;  ///< none: all names alike, or a number with its corners
  std::uint64_t total = 0;    ///< of the weights
};

/// One interface. A port without a name is not there.
struct Interface {
  std::string name;
  bool goes_in = true;
  std::vector<Field> cells;  ///< of a transaction; named as in a case, x_FIELD, with their ports
  std::string valid, ready, credit, done;
  std::size_t clock = 0;  ///< its number among those of the design
  int credits = 0;
  int latency = -1;
  bool pulse = false, steady = false;
  OwnDriver own = {};
  std::vector<std::string> cases = {};  ///< what may happen to a transaction of it, sentences
  /// Whether a cell of an expected transaction is compared; empty: each is.
  std::function<bool(std::span<const Word> expected, std::size_t cell)> compares = {};
  std::vector<CellDraw> draws = {};  ///< of each cell
  /// A transaction in words of the design's own; empty: it has none.
  std::function<std::string(std::span<const Word>)> text = {};
  /// Makes a transaction that was drawn one that may come; empty: it is left as it is.
  std::function<void(std::span<Word>)> arrange = {};

  bool is_compared(std::span<const Word> expected, std::size_t cell) const {
    return !compares || compares(expected, cell);
  }
  /// It says on each clock whether it takes.
  bool has_ready() const { return !ready.empty() || own.is_there(); }
  bool can_stall() const { return has_ready() || !credit.empty(); }
  /// It has valid, cells, and ready or none: nothing else that a clock must look at.
  bool is_plain() const {
    return !own.is_there() && credits == 0 && done.empty() && credit.empty() && !pulse && !steady;
  }
  /// The side that takes can see valid before it says that it does.
  bool can_wait() const { return !goes_in && !ready.empty(); }
};

/// A clock of a design.
struct StreamClock {
  std::string port;
  bool falls = false;  ///< registers take the falling edge
};

struct StreamShape {
  StreamShape() = default;
  StreamShape(const StreamShape&) = delete;
  StreamShape& operator=(const StreamShape&) = delete;

  std::string title;
  std::vector<StreamClock> clocks;
  std::vector<Interface> in, out;
  std::vector<Pin> pins;
  std::uint64_t watchdog = 1000;  ///< clocks for which nothing may move while something should
  std::uint64_t most_transactions = 256;  ///< of a case, >= 1

  /// The clock `one`, or where that is empty `several`, in lines as Ports has them.
  void set_clocks(const char* one, std::string_view several);
  /// Adds an interface with the cells of its record. InputError where that cannot be.
  void add(const StreamPorts& ports, bool goes_in, std::span<const Field> cells,
           OwnDriver own = {});
  /// Has a cell drawn so. InputError where it cannot be.
  void draw(Interface& i, std::size_t cell, std::span<const clocked::Share> shares) const;
  /// Each says whether it takes its edge: several, or one whose registers take the falling edge.
  bool clocks_are_inputs() const {
    return clocks.size() > 1 || (clocks.size() == 1 && clocks.front().falls);
  }
  bool has_reset() const;
  /// The columns of a case.
  const std::vector<Field>& columns() const { return columns_; }

 private:
  const char* kept(std::string text) { return names_.emplace_back(std::move(text)).c_str(); }
  void column(const Field& field);

  std::deque<std::string> names_;
  std::vector<Field> columns_;
};

/// A case, taken apart.
struct StreamCase {
  struct Side {
    std::vector<Word> stalls;  ///< before each; none behind the last
    std::vector<Word> waits;   ///< 1 where ready waits for valid, of a stream that comes out
  };
  std::vector<Sequence> given;  ///< of each stream that goes in
  std::vector<Side> in, out;

  StreamCase() = default;
  /// One without a transaction.
  explicit StreamCase(const StreamShape& shape);
  /// Makes it that again.
  void clear();
  /// One more row.
  void add(const StreamShape& shape, std::span<const Word> row);
};

}  // namespace cosim
