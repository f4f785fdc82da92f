// A driver of a design's own, as a run of any design has it.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "model/core/input_error.h"
#include "tb/stream/own.h"
#include "tb/stream/payload.h"

namespace cosim::detail {

template <class Driver, class Record>
class OwnGiverOf final : public OwnGiver {
 public:
  template <class Params>
  explicit OwnGiverOf(const Params& p) : payload_(p) {}
  void drive(const std::span<const Word>* words, std::span<Word> pins) override {
    if (words == nullptr) return driver_.drive(nullptr, pins);
    if (!is_offered_) offered_.push_back(payload_.record(*words));
    is_offered_ = true;
    driver_.drive(&offered_.back(), pins);
  }
  bool took(std::span<const Word> pins) override {
    const bool taken = driver_.took(pins);
    if (taken) is_offered_ = false;
    return taken;
  }

 private:
  Payload<Record> payload_;
  // A driver keeps the pointer for as long as the transaction takes at its pins, which may be
  // longer than until took(): each record stays where it is to the end of the case.
  std::deque<Record> offered_;
  bool is_offered_ = false;  // the last one, and it has not gone in yet
  Driver driver_;
};

template <class Driver, class Record>
class OwnTakerOf final : public OwnTaker {
 public:
  template <class Params>
  explicit OwnTakerOf(const Params& p) : payload_(p), one_(payload_.cells()) {}
  void drive(bool ready, std::span<Word> pins) override { driver_.drive(ready, pins); }
  bool came(std::span<const Word> pins, std::vector<Word>& words) override {
    const std::optional<Record> record = driver_.came(pins);
    if (!record) return false;
    payload_.sequence({*record}, "a driver", "its stream", one_);
    words.assign(one_[0].begin(), one_[0].end());
    return true;
  }

 private:
  Payload<Record> payload_;
  Sequence one_;
  Driver driver_;
};

template <class Driver, class Record, class Params>
OwnDriver own_driver([[maybe_unused]] const Params& p, bool goes_in) {
  OwnDriver own;
  if constexpr (!std::is_void_v<Driver>) {
    const auto drives = Driver::drives(p);
    const auto reads = Driver::reads(p);
    own.drives.assign(drives.begin(), drives.end());
    own.reads.assign(reads.begin(), reads.end());
    if constexpr (requires(Driver d) { d.drive(nullptr, std::span<Word>()); }) {
      if (goes_in) own.giver = [&p] { return std::make_unique<OwnGiverOf<Driver, Record>>(p); };
    } else {
      if (!goes_in) own.taker = [&p] { return std::make_unique<OwnTakerOf<Driver, Record>>(p); };
    }
    if (!own.is_there()) {
      throw InputError(goes_in ? "a stream that goes in has the driver of one that comes out"
                               : "a stream that comes out has the driver of one that goes in");
    }
  }
  return own;
}

}  // namespace cosim::detail
