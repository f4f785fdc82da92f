#include "tb/new/new_members.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "tb/new/new.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

// A number of RTL, from its hexadecimal digits.
std::string bits_of(const std::string& hex, int high, int low) {
  std::string digits;
  for (int at = low; at <= high; at += 4) {
    int digit = 0;
    for (int bit = at; bit < at + 4 && bit <= high; ++bit) {
      const auto from_end = static_cast<std::size_t>(bit / 4);
      if (from_end >= hex.size()) break;
      const int all = std::stoi(hex.substr(hex.size() - 1 - from_end, 1), nullptr, 16);
      digit |= (all >> bit % 4 & 1) << (bit - at);
    }
    digits.insert(0, fmt::format("{:x}", digit));
  }
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return digits;
}
std::string number(const std::string& hex) {
  const bool is_digit = hex.size() == 1 && hex < "a";
  return is_digit ? hex : "0x" + hex;
}

// Names of members, each another one.
class Names {
 public:
  explicit Names(const std::string& taken) : taken_(taken) {}
  std::string of(const std::string& path) {
    std::string name = taken_.other_than(path);
    taken_.insert(name);
    return name;
  }
  // The name of a member of a struct.
  std::string inner(const std::string& name) const { return taken_.other_than(name); }

 private:
  TakenNames taken_;
};

std::string range_of(int high, int low) {
  return high == low ? fmt::format("[{}]", low) : fmt::format("[{}:{}]", high, low);
}

bool is_struct(const FoundNet& net) {
  return net.words.number == 0 && net.parts.size() > 1 && net.width.text.empty();
}

// The members of a struct, or the net itself, as far as they hold a state.
std::vector<rtl::Part> held_parts(const FoundNet& net) {
  const rtl::Part all{"", net.width.number - 1, 0, net.is_signed};
  if (net.words.number != 0) return {all};
  std::vector<rtl::Part> parts{all}, held;
  if (is_struct(net) || net.parts.size() == 1) parts = net.parts;
  auto ranges = net.bits;
  if (ranges.empty()) ranges = {{all.high, 0}};
  for (const rtl::Part& part : parts) {
    for (const auto& [above, below] : ranges) {
      const int high = std::min(above, part.high), low = std::max(below, part.low);
      if (high < low) continue;
      const bool is_whole = high == part.high && low == part.low;
      held.push_back(
          is_whole ? part
                   : rtl::Part{part.name + range_of(high - part.low, low - part.low), high, low});
    }
  }
  return held;
}

Member member_of(const FoundNet& net, const rtl::Part& part, const std::string& name,
                 const EnumTypes* enums) {
  Member m{name, "", net, part.high, part.low, part.is_signed};
  const int width = part.high - part.low + 1;
  const bool is_whole = width == net.width.number;
  const std::string at = net.name + (is_whole ? "" : range_of(part.high, part.low));
  const std::string named = enums == nullptr ? "" : enums->of(part.type);
  FoundNet one = net;
  one.is_signed = part.is_signed;
  if (!is_whole) one.width = {width};
  m.type = named.empty() ? type_of(one) : fmt::format("Enum<{}, {}>", named, width);
  if (m.name != at) m.type = fmt::format("At<\"{}\", {}>", at, m.type);
  if (!net.is_reset) {
    m.type = fmt::format("Unreset<{}>", m.type);
    return m;
  }
  m.value = value_of(net.value.empty() ? "0" : net.value, m);
  if (!named.empty()) m.value = enums->value(part.type, m.value);
  return m;
}

// Those of one net. `name_of` makes a path in the RTL a name in the model.
template <class NameOf>
void add_members(std::vector<Member>& members, const FoundNet& net, const std::string& path,
                 const Names& names, const EnumTypes* enums, const NameOf& name_of) {
  const std::string top = is_struct(net) ? name_of(path) : "";
  for (const rtl::Part& part : held_parts(net)) {
    std::string name = top;
    if (is_struct(net)) {
      for (const std::string& word : parts_in(part.name, '.')) name += '.' + names.inner(word);
    } else {
      name = name_of(path + part.name);
    }
    members.push_back(member_of(net, part, name, enums));
  }
}

std::vector<Member> port_members(const std::vector<FoundNet>& nets, const std::string& taken,
                                 const EnumTypes* enums) {
  Names names(taken);
  std::vector<Member> members;
  for (const FoundNet& net : nets) {
    add_members(members, net, net.name, names, enums,
                [&](const std::string& path) { return names.of(path); });
  }
  for (Member& m : members) m.value.clear();
  return members;
}

// Calls leaf(member, its own name), or group(name, members), of each member of the struct that is
// `depth` names below the model.
template <class Leaf, class Group>
void walk(std::span<const Member> members, std::size_t depth, const Leaf& leaf,
          const Group& group) {
  while (!members.empty()) {
    const auto words = parts_in(members.front().name, '.');
    std::size_t n = 1;
    if (words.size() == depth + 1) {
      leaf(members.front(), words[depth]);
    } else {
      const auto is_in = [&](const Member& m) {
        return parts_in(m.name, '.')[depth] == words[depth];
      };
      while (n < members.size() && is_in(members[n])) ++n;
      group(words[depth], members.first(n));
    }
    members = members.subspan(n);
  }
}

std::string declared_in(std::span<const Member> members, std::size_t depth,
                        const std::string& indent) {
  std::string text;
  walk(
      members, depth,
      [&](const Member& m, const std::string& name) {
        const std::string value = m.value.empty() ? "" : " = " + m.value;
        text += fmt::format("{}{} {}{};\n", indent, m.type, name, value);
      },
      [&](const std::string& name, std::span<const Member> of) {
        text += fmt::format("{0}struct {{\n{1}{0}}} {2};\n", indent,
                            declared_in(of, depth + 1, indent + "  "), name);
      });
  return text;
}

std::vector<std::string> zeros_in(std::span<const Member> members, std::size_t depth) {
  std::vector<std::string> all;
  walk(
      members, depth,
      [&](const Member&, const std::string& name) { all.push_back(fmt::format(".{} = 0", name)); },
      [&](const std::string& name, std::span<const Member> of) {
        all.push_back(fmt::format(".{} = {{{}}}", name, fmt::join(zeros_in(of, depth + 1), ", ")));
      });
  return all;
}

}  // namespace

EnumTypes::EnumTypes(const std::string& title,
                     const std::map<std::string, std::vector<std::string>>& enums) {
  const TakenNames taken("");
  for (const auto& [name, values] : enums) {
    Type& type = types_[name];
    type.name = title + in_one_word(name);
    for (const std::string& value : values) type.values.push_back(taken.other_than(value));
  }
}

std::string EnumTypes::of(const std::string& type) const {
  const auto known = types_.find(type);
  return known == types_.end() ? "" : known->second.name;
}

std::string EnumTypes::value(const std::string& type, const std::string& number) const {
  const Type& known = types_.at(type);
  const std::size_t i = std::stoul(number, nullptr, 0);
  return i < known.values.size() ? known.name + "::" + known.values[i] : number;
}

std::string EnumTypes::text() const {
  std::string text;
  for (const auto& [name, type] : types_) {
    text += fmt::format("enum class {} {{ {} }};\n", type.name, fmt::join(type.values, ", "));
  }
  return text;
}

std::vector<Member> input_members(const std::vector<FoundNet>& nets, const std::string& taken) {
  return port_members(nets, taken, nullptr);
}

std::vector<Member> output_members(const std::vector<FoundNet>& nets, const std::string& taken,
                                   const EnumTypes& enums) {
  return port_members(nets, taken, &enums);
}

std::vector<Member> register_members(const std::vector<FoundNet>& nets, const std::string& taken,
                                     const EnumTypes& enums) {
  const auto last = [](const std::string& path) { return path.substr(path.rfind('.') + 1); };
  std::map<std::string, int> alike;
  for (const FoundNet& net : nets) ++alike[last(net.name)];
  const bool by_instance = nets.size() > most_members;
  Names names(taken);
  const auto name_of = [&](const std::string& path) {
    if (!by_instance) return names.of(path);
    std::string name;
    for (const std::string& word : parts_in(path, '.')) name += '.' + names.inner(word);
    return name.substr(1);
  };
  std::vector<Member> members;
  for (const FoundNet& net : nets) {
    const bool is_short = !by_instance && alike[last(net.name)] == 1;
    add_members(members, net, is_short ? last(net.name) : net.name, names, &enums, name_of);
  }
  return members;
}

std::string declared(const std::vector<Member>& members, const std::string& indent) {
  return declared_in(members, 0, indent);
}

std::vector<std::string> zeros_of(const std::vector<Member>& members) {
  return zeros_in(members, 0);
}

std::string value_of(const std::string& hex, const Member& member) {
  if (member.net.words.number != 0) return "0";
  const int width = member.high - member.low + 1;
  const std::string is = bits_of(hex, member.high, member.low);
  const std::string ones = bits_of(std::string(static_cast<std::size_t>(width), 'f'), width - 1, 0);
  if (is == ones && !member.net.width.text.empty()) return "-1";  // whatever the parameters
  if (member.is_signed && width <= 64 && bits_of(is, width - 1, width - 1) == "1") {
    const std::uint64_t above = width == 64 ? 0 : ~std::uint64_t{0} << width;
    return std::to_string(static_cast<std::int64_t>(std::stoull(is, nullptr, 16) | above));
  }
  if (width <= 64) return number(is);
  std::string parts;
  if (is.size() == 1 && is < "a") return is;
  for (int high = width - 1; high >= 0;) {
    const int low = high / 64 * 64;
    parts += fmt::format("{}UInt<{}>({})", parts.empty() ? "" : ", ", high - low + 1,
                         number(bits_of(is, high, low)));
    high = low - 1;
  }
  return "cat(" + parts + ')';
}

}  // namespace cosim::cli
