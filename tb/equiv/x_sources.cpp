#include "tb/equiv/referee.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

const char* driving_pin(const Cell& cell) {
  return cell.is_memory() ? "RD_DATA" : cell.is_register() ? "Q" : "Y";
}

}  // namespace

bool may_be_x(const Side& side, Simulator simulator) {
  return side.has_zeros_by_type() && simulator == Simulator::icarus;
}

XSources::XSources(const Side& side, const Stimulus& shown, Simulator simulator,
                   std::chrono::steady_clock::time_point until)
    : side_(side), shown_(shown), simulator_(simulator), until_(until) {
  const Module& module = side.module();
  for (const Net& net : module.nets) bits_[net.name] = &net.bits;
  for (const Port& port : module.ports) bits_[port.name] = &port.bits;
  for (const Cell& cell : module.cells) {  // a word of a memory is what is read of it
    for (std::size_t w = 0; cell.is_memory() && w < cell.number("SIZE"); ++w) {
      bits_[fmt::format("{}[{}]", cell.name, w + cell.number("OFFSET"))] = &cell.pins.at("RD_DATA");
    }
  }
  std::set<std::size_t> is_shown;  // registers
  for (const Variable& one : shown.variables) {
    const auto is_it = [&](const auto& variable) { return variable.first == one.name; };
    const auto& registers = std::ranges::find_if(side.variables, is_it)->second;
    is_shown.insert(registers.begin(), registers.end());
  }
  std::size_t reg = 0;
  for (const Cell& cell : module.cells) {
    const auto pin = cell.pins.find(driving_pin(cell));
    if (pin == cell.pins.end()) continue;
    const std::vector<int>& bits = pin->second;
    for (const int bit : bits) driver_[bit] = &cell;
    const bool is_held = cell.is_memory() && !side.is_cut();
    const std::size_t registers = cell.is_register() ? bits.size()
                                  : is_held          ? cell.number("SIZE") * cell.number("WIDTH")
                                                     : 0;
    for (std::size_t i = 0; i < registers; ++i, ++reg) {
      const bool begins_as_x = side.registers[reg].any || may_be_x(side, simulator);
      if (!begins_as_x || is_shown.contains(reg)) continue;
      if (is_held) {
        hidden_.insert(bits.begin(), bits.end());
      } else {
        hidden_.insert(bits[i]);
      }
    }
    const auto is_it = [&](const Contents& one) { return one.name == cell.name; };
    const bool begins_as_x =
        cell.is_memory() && side.is_cut() && cell.parameter("INIT").find('x') != std::string::npos;
    if (begins_as_x && std::ranges::none_of(shown.memories, is_it)) {
      hidden_.insert(bits.begin(), bits.end());
    }
  }
}

void XSources::clock(std::set<std::string> registers) {
  before_ = std::exchange(now_, std::move(registers));
}

const std::set<int>& XSources::fan_in(const std::string& word) {
  const auto [at, is_new] = fan_in_.try_emplace(word);
  if (!is_new) return at->second;
  std::vector<int> open = *bits_.at(word);
  std::set<const Cell*> met;
  // A register depends on its own x only by way of what it is next.
  std::set<int> own(open.begin(), open.end());
  std::erase_if(own, [&](int bit) {
    const auto driver = driver_.find(bit);
    return driver == driver_.end() || !driver->second->is_register();
  });
  while (!open.empty()) {
    const int bit = open.back();
    open.pop_back();
    if (bit < 0 || (own.erase(bit) == 0 && !at->second.insert(bit).second)) continue;
    const auto driver = driver_.find(bit);
    if (driver == driver_.end() || !met.insert(driver->second).second) continue;
    for (const auto& [pin, bits] : driver->second->pins) {
      if (pin != driving_pin(*driver->second)) open.insert(open.end(), bits.begin(), bits.end());
    }
  }
  return at->second;
}

bool XSources::reaches(const std::string& from, const std::string& word) {
  const std::set<int>& all = fan_in(word);
  return std::ranges::any_of(*bits_.at(from), [&](int bit) { return all.contains(bit); });
}

bool XSources::reach(const std::string& word) {
  const auto is_source = [&](const std::string& reg) { return reaches(reg, word); };
  if (std::ranges::any_of(now_, is_source) || std::ranges::any_of(before_, is_source)) return true;
  if (hidden_.empty()) return false;
  const std::set<int>& all = fan_in(word);
  return std::ranges::any_of(hidden_, [&](int bit) { return all.contains(bit); });
}

bool XSources::net_reaches(const std::string& word, std::size_t t) { return reaches(x_, word, t); }

bool XSources::z_reaches(const std::string& word, std::size_t t) { return reaches(z_, word, t); }

bool XSources::reaches(const Drawn& drawn, const std::string& word, std::size_t t) {
  const std::size_t first = t == 0 ? 0 : t - 1;
  if (!drawn.contains(first) || !drawn.contains(t)) draw(first);
  for (const std::size_t clock : {first, t}) {
    for (const std::string& net : drawn.at(clock)) {
      if (reaches(net, word)) return true;
    }
  }
  return false;
}

// Runs some clocks with a wave, and takes from it which nets of the netlist are x on each.
void XSources::draw(std::size_t from) {
  constexpr std::size_t many = 64;
  x_.clear();
  z_.clear();
  for (std::size_t t = from; t < from + many; ++t) x_[t], z_[t];
  Stimulus s = shown_;
  s.rows.resize(std::min(s.rows.size(), from + many + 1));
  s.vcd = "yes";
  s.first_drawn = from;
  const Program program(side_, s, simulator_, until_);
  if (!program.why_not().empty()) return;
  program.run(until_);
  std::map<std::string, std::vector<std::string>> nets;  // by the wave's short names
  std::vector<std::string> scopes;
  std::set<std::string> is_x, is_z;
  std::size_t clock = from;
  for (const std::string& line : lines_in(program.wave())) {
    const std::vector<std::string> words = words_in(line);
    if (words.empty()) continue;
    const char first = line.front();
    if (words[0] == "$scope" && words.size() > 2) {
      scopes.push_back(words[2]);
    } else if (words[0] == "$upscope" && !scopes.empty()) {
      scopes.pop_back();
    } else if (words[0] == "$var" && words.size() > 4) {
      std::string name;
      const auto top = std::ranges::find(scopes, "cosim_dut");
      for (auto at = top; at != scopes.end(); ++at) {
        if (at != top) name += *at + '.';
      }
      name += words[4];
      if (top != scopes.end() && bits_.contains(name)) nets[words[3]].push_back(name);
    } else if (first == '#') {
      const std::uint64_t time = std::stoull(line.substr(1));
      const std::size_t now = time < clock_ps ? 0 : time / clock_ps - 1;
      for (; clock < now; ++clock) {
        x_[clock + 1] = is_x;
        z_[clock + 1] = is_z;
      }
    } else if (first == 'b' || std::string("01xXzZ").find(first) != std::string::npos) {
      const bool is_word = first == 'b' && words.size() > 1;
      const std::string value = is_word ? words[0] : line.substr(0, 1);
      const auto note = [&](const char* digits, std::set<std::string>& now, Drawn& drawn) {
        const bool has_it = value.find_first_of(digits) != std::string::npos;
        for (const std::string& net : nets[is_word ? words[1] : line.substr(1)]) {
          if (has_it) {
            now.insert(net);
            drawn[clock].insert(net);
          } else {
            now.erase(net);
          }
        }
      };
      note("xXzZ", is_x, x_);
      note("zZ", is_z, z_);
    }
  }
}

}  // namespace cosim::equiv
