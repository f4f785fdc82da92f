// Where the cells of a field lie in the RTL, once it is known what the RTL has by that name.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/core/fields.h"

namespace cosim {

/// What Field::net says: "a.b[7:4]" is bits 7 to 4 of net b in instance a. Bits are counted from 0,
/// the lowest, whatever range the RTL gives its net.
struct NetPath {
  std::string path;  ///< without what stands in brackets at its end
  int word = -1;     ///< "[N]", the word of a memory, or bit N of a net; -1: none
  int high = -1, low = -1;
};
/// A bracket that holds neither N nor N:N belongs to the path.
NetPath net_path(const std::string& net);

/// What the RTL has by a name: a net, or a memory.
struct RtlNet {
  int width = 1;  ///< bits, of a memory those of a word
  int words = 0;  ///< of a memory; 0: a net
};

/// Bits of a net, or of a word of a memory.
struct Place {
  int word = -1;  ///< -1: of a net
  int low = 0;
};

/// The cells of one field in what the RTL has by its name. They fill a net or a slice exactly, and
/// a memory exactly, from bit 0 of word 0 up. InputError "WHAT: ..." where they do not.
std::vector<Place> places_in(const RtlNet& net, std::span<const Field> cells,
                             const std::string& what);

/// The cells of each field of a table that the shape has, those of an array together.
std::vector<std::span<const Field>> rows_of(std::span<const Field> cells);

}  // namespace cosim
