// The declaration of an entity of VHDL, as a text: what a testbench repeats.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cosim::equiv {

struct VhdlPort {
  std::string name;
  std::string mode;  ///< in small letters: in, out, inout, buffer or linkage
  std::string type;  ///< with its constraint, without a default
};

struct VhdlEntity {
  std::string name;
  std::string context;   ///< its library and use clauses
  std::string generics;  ///< their declarations, between the brackets
  std::vector<std::string> generic_names;
  std::vector<VhdlPort> ports;
};

/// The same in small letters: VHDL knows no others.
std::string small_letters(std::string text);

/// The entity of that name, in any case, in the text of a file.
std::optional<VhdlEntity> entity_in(std::string_view text, const std::string& name);

}  // namespace cosim::equiv
