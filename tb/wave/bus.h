// What a wave shows as one trace: a cell, or the words of a wide number together.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/core/fields.h"

namespace cosim {

struct Bus {
  std::string name;       ///< of a cell its label, "store[3]"; of a wide number that of its field
  Field field;            ///< the cell, or the first word
  std::size_t first = 0;  ///< the number of that cell
  std::size_t count = 1;  ///< cells, the lowest bits first
  int width = 1;          ///< bits of all together
};

inline std::vector<Bus> buses_of(const std::vector<Field>& cells) {
  std::vector<Bus> all;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Field& f = cells[i];
    if (f.is_word && f.index > 0) {
      ++all.back().count;
      all.back().width += f.width;
    } else {
      all.push_back({f.is_word ? f.name : label_of(f), f, i, 1, f.width});
    }
  }
  return all;
}

}  // namespace cosim
