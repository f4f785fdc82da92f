// The ports of a Verilated class as data, and where it keeps the nets that a shape is opened for:
// for each class CMake writes ports_of() and known_nets, see ports.cmake.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "model/core/fields.h"

namespace cosim {

/// A port of the RTL and where an instance has it.
struct PortNet {
  const char* name;  ///< in the RTL
  bool is_input;
  int width;   ///< bits, of an array those of a word
  int words;   ///< of an array, of several dimensions all elements; 0: a plain port
  void* data;  ///< the lowest byte; words lie one behind the other
  int each;    ///< bytes of a word
};
/// The elements of VlUnpacked<VlUnpacked<T, 3>, 2>: 6.
template <class T>
inline constexpr int array_words = 1;
template <template <class, std::size_t> class Of, class T, std::size_t N>
inline constexpr int array_words<Of<T, N>> = static_cast<int>(N) * array_words<T>;

/// A port that is the member `pin` of a Verilated class.
template <class Pin>
PortNet port_net(const char* name, bool is_input, int width, int words, Pin& pin) {
  if constexpr (std::is_array_v<Pin>) {
    return {name,  is_input, width,
            words, &pin,     static_cast<int>(sizeof(std::remove_all_extents_t<Pin>))};
  } else if constexpr (requires { pin.data(); }) {
    return {name, is_input, width, words, pin.data(), static_cast<int>(sizeof pin)};
  } else {
    const auto each = sizeof pin / static_cast<std::size_t>(std::max(words, 1));
    return {name, is_input, width, words, &pin, static_cast<int>(each)};
  }
}

/// CMake writes one for each Verilated class: ports_of(Top&) gives its ports.
inline void ports_of() {}

/// And where all state of the class is known to come back, power_up_again(Top&), which makes it
/// what it is behind the constructor, and this as true.
inline void power_up_again() {}
template <class Top>
inline constexpr bool can_power_up = false;

/// A port or another net of at most 64 bits, and how many bytes behind the first of the class's
/// root it lies. A register that is a port is both.
struct NetOffset {
  std::string_view path;  ///< below the top: "divider.count"
  bool is_port;
  int width;
  std::ptrdiff_t at;
};
/// Those of the class Top that the compiler knows; none of one that is open as a whole.
template <class Top>
inline constexpr std::array<NetOffset, 0> known_nets{};

/// Where that is; -1 where it is none of them.
template <class Top>
constexpr std::ptrdiff_t known_place(std::string_view path, bool is_port, int width) {
  for (const NetOffset& net : known_nets<Top>) {
    if (net.path == path && net.is_port == is_port && net.width == width) return net.at;
  }
  return -1;
}
/// The same of the cells of a record.
template <class Top, std::size_t N>
constexpr std::array<std::ptrdiff_t, N> known_places(const std::array<Field, N>& cells,
                                                     bool are_ports) {
  std::array<std::ptrdiff_t, N> places{};
  for (std::size_t i = 0; i < N; ++i) {
    places[i] = known_place<Top>(cells[i].net, are_ports, cells[i].width);
  }
  return places;
}

}  // namespace cosim
