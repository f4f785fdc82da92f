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
// Of several interfaces in() and out() give a std::tuple, run() takes a vector of each and gives a
// std::tuple of vectors. Given only the first transactions of a case, run() must give the first of
// its results: what came out once stays. Beside these the struct may have
//
//   static auto legal(const X&)              what is assumed of a transaction, stated({{...}, ...})
//   static constexpr int watchdog = 1000;    clocks for which nothing may move while something
//   should
//   static auto draws()                      how fields are drawn, std::tuple{drawn(&X::field,
//                                            {...}), ...}; a field without a rule has any value
//   static X arranged(X x)                   makes a transaction that was drawn one that may come,
//                                            where rules join its fields
//   static constexpr int most_transactions = 256;    of a case
//   static auto cases(const X&)              what may happen to a transaction: cover counts it, and
//                                            each verdict names what never did. It gives
//                                            stated({{...}, ...}), crossed(stated(...),
//                                            stated(...)), or a std::tuple of these
//   static std::string text_of(const X&)     a transaction as a report has it: "lw x25, 0(x0)"
//   static std::string state_after(const std::vector<X>&)   the state of the model behind these,
//                                            with the arguments of run(); printed at a difference
//   static auto cases(const X& x, const X* before)   the same, with the transaction before it
//
// and clock(), In and Out of a golden model of every clock (model.h): then all is compared.
//
// The ports of stream "x" are x_valid, x_ready, and x_FIELD for each field; prefix() puts something
// else before them, and a field At<"PORT", T> has that port. The member `tag` of a field `head`
// that is a struct has x_head_tag. A transaction passes on a clock on which valid and ready are
// both high.
//
// An interface of another kind has a driver of your own, stream<X, Sender>("x"). Of an input
// stream:
//
//   struct Sender {
//     struct Drives { Bit rx; };               // ports that it sets on each clock
//     struct Reads { Bit busy; };              // ports that it then sees, on the same clock
//     Drives drive(const X* x);
//     Drives answer(const Reads& pins);        // optional: what it drives within the same clock
//     bool took(const Reads& pins);
//   };
//
// x is the transaction that may go in, the same one until took() says that it went in; null where
// there is none, or the case holds it back. The record that it points to neither moves nor changes
// before the case ends: a driver may keep the pointer. The driver of an output stream has
// Drives drive(bool ready), where ready is false while the case takes nothing, and
// std::optional<Y> came(const Reads&); one that drives nothing has neither Drives nor drive(). Each
// case has a new driver; drive() is called once in the reset, too. A driver whose pins depend on
// the outputs of the design within one clock, as a memory without wait states, has answer()
// besides: it is called when the design has settled behind drive(), and took() sees what comes of
// it. It must not depend on pins that depend on what it drives.
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

/// What an interface has beside its fields. For a name that is null the default beside it is used.
struct StreamPorts {
  const char* name;
  const char* prefix = nullptr;  ///< NAME_
  const char* valid = nullptr;   ///< PREFIXvalid
  const char* ready = nullptr;   ///< PREFIXready
  const char* credit = nullptr;  ///< PREFIXcredit
  const char* done = nullptr;    ///< none
  const char* clock = nullptr;   ///< that of the design, where it has one
  bool has_ready = true;
  int credits = 0;      ///< 0: no credits
  int latency = -1;     ///< clocks; -1: any
  bool pulse = false;   ///< a transaction is a rising edge of valid
  bool steady = false;  ///< what is offered stays until it is taken
};

/// An interface for transactions X: an input stream goes into the design, an output stream comes
/// out of it. Each function gives a copy of it with one more property. `Driver`: void, or the type
/// of a driver of your own in place of valid and ready.
template <class X, class Driver = void>
struct Stream {
  using Record = X;
  using Own = Driver;

  StreamPorts ports;

  /// Its ports begin with `text`: prefix("s_axis_t") makes them s_axis_tvalid, s_axis_tready.
  constexpr Stream prefix(const char* text) const { return with(&StreamPorts::prefix, text); }
  constexpr Stream valid(const char* port) const { return with(&StreamPorts::valid, port); }
  constexpr Stream ready(const char* port) const { return with(&StreamPorts::ready, port); }
  /// Of a design with several clocks, each interface: it gives and takes on the edges of this one.
  constexpr Stream clock(const char* port) const { return with(&StreamPorts::clock, port); }
  /// There is no ready: the side that takes can always take.
  constexpr Stream always_ready() const { return with(&StreamPorts::has_ready, false); }
  /// Credits in place of ready: the side that gives may give `n` transactions, and one more for
  /// each clock on which the other side sets the port PREFIXcredit, or `port`.
  constexpr Stream credit(int n, const char* port = nullptr) const {
    return always_ready().with(&StreamPorts::credits, n).with(&StreamPorts::credit, port);
  }
  /// Of an input stream, in place of ready: valid is high for one clock, on which the transaction
  /// is taken; its fields stay, and the next one waits until the output `port` was high after it.
  /// With valid("start") this is a plain start and done.
  constexpr Stream until(const char* port) const {
    return always_ready().with(&StreamPorts::done, port);
  }
  /// Of an output stream: valid may stay high; each rising edge of it is a transaction.
  constexpr Stream rising() const { return always_ready().with(&StreamPorts::pulse, true); }
  /// Of an output stream: what is offered and not taken must be offered unchanged on the next
  /// clock. With rising(): what came must stay as long as valid does.
  constexpr Stream steady() const { return with(&StreamPorts::steady, true); }
  /// Of an output stream: a transaction comes at most `clocks` after the last input that it needs
  /// has gone in; 0: on the same clock. A clock on which this stream moves, or is made to wait,
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
  std::int64_t value = 0;  ///< of a reset: the level that resets; of a tied input: its value
  int width = 1;           ///< bits, from 1 on
  int clocks = 1;          ///< of a reset: how long it lasts
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
