#include "tb/equiv/netlist.h"

#include <map>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/support/json.h"
#include "tb/support/words.h"

namespace cosim::equiv {

const Json& top_of(const Json& netlist) {
  for (const auto& module : netlist.at("modules")) {
    if (module.at("attributes").contains("top")) return module;
  }
  throw InputError("yosys has written no top");
}

Json& top_of(Json& netlist) { return const_cast<Json&>(top_of(static_cast<const Json&>(netlist))); }

namespace {

// Of the attributes that are left once processes are cells, those that yosys takes a meaning from.
bool is_meant(const std::string& attribute) {
  return attribute == "\\init" || attribute == "\\blackbox" || attribute == "\\whitebox";
}

}  // namespace

std::string form_of(const std::string& rtlil) {
  std::map<std::string, std::size_t> numbers;
  std::string form;
  for (const std::string& line : lines_in(rtlil)) {
    std::istringstream words(line);
    std::string first, word;
    if (!(words >> first) || first == "autoidx" || first == "module" || first.starts_with('#')) {
      continue;
    }
    // Text may hold anything, and stays as it is. What a person or a synthesizer is told in an
    // attribute is no part of what the RTL does.
    if (first == "attribute") words >> word;
    if (first == "parameter" || (first == "attribute" && is_meant(word))) form += line + '\n';
    if (first == "parameter" || first == "attribute") continue;
    form += first;
    if (first == "cell" && words >> word) form += ' ' + word;  // of which kind
    while (words >> word) {
      form += ' ';
      if (word.starts_with('$')) {
        form += '$' + std::to_string(numbers.try_emplace(word, numbers.size()).first->second);
      } else {
        form += word;
      }
    }
    form += '\n';
  }
  return form;
}

}  // namespace cosim::equiv
