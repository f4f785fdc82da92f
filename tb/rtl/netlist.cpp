#include "tb/rtl/netlist.h"

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "model/core/input_error.h"

namespace cosim::netlist {
namespace {

using Json = nlohmann::ordered_json;

std::vector<int> bits_of(const Json& bits) {
  std::vector<int> all;
  all.reserve(bits.size());
  for (const Json& bit : bits) {
    if (bit.is_number()) {
      all.push_back(bit.get<int>());
      continue;
    }
    const char digit = bit.get_ref<const std::string&>().front();
    all.push_back(digit == '0' ? zero : digit == '1' ? one : digit == 'z' ? is_z : is_x);
  }
  return all;
}

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string attribute(const Json& of, const char* name) {
  const auto all = of.find("attributes");
  if (all == of.end() || !all->contains(name)) return "";
  return text_of(all->at(name));
}

std::string declaration(const Json& port) {
  const auto width = static_cast<int>(port.at("bits").size());
  const int low = port.value("offset", 0);
  const bool rises = port.value("upto", 0) != 0;
  std::string text = port.value("signed", 0) != 0 ? "signed " : "";
  if (width > 1 || low != 0) {
    const std::string lowest = std::to_string(low), highest = std::to_string(low + width - 1);
    text += '[' + (rises ? lowest + ':' + highest : highest + ':' + lowest) + ']';
  }
  return text;
}

}  // namespace

const std::string& Cell::parameter(const std::string& called) const {
  static const std::string none = "0";
  const auto at = parameters.find(called);
  return at == parameters.end() || at->second.empty() ? none : at->second;
}

unsigned Cell::number(const std::string& called) const {
  const std::string& text = parameter(called);
  if (text.find_first_not_of("01") != std::string::npos) return 0;
  return static_cast<unsigned>(std::stoul(text, nullptr, 2));
}

Module module_of(const std::string& json) {
  const Json read = Json::parse(json, nullptr, false);
  if (!read.is_object()) throw InputError("yosys has written no JSON");
  for (const Json& from : read.at("modules")) {
    if (!from.at("attributes").contains("top")) continue;
    Module module;
    for (const auto& [name, port] : from.at("ports").items()) {
      module.ports.push_back(
          {name, port.at("direction"), declaration(port), bits_of(port.at("bits"))});
    }
    for (const auto& [name, cell] : from.at("cells").items()) {
      Cell made{name, cell.at("type"), attribute(cell, "src"), {}, {}, {}};
      for (const auto& [key, value] : cell.at("parameters").items()) {
        made.parameters[key] = text_of(value);
      }
      for (const auto& [pin, bits] : cell.at("connections").items()) {
        made.pins[pin] = bits_of(bits);
      }
      for (const auto& [pin, way] : cell.at("port_directions").items()) {
        if (way != "input") made.outputs.push_back(pin);
      }
      module.cells.push_back(std::move(made));
    }
    for (const auto& [name, net] : from.at("netnames").items()) {
      module.nets.push_back({name, bits_of(net.at("bits")), attribute(net, "init"),
                             net.value("hide_name", 0) == 0, net.value("offset", 0),
                             net.value("upto", 0) != 0});
    }
    return module;
  }
  throw InputError("yosys has written no top");
}

namespace {

// Of the attributes that are left once processes are cells, those that yosys takes a meaning from.
bool is_meant(const std::string& attribute) {
  return attribute == "\\init" || attribute == "\\blackbox" || attribute == "\\whitebox";
}

}  // namespace

std::string form_of(const std::string& rtlil) {
  std::map<std::string, std::size_t> numbers;
  std::string form;
  std::istringstream lines(rtlil);
  for (std::string line; std::getline(lines, line);) {
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

}  // namespace cosim::netlist
