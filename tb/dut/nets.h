// Where the ports and registers of an instance lie, found by name.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <verilated.h>

#include "model/core/fields.h"
#include "tb/dut/port_net.h"

namespace cosim {

/// Where the value of a cell lies: in 1, 2, 4 or 8 bytes that hold nothing else, or in some bits of
/// a wide net. One that the shape does not have lies nowhere, and is 0.
struct Net {
  void* data = nullptr;
  int bytes = 0;  ///< 0: not whole bytes
  int low = 0;    ///< the first bit, where it is not whole bytes
  int width = 0;

  Word get() const {
    switch (bytes) {
      case 1:
        return *static_cast<const std::uint8_t*>(data);
      case 2:
        return *static_cast<const std::uint16_t*>(data);
      case 4:
        return *static_cast<const std::uint32_t*>(data);
      case 8:
        return static_cast<Word>(*static_cast<const std::uint64_t*>(data));
      default:
        return width == 0 ? 0 : get_bits();
    }
  }
  void set(Word value) const {
    switch (bytes) {
      case 1:
        *static_cast<std::uint8_t*>(data) = static_cast<std::uint8_t>(value);
        break;
      case 2:
        *static_cast<std::uint16_t*>(data) = static_cast<std::uint16_t>(value);
        break;
      case 4:
        *static_cast<std::uint32_t*>(data) = static_cast<std::uint32_t>(value);
        break;
      case 8:
        *static_cast<std::uint64_t*>(data) = static_cast<std::uint64_t>(value);
        break;
      default:
        if (width != 0) set_bits(value);
    }
  }

 private:
  Word get_bits() const;
  void set_bits(Word value) const;
};

/// What a design says of its pins.
struct Ports {
  std::string title;       ///< of the shape, for errors
  const char* clock = "";  ///< the pin's name, "" where there is none, or several, which are inputs
  std::vector<Field> inputs = {}, outputs = {};
  const char* extra = "";                 ///< an input that no table names, or ""
  std::string clocks = "";                ///< of several: lines "NAME" or "falling NAME"
  std::vector<std::string> unobserved{};  ///< patterns of outputs that no table need name
};

/// The cells of the pins in the order of `ports`: inputs, then outputs, then the clock, one that
/// lies nowhere where there is none. InputError if a port of the RTL, or a bit of one, is in
/// neither table and not `unobserved`, if one in a table is no such port, if a width differs, and
/// if the inputs that are clocks are not `clocks`.
std::vector<Net> find_ports(const std::vector<PortNet>& of_rtl, const Ports& ports);
/// The cells of the design's registers and memories; of a net that carries a register's value, as
/// `text` says, which is of cosim_rtl, those of the register. InputError if there is no net of that
/// path and width.
std::vector<Net> find_registers(VerilatedContext& context, const std::string& title,
                                std::span<const Field> cells, std::string_view text = "");
/// The path of a scope as the RTL has it: "TOP.top.g[1].part" of "TOP.top.g__BRA__1__KET__.part";
/// newer versions of Verilator may write it so.
std::string plain_path(std::string path);

}  // namespace cosim
