// Stream models: a design as an untimed function from the transactions that go in at its interfaces
// to those that must come out. There is no clock in it: how long anything takes, and who waits for
// whom, is left to the harness.
//
// What goes through an interface is a record of fields. struct Design says which interfaces there
// are, and what comes out:
//
//   static constexpr auto in(const Params&) { return stream<X>("x"); }
//   static constexpr auto out(const Params& p) { return stream<Y>("y").latency(p.stages + 1); }
//   static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
//   static std::vector<Y<Word>> run(const Params& p, const std::vector<X<Word>>& x);
//
// Of several interfaces in() and out() give a std::tuple, run() takes a vector of each and gives a
// std::tuple of vectors. Fields with a sign are numbers in run(), of both sides. run() gives, for
// the first transactions of a case alone, the first of the results: what came out once stays.
//
// An interface of another kind has a driver of one's own, by<Driver>(). Of a stream that goes in:
//
//   struct Driver {
//     static constexpr auto drives(const Params&) { return std::array{pin::wire("rx")}; }
//     static constexpr auto reads(const Params&) { return std::array{pin::wire("busy")}; }
//     void drive(const X<Word>* x, std::span<Word> pins);  // those that it drives, on this clock
//     bool took(std::span<const Word> pins);               // those that it reads, later on it
//   };
//
// x is the transaction that may go in, the same until took() says that it has; null where there is
// none, or the case holds it back. Of one that comes out drive(bool ready, pins), where ready is
// false while the case takes nothing, and std::optional<Y<Word>> came(pins). A driver is made anew
// for each case; drive() is called once in the reset, too.
//
// The ports of stream "x" are x_valid, x_ready, and x_FIELD for each field; prefix() puts something
// else before them, and a field with at("PORT") has that port. A transaction passes on a clock on
// which valid and ready are both high.
#pragma once

#include <array>
#include <span>
#include <tuple>
#include <vector>

#include "model/core/record.h"

namespace cosim {

/// A design that has a stream model. It may have a step beside it, design.h: then all is compared.
template <class Design>
concept HasStreams = requires(const typename Design::Params& p) {
  Design::in(p);
  Design::out(p);
};

/// What an interface has beside its fields. A null name is that of the default.
struct StreamPorts {
  const char* name;
  const char* prefix = nullptr;  ///< NAME_
  const char* valid = nullptr;   ///< PREFIXvalid
  const char* ready = nullptr;   ///< PREFIXready
  const char* credit = nullptr;  ///< PREFIXcredit
  const char* done = nullptr;    ///< none
  bool has_ready = true;
  int credits = 0;      ///< 0: no credits
  int latency = -1;     ///< clocks; -1: any
  bool pulse = false;   ///< a transaction is a rising edge of valid
  bool steady = false;  ///< what is offered stays until it is taken
};

/// An interface for transactions of the type Record<Word>. Each function gives it with one more
/// thing said of it.
/// `Driver`: void, or one of its own in place of valid and ready.
template <template <class> class Record, class Driver = void>
struct Stream {
  template <class V>
  using Payload = Record<V>;
  using Own = Driver;

  StreamPorts ports;

  /// It has pins of another kind, and a driver that knows them.
  template <class Other>
  constexpr Stream<Record, Other> by() const {
    return {ports};
  }

  /// Its ports begin with `text`: prefix("s_axis_t") makes them s_axis_tvalid, s_axis_tready.
  constexpr Stream prefix(const char* text) const { return with(&StreamPorts::prefix, text); }
  constexpr Stream valid(const char* port) const { return with(&StreamPorts::valid, port); }
  constexpr Stream ready(const char* port) const { return with(&StreamPorts::ready, port); }
  /// There is no ready: whoever takes can always take.
  constexpr Stream always_ready() const { return with(&StreamPorts::has_ready, false); }
  /// In place of ready: whoever gives may give `n` transactions, and one more for each clock on
  /// which the other side sets the port PREFIXcredit, or `port`.
  constexpr Stream credit(int n, const char* port = nullptr) const {
    return always_ready().with(&StreamPorts::credits, n).with(&StreamPorts::credit, port);
  }
  /// Of a stream that goes in, in place of ready: a transaction is taken on its one clock of valid,
  /// its fields stay, and the next one waits until the output `port` has been high after it. With
  /// valid("start") this is a plain start and done.
  constexpr Stream until(const char* port) const {
    return always_ready().with(&StreamPorts::done, port);
  }
  /// Of a stream that comes out: valid may stay high; a transaction is its rising edge.
  constexpr Stream rising() const { return always_ready().with(&StreamPorts::pulse, true); }
  /// Of a stream that comes out: what is offered and not taken must be offered unchanged on the
  /// next clock; of one that is rising(), what came must stay as long as valid does.
  constexpr Stream steady() const { return with(&StreamPorts::steady, true); }
  /// Of a stream that comes out: a transaction comes at most `clocks` after the last one that goes
  /// in and that it needs; a clock on which this stream moves or is made to wait does not count.
  /// 0: on the same clock.
  constexpr Stream latency(int clocks) const { return with(&StreamPorts::latency, clocks); }

 private:
  template <class Member>
  constexpr Stream with(Member StreamPorts::*member, Member value) const {
    Stream s = *this;
    s.ports.*member = value;
    return s;
  }
};

template <template <class> class Record>
constexpr Stream<Record> stream(const char* name) {
  return {{name}};
}

/// A port of the top module that is no part of a transaction.
struct Pin {
  enum class Kind { reset, tied, unread, driver };
  const char* port;
  Kind kind;
  Word value = 0;  ///< of a reset: where it resets; of a tied input: always
  int width = 1;   ///< bits, 1 to 64
  int clocks = 1;  ///< of a reset
};

namespace pin {

/// High, or low, for so many clocks at the start of each case, then the other.
constexpr Pin reset(const char* port, int clocks = 2) {
  return {port, Pin::Kind::reset, 1, 1, clocks};
}
constexpr Pin reset_low(const char* port, int clocks = 2) {
  return {port, Pin::Kind::reset, 0, 1, clocks};
}
/// An input that always has one value.
constexpr Pin tied(const char* port, Word value, int width = 1) {
  return {port, Pin::Kind::tied, value, width};
}
/// Of a driver of one's own.
constexpr Pin wire(const char* port, int width = 1) { return {port, Pin::Kind::driver, 0, width}; }
/// An output that nobody looks at.
constexpr Pin unread(const char* port, int width = 1) {
  return {port, Pin::Kind::unread, 0, width};
}

}  // namespace pin
}  // namespace cosim
