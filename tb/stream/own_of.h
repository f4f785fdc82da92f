// A driver of a design's own, as a run of any design has it.
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "tb/stream/codes.h"
#include "tb/stream/own.h"

namespace cosim::detail {

/// What the driver drives within the clock, if it does.
template <class Driver>
bool answer_of(Driver& driver, std::span<const Word> pins, std::span<Word> drives) {
  if constexpr (requires(const typename Driver::Reads& reads) { driver.answer(reads); }) {
    Codes<typename Driver::Drives>::put(driver.answer(Codes<typename Driver::Reads>::object(pins)),
                                        drives);
    return true;
  }
  return false;
}

template <class Driver, class X>
class OwnGiverOf final : public OwnGiver {
 public:
  void drive(const std::span<const Word>* words, std::span<Word> pins) override {
    if (words != nullptr && !is_offered_) offered_.push_back(Codes<X>::object(*words));
    is_offered_ |= words != nullptr;
    const X* one = words != nullptr ? &offered_.back() : nullptr;
    Codes<typename Driver::Drives>::put(driver_.drive(one), pins);
  }
  bool took(std::span<const Word> pins) override {
    const bool taken(driver_.took(Codes<typename Driver::Reads>::object(pins)));
    if (taken) is_offered_ = false;
    return taken;
  }
  bool answer(std::span<const Word> pins, std::span<Word> drives) override {
    return answer_of(driver_, pins, drives);
  }

 private:
  // A driver keeps the pointer for as long as the transaction takes at its pins, which may be
  // longer than until took(): each record stays where it is to the end of the case.
  std::deque<X> offered_;
  bool is_offered_ = false;  // the last one, and it has not gone in yet
  Driver driver_;
};

template <class Driver, class Y>
class OwnTakerOf final : public OwnTaker {
 public:
  void drive(bool ready, std::span<Word> pins) override {
    if constexpr (requires { typename Driver::Drives; }) {
      Codes<typename Driver::Drives>::put(driver_.drive(ready), pins);
    }
  }
  bool came(std::span<const Word> pins, std::vector<Word>& words) override {
    const auto one = driver_.came(Codes<typename Driver::Reads>::object(pins));
    if (!one) return false;
    words.resize(Codes<Y>::fields().size());
    Codes<Y>::put(*one, words);
    return true;
  }
  bool answer(std::span<const Word> pins, std::span<Word> drives) override {
    return answer_of(driver_, pins, drives);
  }

 private:
  Driver driver_;
};

/// The cells of a driver's pins, each by the name of its port.
template <class Pins>
std::vector<Field> pins_of() {
  const auto& fields = Codes<Pins>::fields();
  std::vector<Field> all(fields.begin(), fields.end());
  for (Field& f : all) f.name = f.net;
  return all;
}

/// Of a stream of X, whose driver may be void.
template <class Driver, class X, bool goes_in>
OwnDriver own_driver() {
  OwnDriver own;
  if constexpr (!std::is_void_v<Driver>) {
    using Reads = typename Driver::Reads;
    own.reads = pins_of<Reads>();
    if constexpr (requires { typename Driver::Drives; })
      own.drives = pins_of<typename Driver::Drives>();
    if constexpr (goes_in) {
      static_assert(
          requires(Driver driver, const Reads& pins) { driver.took(pins); },
          "the driver of a stream that goes in has Drives drive(const X*) and bool took(const "
          "Reads&)");
      own.giver = [] { return std::make_unique<OwnGiverOf<Driver, X>>(); };
    } else {
      static_assert(
          requires(Driver driver, const Reads& pins) { driver.came(pins); },
          "the driver of a stream that comes out has std::optional<Y> came(const Reads&)");
      own.taker = [] { return std::make_unique<OwnTakerOf<Driver, X>>(); };
    }
  }
  return own;
}

}  // namespace cosim::detail
