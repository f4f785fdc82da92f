// A device on the SPI of spi.v: it gets each byte that is sent, and answers with those that it is
// given.
#pragma once

#include <cosim/stream.h>

struct Spi {
  struct Byte {
    Hex<UInt<8>> data;  // a byte
  };

  /// Takes a bit of mosi where sclk rises while cs_n is low, the highest first.
  struct Device {
    struct Drives {
      Bit miso;
    };
    struct Reads {
      Bit cs_n, sclk, mosi;
    };
    bool was_high = false;  // sclk, a clock ago
    int bits = 0;           // of this byte that came
    UInt<8> byte = 0, answer = 0;

    /// The answer is the byte before this one, inverted.
    Drives drive(bool) { return {~answer[7 - bits]}; }
    std::optional<Byte> came(const Reads& pins) {
      const bool rises = !pins.cs_n && pins.sclk && !was_high;
      was_high = bool(pins.sclk);
      if (!rises) return {};
      byte = cat(byte, pins.mosi);
      if (++bits < 8) return {};
      bits = 0;
      answer = byte;
      return Byte{byte};
    }
  };

  static constexpr auto in() { return stream<Byte>("send"); }
  static constexpr auto out() {
    return std::tuple{stream<Byte, Device>("wire"), stream<Byte>("got").always_ready()};
  }
  static constexpr auto pins() { return std::array{pin::reset("rst")}; }

  static std::tuple<std::vector<Byte>, std::vector<Byte>> run(const std::vector<Byte>& sent) {
    std::vector<Byte> got;
    UInt<8> before = 0;
    for (const Byte& byte : sent) {
      got.push_back({~before});
      before = byte.data;
    }
    return {sent, got};
  }
};
