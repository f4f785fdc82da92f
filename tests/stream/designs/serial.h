// Drivers of its own: a byte goes over one wire, bit after bit.
#pragma once

#include <cosim/stream.h>

template <int FAULT>
struct Serial {
  struct Sent {
    UInt<8> byte;  // what is sent
  };
  static constexpr int none = -1;

  /// Sends over rx.
  struct Sender {
    struct Drives {
      Bit rx;
    };
    struct Reads {
      Bit busy;
    };
    int bit = none;  // 0: the start, 9: the stop
    bool is_busy = true;

    Drives drive(const Sent* sent) {
      if (bit == none && sent != nullptr && !is_busy) bit = 0;
      if (bit == none || bit == 9) return {1};
      return {bit == 0 ? Bit(0) : sent->byte[bit - 1]};
    }
    bool took(const Reads& pins) {
      is_busy = bool(pins.busy);
      if (bit == none || ++bit < 10) return false;
      bit = none;
      return true;
    }
  };

  /// Receives from tx.
  struct Receiver {
    struct Drives {
      Bit go;
    };
    struct Reads {
      Bit tx;
    };
    int bit = none;
    UInt<8> byte = 0;

    Drives drive(bool ready) { return {ready}; }
    std::optional<Sent> came(const Reads& pins) {
      if (bit == none) {
        if (!pins.tx) bit = 0;
        return {};
      }
      if (bit < 8) {
        byte[bit++] = pins.tx;
        return {};
      }
      bit = none;
      return Sent{byte};
    }
  };

  static constexpr auto in() { return stream<Sent, Sender>("in"); }
  static constexpr auto out() { return stream<Sent, Receiver>("out"); }
  static constexpr auto pins() { return std::array{pin::reset("rst")}; }
  static std::vector<Sent> run(const std::vector<Sent>& in) {
    std::vector<Sent> out;
    for (const Sent& sent : in) out.push_back({sent.byte + 1});
    return out;
  }
};
