#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "model/core/input_error.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/rtl/regex.h"
#include "tb/rtl/verilog.h"

namespace cosim::rtl {
namespace {

struct Port {
  std::string name, way, range;
};

std::string range_of_bits(std::size_t bits) { return "[" + std::to_string(bits - 1) + ":0]"; }

std::map<std::string, Port> ports_of(const Module& module) {
  static const Regex declaration("\\b((input|output|inout)\\b[^;]*);");
  static const Regex direction("^(input|output|inout)\\b");
  static const Regex net(
      "^(\\s*(wire|reg|logic|tri[01]?|signed)\\b)*((\\s*\\[[^]]*\\])*)\\s*(\\w+)");
  const Head head = head_of(module);
  std::vector<Piece> declared;
  if (head.is_ansi) declared = head.items;
  for (const Match& m : head.is_ansi ? std::vector<Match>{} : declaration.all(head.flat)) {
    const std::vector<Piece> more = parts(m[1]);
    declared.insert(declared.end(), more.begin(), more.end());
  }
  std::map<std::string, Port> ports;
  std::string way, range;
  for (Piece& one : declared) {
    if (const Match m = direction.find(one.text)) {
      way = m[1];
      range = "";
      one.text.erase(0, m.end());
    }
    const Match m = net.find(one.text);
    if (m && m.size(3) != 0) range = m[3];
    if (m && !way.empty()) ports[m[5]] = {m[5], way, range};
  }
  return ports;
}

// Whether a place is in a loop of `generate`, which makes many of what is there.
bool is_in_loop(std::string_view flat, std::size_t at) {
  static const Regex word("\\b((for)\\s*\\(|begin\\b|end\\b)"), begins("^\\s*begin\\b");
  std::vector<bool> open;  // blocks, and whether they are of a loop
  std::size_t from = 0;
  for (Match m = word.find(flat); m && m.begin() < at; m = word.find(flat, from)) {
    from = m.end();
    if (m[1] == "end") {
      if (!open.empty()) open.pop_back();
      continue;
    }
    open.push_back(m.has(2));
    if (!m.has(2)) continue;
    const std::size_t body = std::min(group_end(flat, from - 1), at);
    const Match begin = begins.find(flat.substr(body, at - body));
    from = body + (begin ? begin.end() : 0);
  }
  return std::find(open.begin(), open.end(), true) != open.end();
}

// The instances of a module that can be taken out or get more pins.
std::vector<Instance> single_instances(const std::string& of, const std::string& flat) {
  std::vector<Instance> all = instances(of, flat);
  for (const Instance& one : all) {
    const std::string what = of + ' ' + one.name + ": ";
    if (one.is_array) throw InputError(what + "instances of it as an array");
    if (is_in_loop(flat, one.begin)) throw InputError(what + "instances of it in a loop");
    if (!one.pins.empty() && one.pins.front().text.front() != '.') {
      throw InputError(what + "its pins are connected by position");
    }
  }
  return all;
}

// A constant as an output. Different kinds of constants make different ports: a string is no
// number, and real numbers and numbers with x are taken as strings.
Port constant_of(const std::string& name, const std::string& given) {
  static const Regex is_text("^\"[^\"]*\"$"), is_plain("^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$");
  static const Regex is_real("[0-9]\\.[0-9]|(^|[^A-Za-z0-9_'.])[0-9][0-9_]*[eE][-+]?[0-9]");
  static const Regex has_x("^[0-9]*\\s*'s?[bodh][0-9a-f_]*[xz?]", REG_ICASE);
  static const Regex has_name("^([^\"]*[^\"A-Za-z0-9_'])?[A-Za-z_`]"), size("([0-9]+)\\s*'");
  std::string e = trimmed(given), kind;
  std::size_t bits = 256;
  if (is_text.find(e)) {
    kind = "$text";
  } else if (e.find('"') == std::string::npos && is_real.find(e)) {
    std::string plain = e;
    plain.erase(std::remove(plain.begin(), plain.end(), '_'), plain.end());
    if (is_plain.find(plain)) {
      char digits[40];
      std::snprintf(digits, sizeof digits, "%.17g", std::strtod(plain.c_str(), nullptr));
      e = digits;
    }
    kind = "$real";
    e = '"' + e + '"';
  } else if (has_x.find(e)) {
    kind = "$bits";
    for (char& c : e) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    e = '"' + e + '"';
  } else if (has_name.find(e)) {
    // A name may stand for a real number, which would be rounded, and for an integer or a string,
    // of which an odd multiple says as much.
    bits = 2048;
    e = "(" + e + ") * 1000003";
  }
  if (!kind.empty()) bits = std::max(bits, 8 * e.size());
  for (const Match& m : kind.empty() ? size.all(e) : std::vector<Match>{}) {
    bits = std::max<std::size_t>(bits, std::strtoul(m[1].c_str(), nullptr, 10));
  }
  return {name + kind, e, range_of_bits(bits)};
}

class Opened {
 public:
  Opened(const Sources& sources, const std::filesystem::path& to)
      : sources_(sources), verilog_(sources.folder, sources.files) {
    for (const std::string& name : sources.blackboxes) boxes_[name] = false;
    const auto top = verilog_.modules.find(sources.top);
    if (top == verilog_.modules.end()) {
      throw InputError("no file has the module " + sources.top);
    }
    open(top->second);
    for (const auto& [name, is_met] : boxes_) {
      if (!is_met)
        throw InputError(name + ": a blackbox that " + sources.top + " has no instance of");
    }
    files = verilog_.write(to);
  }
  std::vector<std::string> files;

 private:
  using Ports = std::map<std::string, Port>;

  // The modules that a text may have instances of.
  std::vector<const Module*> below(const std::string& flat) const {
    std::vector<const Module*> all;
    for (const auto& [name, module] : verilog_.modules) {
      if (!boxes_.contains(name) && has_word(flat, name)) all.push_back(&module);
    }
    return all;
  }
  // Whether anything but a blackbox drives a net.
  bool is_driven(const std::string& flat, const Ports& ports, const std::string& net) const {
    const auto port = ports.find(net);
    if (port != ports.end() && port->second.way != "output") return true;
    const std::string bits = net + bits_of_net;
    if (Regex("\\b(reg|integer)\\b[^;]*\\b" + net + "\\b").find(flat) ||
        Regex("\\b(assign|wire|logic)\\b[^;=]*\\b" + bits + "\\s*(,[^;=]*\\}\\s*)?=([^=]|$)")
            .find(flat) ||
        Regex("([;):]|\\bbegin|\\belse)\\s*" + bits + "\\s*<?=([^=]|$)").find(flat)) {
      return true;
    }
    for (const Module* module : below(flat)) {
      const Ports of = ports_of(*module);
      for (const Instance& instance : instances(module->name, flat)) {
        for (const Joined& pin : joined(instance.pins)) {
          const auto way = of.find(pin.pin);
          if ((way == of.end() || way->second.way != "input") && has_word(pin.net, net))
            return true;
        }
      }
    }
    return false;
  }
  // The range of what a pin is joined to. With constants as ports a net of unknown width is taken
  // as wide: nothing of it is cut.
  std::string range_of(const std::string& flat, const Ports& ports, const std::string& e,
                       const std::string& where) const {
    static const Regex is_net("^[~[:space:]]*(\\w+)" + bits_of_net + "$"), last("\\[([^]]*)\\]$");
    static const Regex record("\\b(struct|union)\\b[^{;]*\\{[^{}]*\\}");
    static const std::string vector =
        "(wire|reg|logic|bit|tri(0|1|and|or|reg)?|wand|wor|uwire|var|signed|unsigned)\\b";
    static const std::map<std::string, std::size_t> bits{
        {"integer", 32}, {"int", 32}, {"byte", 8}, {"shortint", 16}, {"longint", 64}, {"time", 64}};
    const Match net = is_net.find(e);
    if (!net) {
      throw InputError(where + " is connected to '" + e +
                       "', whose width is unknown; connect a net or its inverse");
    }
    const std::string name = net[1], part = net[2];
    if (const Match m = last.find(part)) {
      const std::string range = m[1];
      const std::size_t colon = range.rfind(':');
      return colon == std::string::npos
                 ? ""
                 : "[(" + range.substr(0, colon) + ") - (" + range.substr(colon + 1) + "):0]";
    }
    if (const auto port = ports.find(name); port != ports.end()) return port->second.range;
    const std::string plain = record.replaced(flat, [](const Match&) { return ""; });
    std::set<std::string> ranges;
    const Regex wide("\\b" + vector + "(\\s*" + vector + ")*" + bits_of_net +
                     "[[:space:]A-Za-z0-9_,]*\\b" + name + "\\b");
    for (const Match& m : wide.all(plain)) ranges.insert(m[6]);
    const Regex number(
        "\\b(integer|int|byte|shortint|longint|time)\\b(\\s*(un)?signed\\b)?[[:space:]A-Za-z0-9_,]*"
        "\\b" +
        name + "\\b");
    for (const Match& m : number.all(plain)) ranges.insert(range_of_bits(bits.at(m[1])));
    if (ranges.size() == 1) return *ranges.begin();
    if (sources_.has_constants) return range_of_bits(1024);
    if (ranges.empty()) return "";
    throw InputError(where + " is connected to " + name + ", which has several widths");
  }
  // The parameters and the attributes of an instance as constants; `begin` moves in front of the
  // attributes, which go with it.
  void constants_of(const Module& module, const Instance& instance, std::size_t& begin,
                    std::vector<Port>& constants) const {
    static const Regex named("^\\.\\s*(\\w+)\\s*\\((.*)\\)$");
    static const Regex attribute(
        "[(*,]\\s*([A-Za-z_]\\w*)\\s*(=\\s*(\"[^\"]*\"|[^,*\"]+))?\\s*(,|\\*\\))");
    while (begin > 0 && std::isspace(static_cast<unsigned char>(module.body[begin - 1])) != 0)
      --begin;
    std::string before = verilog_.original(module, begin, instance.begin - begin);
    // A directive stays.
    static const Regex directive("^(.*\n)?[ \t]*`[^\n]*\n");
    if (const Match m = directive.find(before)) {
      begin += m.end();
      before.erase(0, m.end());
    }
    int count = 0;
    const std::string values =
        verilog_.original(module, instance.values.at, instance.values.text.size());
    for (const Piece& one : parts(without_comments(instance.has_values ? values : ""))) {
      const Match m = named.find(one.text);
      constants.push_back(m ? constant_of("parameter$" + m[1], m[2])
                            : constant_of("parameter$" + std::to_string(count++), one.text));
    }
    before = without_comments(before);
    for (Match m = attribute.find(before); m; m = attribute.find(before, m.begin(4))) {
      constants.push_back(constant_of("attribute$" + m[1], m.has(2) ? m[3] : "1"));
    }
  }
  // Takes an instance of a blackbox out of a module; adds to the new ports.
  void take_out(const Module& module, const Head& head, const Ports& ports, const std::string& of,
                const Instance& instance, std::vector<Port>& added) {
    static const Regex is_constant("^([0-9]+$|([0-9]*)\\s*')"),
        is_net("^(\\w+)" + bits_of_net + "$");
    const std::string what = of + ' ' + instance.name;
    const std::vector<Joined> pins = joined(instance.pins);
    if (pins.size() != instance.pins.size())
      throw InputError(what + ": its pins are not all .PIN(NET)");
    boxes_[of] = true;
    const auto declared = verilog_.modules.find(of);
    const Ports known = declared == verilog_.modules.end() ? Ports{} : ports_of(declared->second);
    std::string text;
    std::vector<Port> constants;
    for (const Joined& pin : pins) {
      const Match constant = is_constant.find(pin.net);
      if (pin.net.empty() || constant) {
        if (constant)
          constants.push_back(
              {pin.pin, pin.net,
               constant[2].empty() ? "[31:0]" : range_of_bits(std::stoul(constant[2]))});
        continue;
      }
      const std::string port = instance.name + '$' + pin.pin;
      const Match net = is_net.find(pin.net);
      bool is_out = false;
      if (declared != verilog_.modules.end()) {
        const auto way = known.find(pin.pin);
        is_out = way != known.end() && way->second.way == "output";
      } else if (net && !is_driven(head.flat, ports, net[1])) {
        is_out = true;
        if (sources_.has_constants) {  // the first pin on a net drives it
          std::string first = pin.pin;
          for (const Joined& other : pins) {
            if (other.net == pin.net) first = std::min(first, other.pin);
          }
          is_out = drivers_[module.name]
                       .try_emplace(pin.net, instance.name + '$' + first)
                       .first->second == port;
        }
      }
      added.push_back({port, is_out ? "input" : "output",
                       range_of(head.flat, ports, pin.net, what + ": its pin " + pin.pin)});
      text += "assign " + (is_out ? pin.net + " = " + port : port + " = " + pin.net) + "; ";
    }
    std::size_t begin = instance.begin;
    constants_of(module, instance, begin, constants);
    for (const Port& constant : sources_.has_constants ? constants : std::vector<Port>{}) {
      const std::string port = instance.name + '$' + constant.name;
      added.push_back({port, "output", constant.range});
      text += "assign " + port + " = " + constant.way + "; ";
    }
    verilog_.edit(module, begin, instance.end - begin, text);
  }
  // Takes the blackboxes out of a module and of those below it; its new ports.
  const std::vector<Port>& open(const Module& module) {
    const auto [place, is_new] = opened_.try_emplace(module.name);
    if (!is_new) return place->second;
    static const Regex name("[A-Za-z_`]");
    const Head head = head_of(module);
    const Ports ports = ports_of(module);
    std::vector<Port> added;
    for (const auto& [of, is_met] : boxes_) {
      for (const Instance& one : single_instances(of, head.flat))
        take_out(module, head, ports, of, one, added);
    }
    for (const Module* inner : below(head.flat)) {
      if (inner == &module) continue;
      const std::vector<Port> more = open(*inner);
      if (more.empty()) continue;
      for (const Instance& one : single_instances(inner->name, head.flat)) {
        std::string pins;
        for (const Port& port : more) {
          if (name.find(port.range)) {
            throw InputError(inner->name + ' ' + one.name + ": the width of " + port.name +
                             " depends on its parameters");
          }
          const std::string outer = one.name + '$' + port.name;
          added.push_back({outer, port.way, port.range});
          pins += (pins.empty() && one.pins.empty() ? "." : ", .") + port.name + '(' + outer + ')';
        }
        verilog_.edit(module, one.last, 0, pins);
      }
    }
    if (!added.empty() && head.items.empty()) throw InputError(module.name + ": has no port");
    std::string in_list, in_body;
    for (const Port& port : added) {
      const std::string declared = port.way + " wire" + port.range + ' ' + port.name;
      in_list += ", " + (head.is_ansi ? declared : port.name);
      in_body += ' ' + declared + ';';
    }
    if (!added.empty()) verilog_.edit(module, head.list_end, 0, in_list);
    if (!added.empty() && !head.is_ansi) verilog_.edit(module, head.end, 0, in_body);
    return opened_[module.name] = added;
  }

  const Sources& sources_;
  Verilog verilog_;
  std::map<std::string, bool> boxes_;  // and whether there is an instance
  std::map<std::string, std::vector<Port>> opened_;
  std::map<std::string, std::map<std::string, std::string>> drivers_;  // by the module and the net
};

}  // namespace

std::vector<std::string> without_blackboxes(const Sources& sources,
                                            const std::filesystem::path& to) {
  return Opened(sources, to).files;
}

}  // namespace cosim::rtl
