// Stream models: a struct that is an untimed function from the transactions that go in at a
// design's interfaces to those that must come out. There is no clock in it: how long anything
// takes, and who waits for whom, is left to the harness.
//
//   template <int W>                   // the module's parameters, in their order
//   struct Doubled {
//     struct X { UInt<W> data; };      // what passes at an interface on one clock
//     struct Y { UInt<W + 1> data; };
//     static constexpr auto in() { return stream<X>("x"); }
//     static constexpr auto out() { return stream<Y>("y").latency(2); }
//     static constexpr auto pins() { return std::array{pin::reset("rst")}; }
//
//     static std::vector<Y> run(const std::vector<X>& x) {
//       std::vector<Y> y;
//       for (const X& one : x) y.push_back({one.data + one.data});
//       return y;
//     }
//   };
//
// With several interfaces in() and out() return a std::tuple, and run() takes a vector of each
// input and returns a std::tuple of vectors. Given only the first transactions of a case, run()
// must return the first of its results. Beside these the struct may have
//
//   static auto legal(const X&)              assumptions about a transaction, stated({{...}, ...})
//   static constexpr int watchdog = 1000;    clocks without any movement after which the design
//                                            hangs
//   static auto draws()                      how fields are drawn, std::tuple{drawn(&X::field,
//                                            {...}), ...}; a field without a rule has any value
//   static X arranged(X x)                   changes each transaction that was drawn, for fields
//                                            that depend on each other
//   static constexpr int most_transactions = 256;           in a case
//   static auto cases(const X&)              what may happen to a transaction: cover counts it, and
//                                            each verdict names what never happened. It returns
//                                            stated({{...}, ...}), crossed(stated(...),
//                                            stated(...)), or a std::tuple of these
//   static auto cases(const X& x, const X* before)          the same, with the transaction before
//                                            x, null for the first one of a case
//   static auto compared(const Y&)           fields of an output that are compared only where their
//                                            condition holds for the expected transaction:
//                                            stated({{"data", y.hit}}), by the field's name
//   static std::string text_of(const X&)     a transaction in reports: "lw x25, 0(x0)"
//   static std::string state_after(const std::vector<X>&)   the state of the model behind these
//                                            arguments of run(); printed at a difference
//
//   static std::pair<std::vector<X>, std::string> program(const std::string& path)
//                                            for the command `program`: the arguments of run() that
//                                            the file has, such as the instructions of a program
//                                            (<cosim/program.h>), and what it finds wrong by
//                                            itself, one line, or empty
//
// and In, Out and clock() of a golden model (model.h): then every register is compared, too.
//
// The ports of stream "x" are x_valid, x_ready, and x_FIELD for each field; prefix() changes the
// text before valid, ready and FIELD, and a field At<"PORT", T> is that port. The member `tag` of a
// field `head` that is a struct is x_head_tag. A transaction passes on a clock on which valid and
// ready are both high.
//
// An interface of another kind has a driver of your own, stream<X, Sender>("x"). The driver of an
// input stream:
//
//   struct Sender {
//     struct Drives { Bit rx; };               // ports that it sets on each clock
//     struct Reads { Bit busy; };              // ports that it then sees, on the same clock
//     Drives drive(const X* x);
//     Drives answer(const Reads& pins);        // optional: what it drives within the same clock
//     bool took(const Reads& pins);
//   };
//
// x is the transaction that may go in, the same one until took() returns true; null if there is
// none or the case holds it back. The record that it points to neither moves nor changes before the
// case ends, so a driver may keep the pointer. The driver of an output stream has
// Drives drive(bool ready), in which ready is false while the case takes nothing, and
// std::optional<Y> came(const Reads&), the transaction that came out on this clock, if any; one
// that drives nothing has neither Drives nor drive(). Each case has a new driver; drive() is called
// once in the reset, too. A driver whose pins depend on the outputs of the design within one clock,
// such as a memory without wait states, also has answer(): it is called when the design has settled
// after drive(), and took() sees the result. It must not read pins that depend on the ones it
// drives.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "model/clocked/cases.h"
#include "model/clocked/draw.h"
#include "model/clocked/enum.h"

/// Only a file that has read this one needs what the harness has for streams.
#define COSIM_STREAMS

namespace cosim::clocked {

template <class M>
concept HasInputStreams = requires {
  M::in();
};
template <class M>
concept HasOutputStreams = requires {
  M::out();
};
/// A struct that is a model of streams.
template <class M>
concept HasStreams = HasInputStreams<M> || HasOutputStreams<M>;
/// The design of the models of streams alone, one for each shape. `Says` has its name and their
/// parameters, as that of DesignOf.
template <class Says, class... Models>
struct StreamDesign {
  static_assert(!(requires { typename Models::In; } || ...),
                "a model with In has clock(), and MODEL of cosim_add_design() names its header");
  struct Params {
    std::size_t number = 0;
  };
  static constexpr const char* name = Says::name;
  static constexpr auto parameters(const Params& p) { return Says::parameters[p.number]; }
};

/// The ports and properties of an interface beside its fields. A null name has the default that its
/// comment gives.
struct StreamPorts {
  const char* name;
  const char* prefix = nullptr;  ///< NAME_
  const char* valid = nullptr;   ///< PREFIXvalid
  const char* ready = nullptr;   ///< PREFIXready
  const char* credit = nullptr;  ///< PREFIXcredit
  const char* done = nullptr;    ///< none
  const char* clock = nullptr;   ///< the design's clock, if it has only one
  bool has_ready = true;
  int credits = 0;      ///< 0: no credits
  int latency = -1;     ///< most clocks; -1: any number
  bool pulse = false;   ///< a transaction is a rising edge of valid
  bool steady = false;  ///< an offer does not change until it is taken
};

/// An interface for transactions X: an input stream goes into the design, an output stream comes
/// out of it. Each function returns a copy with one more property. `Driver`: void, or the type of a
/// driver of your own in place of valid and ready.
template <class X, class Driver = void>
struct Stream {
  using Record = X;
  using Own = Driver;

  StreamPorts ports;

  /// Its ports begin with `text`: prefix("s_axis_t") makes them s_axis_tvalid, s_axis_tready.
  constexpr Stream prefix(const char* text) const { return with(&StreamPorts::prefix, text); }
  constexpr Stream valid(const char* port) const { return with(&StreamPorts::valid, port); }
  constexpr Stream ready(const char* port) const { return with(&StreamPorts::ready, port); }
  /// The clock on whose edges transactions pass. Needed if the design has several clocks.
  constexpr Stream clock(const char* port) const { return with(&StreamPorts::clock, port); }
  /// There is no ready: the receiving side can always take a transaction.
  constexpr Stream always_ready() const { return with(&StreamPorts::has_ready, false); }
  /// Credits in place of ready: the sending side may send `n` transactions, and one more for each
  /// clock on which the receiving side sets the port PREFIXcredit, or `port`.
  constexpr Stream credit(int n, const char* port = nullptr) const {
    return always_ready().with(&StreamPorts::credits, n).with(&StreamPorts::credit, port);
  }
  /// Input streams only, in place of ready: valid is high for one clock, on which the transaction
  /// is taken. Its fields stay, and the next transaction waits until the output `port` was high
  /// after it. With valid("start") this is a plain start and done.
  constexpr Stream until(const char* port) const {
    return always_ready().with(&StreamPorts::done, port);
  }
  /// Output streams only: each rising edge of valid is a transaction; valid may stay high.
  constexpr Stream rising() const { return always_ready().with(&StreamPorts::pulse, true); }
  /// Output streams only: an offer that is not taken must be unchanged on the next clock. With
  /// rising(): the fields must not change while valid is high.
  constexpr Stream steady() const { return with(&StreamPorts::steady, true); }
  /// Output streams only: a transaction comes at most `clocks` clocks after the last input that it
  /// needs went in; 0: on the same clock. A clock on which this stream moves, or is made to wait,
  /// does not count.
  constexpr Stream latency(int clocks) const { return with(&StreamPorts::latency, clocks); }

 private:
  template <class Member>
  constexpr Stream with(Member StreamPorts::*member, Member value) const {
    Stream s = *this;
    s.ports.*member = value;
    return s;
  }
};

template <class X, class Driver = void>
constexpr Stream<X, Driver> stream(const char* name) {
  return {{name}};
}

/// A port of the top module that is no part of a transaction.
struct Pin {
  enum class Kind { reset, tied, unread };
  const char* port;
  Kind kind;
  std::int64_t value = 0;  ///< reset: the level that resets; tied input: its value
  int width = 1;           ///< bits, 1 or more
  int clocks = 1;          ///< reset: the clocks that it lasts
};

namespace pin {

/// A reset: high, or low, for `clocks` clocks at the start of each case, then the other level.
constexpr Pin reset(const char* port, int clocks = 2) {
  return {port, Pin::Kind::reset, 1, 1, clocks};
}
constexpr Pin reset_low(const char* port, int clocks = 2) {
  return {port, Pin::Kind::reset, 0, 1, clocks};
}
/// An input that always has one value; bits from 64 on are 0.
constexpr Pin tied(const char* port, std::uint64_t value, int width = 1) {
  return {port, Pin::Kind::tied, static_cast<std::int64_t>(value), width};
}
/// An output that is not compared.
constexpr Pin unread(const char* port, int width = 1) {
  return {port, Pin::Kind::unread, 0, width};
}

}  // namespace pin
}  // namespace cosim::clocked
