// What the tree of a design says of its shape.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tb/rtl/design.h"

namespace cosim::rtl {

/// A member of a struct, by its path in it; or all of a net, with no name.
struct Part {
  std::string name;
  int high = 0, low = 0;
  bool is_signed = false;
  std::string type = {};  ///< an enum of Shape, or ""
  bool operator==(const Part&) const = default;
};

struct Shape {
  struct Net {
    int width = 0, words = 0;  ///< as of rtl::Net
    bool is_signed = false;
    std::vector<Part> parts = {};  ///< of a struct or an enum that is no memory; the highest first
    bool operator==(const Net&) const = default;
  };
  std::string top;
  std::vector<std::pair<std::string, std::string>> ports;  ///< "input" or "output", and its name
  std::vector<std::pair<std::string, long>> parameters;    ///< whole numbers of 32 bits
  std::map<std::string, Net> nets;                         ///< by their paths below the top
  std::map<std::string, std::vector<std::string>> enums;   ///< names of the values from 0 on
};

Shape shape_of(const std::filesystem::path& tree);

}  // namespace cosim::rtl
