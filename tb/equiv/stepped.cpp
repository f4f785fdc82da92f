#include "tb/equiv/stepped.h"

#include <algorithm>

namespace cosim::equiv {

Stepped::Stepped(const Side& side, bool cut, bool steps)
    : side_(side),
      cut_(cut),
      steps_(steps),
      made_([&] {
        Bits unknown(side.unknowns), state(side.registers.size());
        const auto added = [&](std::size_t& place) {
          place = graph_.inputs().size();
          return graph_.input();
        };
        unknowns_.resize(unknown.size());
        states_.resize(state.size());
        for (std::size_t i = 0; i < unknown.size(); ++i) unknown[i] = added(unknowns_[i]);
        for (std::size_t i = 0; i < state.size(); ++i) state[i] = added(states_[i]);
        return side.make(
            graph_,
            [&](const Name& name) {
              const Bit input = graph_.input();
              ports_[name] = graph_.inputs().size() - 1;
              return input;
            },
            unknown, state);
      }()),
      inputs_(graph_.inputs().size(), 0),
      next_(side.registers.size(), 0),
      runs_(graph_),
      random_(Random::for_case(47, 0)) {
  for (Values& bits : next_) bits = unknown();
  for (const auto& [clock, falls] : side.clocks) {  // as it is before its edge
    if (const auto at = ports_.find({clock, 0}); at != ports_.end() && falls) {
      inputs_[at->second] = ~Values{0};
    }
  }
  if (!cut_) return;
  std::size_t number = 0;
  for (const Cell& cell : side.module().cells) {
    if (!cell.is_memory()) continue;
    Held held;
    held.width = cell.number("WIDTH");
    held.address = cell.number("ABITS");
    held.words = cell.number("SIZE");
    held.low = cell.number("OFFSET");
    held.reads = cell.number("RD_PORTS");
    held.writes = cell.number("WR_PORTS");
    for (std::size_t i = 0; i < held.reads * held.width; ++i) {
      held.read_data.push_back(ports_.at({memory_port(number, "RD_DATA"), static_cast<int>(i)}));
    }
    const auto pins = [&](const char* pin) {
      Bits lits;
      for (std::size_t i = 0; i < cell.pins.at(pin).size(); ++i) {
        lits.push_back(made_.outputs.at({memory_port(number, pin), static_cast<int>(i)}));
      }
      return lits;
    };
    held.read_address = pins("RD_ADDR");
    held.enable = pins("WR_EN");
    held.write_address = pins("WR_ADDR");
    held.data = pins("WR_DATA");
    held.bits.resize(held.words * held.width);
    const std::string& digits = cell.parameter("INIT");
    held.first.assign(digits.rbegin(), digits.rend());
    memories_.push_back(std::move(held));
    begin_memory(number, memories_[number].first);
    ++number;
  }
}

Stepped::Values Stepped::unknown() { return (random_.next() & ~Values{3}) | 2U; }

void Stepped::begin(std::size_t reg, char digit) {
  next_[reg] = digit == '1' ? ~Values{0} : digit == '0' ? 0 : unknown();
}

void Stepped::begin_alike(unsigned fill) {
  Random chance = Random::for_case(48, fill);
  const auto digit = [&] { return fill == 0 || (fill > 1 && chance.next() % 2 == 0) ? '0' : '1'; };
  for (std::size_t i = 0; i < next_.size(); ++i) {
    const Register& reg = side_.registers[i];
    begin(i, reg.any ? digit() : reg.first ? '1' : '0');
  }
  for (std::size_t m = 0; m < memories_.size(); ++m) {
    std::string digits = memories_[m].first;
    digits.resize(memories_[m].bits.size(), 'x');
    for (char& one : digits) one = one == '0' || one == '1' ? one : digit();
    begin_memory(m, digits);
  }
}

void Stepped::begin_memory(std::size_t memory, const std::string& digits) {
  std::vector<Values>& bits = memories_[memory].bits;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const char digit = i < digits.size() ? digits[i] : 'x';
    bits[i] = digit == '1' ? ~Values{0} : digit == '0' ? 0 : unknown();
  }
}

void Stepped::settle(const std::map<std::string, std::string>& inputs) {
  for (const auto& [port, digits] : inputs) {
    for (std::size_t i = 0; i < digits.size(); ++i) {
      const auto at = ports_.find({port, static_cast<int>(digits.size() - 1 - i)});
      if (at != ports_.end()) inputs_[at->second] = digits[i] == '1' ? ~Values{0} : 0;
    }
  }
  for (const std::size_t place : unknowns_) inputs_[place] = unknown();
  for (std::size_t i = 0; i < states_.size(); ++i) inputs_[states_[i]] = next_[i];
  runs_.clock(inputs_);
  // What one memory reads may be the address of another.
  for (std::size_t round = 0; round <= memories_.size() + 1; ++round) {
    bool changed = false;
    for (std::size_t m = 0; m < memories_.size(); ++m) changed = read(m) || changed;
    if (!changed) break;
    runs_.clock(inputs_);
  }
}

void Stepped::clock(const std::map<std::string, std::string>& inputs) {
  settle(inputs);
  for (std::size_t i = 0; i < next_.size(); ++i) next_[i] = runs_.of(made_.next[i]);
  for (std::size_t m = 0; m < memories_.size(); ++m) write(m);
}

Stepped::Addresses Stepped::addresses(const Bits& pins, const Held& held, std::size_t port) const {
  Addresses all{};
  for (std::size_t i = held.address; i-- > 0;) {
    const Values bits = runs_.of(pins[port * held.address + i]);
    for (unsigned run = 0; run < 64; ++run) {
      const bool is_long = all[run] >> 62U != 0;  // far beyond the end, and stays there
      all[run] = (is_long ? ~std::size_t{0} >> 2U : all[run]) << 1U | (bits >> run & 1U);
    }
  }
  for (std::size_t& at : all) at -= held.low;  // what is below is far beyond the end
  return all;
}

bool Stepped::read(std::size_t memory) {
  Held& held = memories_[memory];
  bool changed = false;
  for (std::size_t port = 0; port < held.reads; ++port) {
    const Addresses at = addresses(held.read_address, held, port);
    const bool is_one = std::all_of(at.begin(), at.end(), [&](auto a) { return a == at[0]; });
    for (std::size_t i = 0; i < held.width; ++i) {
      // Beyond the end it is not known; but the same as long as the address is.
      const auto stored = [&](std::size_t word) {
        return word < held.words ? held.bits[word * held.width + i]
                                 : (Random::for_case(word, i).next() | 2U) & ~Values{1};
      };
      Values bits = is_one ? stored(at[0]) : 0;
      for (unsigned run = 0; !is_one && run < 64; ++run) bits |= stored(at[run]) & Values{1} << run;
      Values& input = inputs_[held.read_data[port * held.width + i]];
      changed = changed || input != bits;
      input = bits;
    }
  }
  return changed;
}

void Stepped::write(std::size_t memory) {
  Held& held = memories_[memory];
  // Where clocks are inputs it has its edge on some steps alone.
  const auto clock = ports_.find({side_.memories[memory].clock, 0});
  if (steps_ && clock != ports_.end() && inputs_[clock->second] == 0) return;
  for (std::size_t port = 0; port < held.writes; ++port) {
    const auto pin = [&](const Bits& lits, std::size_t i) {
      return runs_.of(lits[port * held.width + i]);
    };
    Values any = 0;
    for (std::size_t i = 0; i < held.width; ++i) any |= pin(held.enable, i);
    if (any == 0) continue;
    const Addresses at = addresses(held.write_address, held, port);
    const bool is_one = std::all_of(at.begin(), at.end(), [&](auto a) { return a == at[0]; });
    for (std::size_t i = 0; i < held.width; ++i) {
      const Values enabled = pin(held.enable, i), data = pin(held.data, i);
      const auto store = [&](std::size_t word, Values runs) {
        if (word >= held.words) return;
        Values& stored = held.bits[word * held.width + i];
        stored = (stored & ~runs) | (data & runs);
      };
      if (is_one) {
        store(at[0], enabled);
        continue;
      }
      for (unsigned run = 0; run < 64; ++run) store(at[run], enabled & Values{1} << run);
    }
  }
}

}  // namespace cosim::equiv
