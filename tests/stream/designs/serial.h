// Drivers of its own: a byte goes over one wire, bit after bit.
#pragma once

#include <optional>

#include "../../support/fault.h"
#include "model/core/stream.h"

namespace serial_model {

using namespace cosim;
using faulty::Params;

#define SERIAL_BYTE(FIELD) FIELD(byte, 8, number, "", "what is sent")
COSIM_RECORD(Sent, SERIAL_BYTE, Params);

/// Sends over rx.
class Sender {
 public:
  static constexpr auto drives(const Params&) { return std::array{pin::wire("rx")}; }
  static constexpr auto reads(const Params&) { return std::array{pin::wire("busy")}; }

  void drive(const Sent<Word>* sent, std::span<Word> pins) {
    if (bit_ == none && sent != nullptr && !busy_) bit_ = 0;
    pins[0] = bit_ == none || bit_ == 9 ? 1 : bit_ == 0 ? 0 : sent->byte >> (bit_ - 1) & 1;
  }
  bool took(std::span<const Word> pins) {
    busy_ = pins[0] != 0;
    if (bit_ == none || ++bit_ < 10) return false;
    bit_ = none;
    return true;
  }

 private:
  static constexpr int none = -1;
  int bit_ = none;  // 0: the start, 9: the stop
  bool busy_ = true;
};

/// Receives from tx.
class Receiver {
 public:
  static constexpr auto drives(const Params&) { return std::array{pin::wire("go")}; }
  static constexpr auto reads(const Params&) { return std::array{pin::wire("tx")}; }

  void drive(bool ready, std::span<Word> pins) { pins[0] = ready ? 1 : 0; }
  std::optional<Sent<Word>> came(std::span<const Word> pins) {
    if (bit_ == none) {
      if (pins[0] == 0) bit_ = byte_ = 0;
      return {};
    }
    if (bit_ < 8) {
      byte_ |= static_cast<int>(pins[0]) << bit_++;
      return {};
    }
    bit_ = none;
    return Sent<Word>{byte_};
  }

 private:
  static constexpr int none = -1;
  int bit_ = none, byte_ = 0;
};

struct Design : faulty::Design {
  static constexpr const char* name = "serial";
  static constexpr auto in(const Params&) { return stream<Sent>("in").by<Sender>(); }
  static constexpr auto out(const Params&) { return stream<Sent>("out").by<Receiver>(); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static std::vector<Sent<Word>> run(const Params&, const std::vector<Sent<Word>>& in) {
    std::vector<Sent<Word>> out;
    for (const Sent<Word>& sent : in) out.push_back({low_bits(sent.byte + 1, 8)});
    return out;
  }
};

}  // namespace serial_model
