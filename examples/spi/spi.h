// A device on the SPI of spi.v: it gets each byte that is sent, and answers with those that it is
// given.
#pragma once

#include <optional>

#include "model/core/stream.h"

namespace spi_model {

using namespace cosim;

struct Params {};

#define SPI_BYTE(FIELD) FIELD(data, 8, bits, "", "a byte")
COSIM_RECORD(Byte, SPI_BYTE, Params);

/// Takes a bit of mosi where sclk rises while cs_n is low, the highest first.
class Device {
 public:
  static constexpr auto drives(const Params&) { return std::array{pin::wire("miso")}; }
  static constexpr auto reads(const Params&) {
    return std::array{pin::wire("cs_n"), pin::wire("sclk"), pin::wire("mosi")};
  }
  /// The answer is the byte before this one, inverted.
  void drive(bool, std::span<Word> pins) { pins[0] = ~answer_ >> (7 - bits_) & 1; }
  std::optional<Byte<Word>> came(std::span<const Word> pins) {
    const bool rises = pins[0] == 0 && pins[1] != 0 && !sclk_;
    sclk_ = pins[1] != 0;
    if (!rises) return {};
    byte_ = low_bits(byte_ << 1 | pins[2], 8);
    if (++bits_ < 8) return {};
    bits_ = 0;
    answer_ = byte_;
    return Byte<Word>{byte_};
  }

 private:
  bool sclk_ = false;
  int bits_ = 0;
  Word byte_ = 0, answer_ = 0;
};

struct Design {
  using Params = spi_model::Params;
  static constexpr const char* name = "spi";
  static constexpr std::array<Parameter, 0> parameters(const Params&) { return {}; }
  static constexpr auto in(const Params&) { return stream<Byte>("send"); }
  static constexpr auto out(const Params&) {
    return std::tuple{stream<Byte>("wire").by<Device>(), stream<Byte>("got").always_ready()};
  }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }

  static std::tuple<std::vector<Byte<Word>>, std::vector<Byte<Word>>> run(
      const Params&, const std::vector<Byte<Word>>& sent) {
    std::vector<Byte<Word>> got;
    Word before = 0;
    for (const Byte<Word>& byte : sent) {
      got.push_back({low_bits(~before, 8)});
      before = byte.data;
    }
    return {sent, got};
  }
};

}  // namespace spi_model
