#include "tb/equiv/renamed.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "model/core/input_error.h"
#include "tb/equiv/clocks.h"
#include "tb/equiv/stepped.h"
#include "tb/util/random.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

using Variables = std::map<std::string, std::vector<std::size_t>>;  // by name: bits, lowest first

// The registers of a side by their names; one that has no name for each of its bits is left out.
Variables variables_of(const Side& side) {
  std::map<std::string, std::map<int, std::size_t>> bits;
  for (std::size_t i = 0; i < side.registers.size(); ++i) {
    const Name& name = side.registers[i].name;
    if (!name.first.empty()) bits[name.first][name.second] = i;
  }
  Variables all;
  for (const auto& [name, numbers] : bits) {
    for (const auto& [bit, number] : numbers) all[name].push_back(number);
  }
  return all;
}

// What begins alike in both: of the same name the same value, else 0.
char begins(const Side& side, std::size_t reg) {
  const Register& is = side.registers[reg];
  if (!is.any) return is.first ? '1' : '0';
  const std::size_t hash =
      std::hash<std::string>()(fmt::format("{}[{}]", is.name.first, is.name.second));
  return Random::for_case(1989, hash).below(2) == 0 ? '0' : '1';
}

// What each variable holds on each clock, where all that is not known is 0.
std::map<std::string, std::string> traces(const Question& q, const Side& side, bool is_gate,
                                          const Variables& variables,
                                          const Variables& without_partner) {
  Stepped stepped(side, side.is_cut(), q.steps);
  for (std::size_t i = 0; i < side.registers.size(); ++i) stepped.begin(i, begins(side, i));
  for (const auto& [name, bits] : without_partner) {
    for (const std::size_t bit : bits) {
      if (side.registers[bit].any) stepped.begin(bit, '0');
    }
  }
  std::map<std::string, std::string> all;
  constexpr int clocks = 400;
  for (int t = 0; t < clocks; ++t) {
    std::map<std::string, std::string> row;
    for (const auto& [port, width] : side.inputs) {
      const std::string old = is_gate ? gold_name(q, port) : port;
      Random random = Random::for_case(std::hash<std::string>()(old), static_cast<unsigned>(t));
      std::string digits;
      for (int bit = 0; bit < width; ++bit) digits += random.below(2) == 0 ? '0' : '1';
      if (const auto tied = q.tied.find(old); tied != q.tied.end()) {
        digits = std::string(digits.size() - tied->second.size(), '0') + tied->second;
      }
      if (q.resets && q.resets->contains(old)) {
        const bool resets = t < q.reset_clocks || random.below(64) == 0;
        digits = resets == q.resets->at(old) ? "1" : "0";
      }
      row[port] = digits;
    }
    stepped.clock(row);
    for (const auto& [name, bits] : variables) {
      for (const std::size_t bit : bits) all[name] += (stepped.seen(bit) & 1U) != 0 ? '1' : '0';
    }
  }
  return all;
}

Variables only_in(const Variables& all, const Variables& other) {
  Variables only;
  for (const auto& [name, bits] : all) {
    const auto at = other.find(name);
    if (at == other.end() || at->second.size() != bits.size()) only[name] = bits;
  }
  return only;
}

void rename(Question& q, const Variables& olds, const Variables& news, const std::string& old_name,
            const std::string& new_name) {
  const auto &from = olds.at(old_name), &to = news.at(new_name);
  for (std::size_t i = 0; i < to.size(); ++i) {
    q.gate.registers[to[i]].name = q.gold.registers[from[i]].name;
  }
}

void name_known(Question& q, const Variables& olds, const Variables& news) {
  for (const auto& [old_name, new_name] : q.same) {
    // Where both drive a net of one name they are one already.
    const auto is_paired = [&from = old_name, &to = new_name](const Register& r) {
      return r.name.first == from && r.nets.contains({to, r.name.second});
    };
    if (std::ranges::any_of(q.gate.registers, is_paired)) continue;
    const auto from = olds.find(old_name), to = news.find(new_name);
    if (from == olds.end() || to == news.end()) {
      throw InputError(fmt::format("--same: the {} RTL has no register {}",
                                   from == olds.end() ? "old" : "new",
                                   in_quotes(from == olds.end() ? old_name : new_name)));
    }
    if (from->second.size() != to->second.size()) {
      throw InputError(fmt::format("--same: {} has {} bits and {} has {}", in_quotes(old_name),
                                   from->second.size(), in_quotes(new_name), to->second.size()));
    }
    rename(q, olds, news, old_name, new_name);
  }
}

}  // namespace

void name_alike(Side& gold, Side& gate) {
  std::map<std::string, const Net*> olds;
  for (const Net& net : gold.module().nets) olds[net.name] = &net;
  std::set<std::string> nets;
  for (const Net& net : gate.module().nets) {
    const auto old = olds.find(net.name);
    if (old != olds.end() && old->second->bits.size() != net.bits.size()) nets.insert(net.name);
  }
  gold.number_as_declared(nets);
  gate.number_as_declared(nets);
  gate.name_as(gold);
}

std::map<std::string, std::string> name_renamed(Question& q) {
  const Variables old_all = variables_of(q.gold), new_all = variables_of(q.gate);
  name_known(q, old_all, new_all);
  std::map<std::string, std::string> pairs = q.same;
  const Variables now = variables_of(q.gate);
  const Variables olds = only_in(old_all, now), news = only_in(now, old_all);
  if (olds.empty() || news.empty()) return pairs;
  const auto gold = traces(q, q.gold, false, olds, olds);
  const auto gate = traces(q, q.gate, true, news, news);
  std::multimap<std::string, std::string> by_trace;
  for (const auto& [name, trace] : gate) by_trace.emplace(trace, name);
  for (const auto& [name, trace] : gold) {
    const auto at = by_trace.find(trace);
    if (at == by_trace.end()) continue;
    rename(q, olds, news, name, at->second);
    pairs.emplace(name, at->second);
    by_trace.erase(at);
  }
  return pairs;
}

}  // namespace cosim::equiv
