#include <algorithm>
#include <set>

#include "model/core/input_error.h"
#include "tb/rtl/files.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/rtl/regex.h"
#include "tb/rtl/verilog.h"

namespace cosim::rtl {
namespace {

// What drives bits of a net, in place of a piece of text.
struct Driver {
  std::string part;
  std::size_t at, length;
  std::function<std::string(const std::string& out, const std::string& en)> by;
};

// A delay, which is left out: two groups of a Regex and what is in them.
const std::string delay = "(#\\s*([0-9]+|\\(([^()]|\\([^()]*\\))*\\))\\s*)?";

struct Inout {
  std::string range;
  Piece item;                      // of the list of ports
  std::size_t at = 0, length = 0;  // of its declaration behind the list
  std::vector<Driver> drivers = {};
};

// What an expression drives: which bits, and their values.
struct Driven {
  std::string which, value;
};

std::string unwrapped(std::string_view e) {
  std::string inner = trimmed(e);
  while (!inner.empty() && inner.front() == '(' && group_end(inner, 0) == inner.size()) {
    inner = trimmed(inside(inner));
  }
  return inner;
}

// C, A and B of C ? A : B; nothing of another expression.
std::vector<std::string> choice(const std::string& e) {
  int depth = 0, marks = 0;
  std::size_t mark = 0;
  for (std::size_t i = 0; i < e.size(); ++i) {
    const std::string_view c(&e[i], 1);
    if (c.find_first_of("([{") == 0) ++depth;
    if (c.find_first_of(")]}") == 0) --depth;
    if (depth != 0) continue;
    if (c == "?" && marks++ == 0) mark = i;
    if (c == ":" && marks > 0 && --marks == 0) {
      return {e.substr(0, mark), e.substr(mark + 1, i - mark - 1), e.substr(i + 1)};
    }
  }
  return {};
}

class Split {
 public:
  Split(const Sources& sources, const std::filesystem::path& to)
      : verilog_(sources.folder, sources.files) {
    const auto top = verilog_.modules.find(sources.top);
    if (top != verilog_.modules.end() && verilog_.has("inout")) split(top->second);
    files = verilog_.write(to);
  }
  std::vector<std::string> files;

 private:
  using Ports = std::map<std::string, Inout>;

  [[noreturn]] static void refuse(const Module& module, const std::string& port,
                                  const std::string& why) {
    throw InputError(module.name + ": " + port + ": an inout port that " + why);
  }

  static Driven driven(const Module& module, const std::string& expression,
                       const std::string& target) {
    static const Regex is_z(
        "^[[:space:]({]*([[:space:]A-Za-z0-9_$+*/"
        "()-]*\\{)?\\s*[0-9]*\\s*'\\s*([sS]?[bohdBOHD]\\s*)?[zZ?][zZ?_]*[[:space:])}]*$");
    static const Regex has_z("'\\s*\\w?[zZ]"), is_net("^\\w+$");
    const std::string e = unwrapped(expression);
    if (is_z.find(e)) return {"1'b0", "1'b0"};
    if (const std::vector<std::string> c = choice(e); !c.empty()) {
      const Driven then = driven(module, c[1], target), other = driven(module, c[2], target);
      return {"((" + c[0] + ") ? " + then.which + " : " + other.which + ")",
              "((" + c[0] + ") ? " + then.value + " : " + other.value + ")"};
    }
    const bool is_name = static_cast<bool>(is_net.find(e));
    if (is_name) {
      const Match named =
          Regex("\\b(assign|wire\\b[^;=]*)\\s*\\b" + e + "\\s*=([^;]*);").find(module.body);
      if (named && has_z.find(named[2])) return driven(module, named[2], target);
    }
    if (has_z.find(e) ||
        (is_name &&
         Regex("\\b" + e + bits_of_net + "\\s*<?=[^;=]*'\\s*[bohdBOHD]?[zZ]").find(module.body))) {
      refuse(module, target, "is driven by '" + e + "', which may be z");
    }
    return {"~1'b0", "(" + e + ")"};
  }

  static Ports inouts(const Module& module, const Head& head) {
    static const Regex direction("^(input|output|inout)\\b");
    static const Regex net(
        "^(\\s*(wire|logic|tri[01]?|signed)\\b)*((\\s*\\[[^]]*\\])*)\\s*(\\w+\\s*(\\[.*)?)$");
    static const Regex name("^\\s*(\\w+)$");
    static const Regex declaration(
        "\\binout\\b(\\s*(wire|tri[01]?|signed)\\b)*((\\s*\\[[^]]*\\])*)([^;]*);");
    Ports ports;
    std::string way, range;
    for (const Piece& item : head.is_ansi ? head.items : std::vector<Piece>{}) {
      std::string text = item.text;
      if (const Match m = direction.find(text)) {
        way = m[1];
        range = "";
        text.erase(0, m.end());
      }
      if (way != "inout") continue;
      if (const Match m = net.find(text)) {
        if (m.size(3) != 0) range = m[3];
        text.erase(0, m.begin(5));
      }
      const Match m = name.find(text);
      if (!m) refuse(module, text, "is an array");
      ports[m[1]] = {range, item};
    }
    for (const Match& m : head.is_ansi ? std::vector<Match>{} : declaration.all(head.flat)) {
      for (const Piece& one : parts(m[5])) {
        const auto item = std::find_if(head.items.begin(), head.items.end(),
                                       [&](const Piece& p) { return p.text == one.text; });
        if (item == head.items.end()) refuse(module, one.text, "is not in the list of ports");
        ports[one.text] = {m[3], *item, m.begin(), m.size()};
      }
    }
    return ports;
  }

  void read_assignments(const Module& module, const Head& head, Ports& ports) {
    static const Regex assignment("\\bassign\\b\\s*(\\([^()]*\\)\\s*)?" + delay + "([^;]*);");
    static const Regex is_net("^(\\w+)" + bits_of_net + "$"), word("\\w+");
    for (const Match& m : assignment.all(head.flat)) {
      std::string kept;
      bool is_driver = false;
      for (const Piece& one : parts(m[5], m.begin(5))) {
        std::size_t equals = one.text.find('=');
        while (equals != std::string::npos && one.text[equals + 1] == '=') ++equals;
        if (equals == std::string::npos) continue;
        const std::string target = trimmed(one.text.substr(0, equals));
        const Match net = is_net.find(target);
        const auto port = ports.find(net ? net[1] : "");
        if (port == ports.end()) {
          for (const Match& in : target.front() == '{' ? word.all(target) : std::vector<Match>{}) {
            if (ports.contains(in[0])) refuse(module, in[0], "is driven in a part of { }");
          }
          kept += (kept.empty() ? "assign " : ", ") +
                  verilog_.original(module, one.at, one.text.size());
          continue;
        }
        const std::string part = net[2];
        const Driven by = driven(module, one.text.substr(equals + 1), net[1]);
        port->second.drivers.push_back({part, m.begin(), 0, [=](const auto& out, const auto& en) {
                                          return "assign " + en + part + " = " + by.which +
                                                 "; assign " + out + part + " = " + by.value + "; ";
                                        }});
        is_driver = true;
      }
      if (is_driver) verilog_.edit(module, m.begin(), m.size(), kept.empty() ? "" : kept + ';');
    }
  }

  void read_gates(const Module& module, const Head& head, Ports& ports) {
    static const Regex gate("\\b(buf|not)if([01])\\b\\s*" + delay + "\\w*\\s*\\("), ends("^\\s*;");
    static const Regex is_net("^(\\w+)" + bits_of_net + "$");
    for (const Match& m : gate.all(head.flat)) {
      const std::size_t end = group_end(head.flat, m.end() - 1);
      if (end == std::string::npos) continue;
      const Match behind = ends.find(std::string_view(head.flat).substr(end));
      const std::vector<Piece> pins = parts(head.flat.substr(m.end(), end - 1 - m.end()));
      const Match net = is_net.find(pins.empty() ? "" : pins[0].text);
      const auto port = ports.find(net ? net[1] : "");
      if (!behind || port == ports.end() || pins.size() < 3) continue;
      const std::string value = (m[1] == "not" ? "~(" : "(") + pins[1].text + ")", part = net[2];
      const std::string is_on = (m[2] == "1" ? "(" : "!(") + pins[2].text + ")";
      port->second.drivers.push_back({part, m.begin(), 0, [=](const auto& out, const auto& en) {
                                        return "assign " + en + part + " = " + is_on +
                                               " ? ~1'b0 : 1'b0; assign " + out + part + " = " +
                                               is_on + " ? " + value + " : 1'b0; ";
                                      }});
      verilog_.edit(module, m.begin(), end + behind.end() - m.begin(), "");
    }
  }

  void read_instance(const Module& module, const Instance& instance, const Ports& inner,
                     Ports& ports) {
    static const Regex named("^\\.\\s*(\\w+)\\s*\\((.*)\\)$"),
        is_net("^(\\w+)" + bits_of_net + "$");
    const std::string what = module.name + '.' + instance.name;
    for (const auto& [name, of] : inner) {
      if (of.drivers.empty()) continue;
      if (instance.is_array)
        throw InputError(what + ": instances with an inout port, " + name + ", as an array");
      if (!instance.pins.empty() && instance.pins.front().text.front() != '.') {
        throw InputError(what + ": its pins are connected by position, and " + name +
                         " is an inout port");
      }
      for (const Piece& pin : instance.pins) {
        const Match m = named.find(pin.text);
        if (!m || m[1] != name) continue;
        const std::string e = trimmed(m[2]), in = '.' + name + "$in(",
                          out = "), ." + name + "$out(", en = "), ." + name + "$en(";
        if (e.empty()) {
          verilog_.edit(module, pin.at, pin.text.size(), in + "1'b0" + out + en + ')');
          break;
        }
        const Match net = is_net.find(e);
        const auto port = ports.find(net ? net[1] : "");
        if (port == ports.end()) {
          throw InputError(what + ": its inout port " + name + " is connected to '" + e +
                           "', no inout port of " + module.name);
        }
        const std::string part = net[2];
        port->second.drivers.push_back(
            {part, pin.at, pin.text.size(), [=](const auto& o, const auto& drives) {
               return in + e + out + o + part + en + drives + part + ')';
             }});
        break;
      }
    }
  }

  // Has the drivers of a port write its nets. The text that declares and joins these.
  std::string written(const Module& module, const std::string& net, const Inout& port) {
    std::set<std::string> driven_parts;
    for (const Driver& driver : port.drivers) driven_parts.insert(driver.part);
    // Several drivers have a wire each; if they drive parts, each drives its own one.
    const bool is_parted = !driven_parts.contains("");
    const std::size_t count = port.drivers.size();
    if (count > 1 && (is_parted ? driven_parts.size() < count : driven_parts.size() > 1)) {
      refuse(module, net, "is driven more than once, in part");
    }
    std::string text, all_out, all_en;
    for (std::size_t i = 0; i < count; ++i) {
      std::string out = net + "$out", en = net + "$en";
      if (count > 1 && !is_parted) {
        out += std::to_string(i);
        en += std::to_string(i);
        text += "wire" + port.range + ' ' + out + ", " + en + "; ";
        all_out += (i == 0 ? "(" : " | (") + out + " & " + en + ")";
        all_en += (i == 0 ? "" : " | ") + en;
      }
      const Driver& driver = port.drivers[i];
      verilog_.edit(module, driver.at, driver.length, driver.by(out, en));
    }
    if (all_en.empty()) return text;
    return text + "assign " + net + "$out = " + all_out + "; assign " + net + "$en = " + all_en +
           "; ";
  }

  // Splits the ports of a module, and those of the modules that it has instances of first.
  void split(const Module& module) {
    const auto [place, is_new] = ports_.try_emplace(module.name);
    if (!is_new) return;
    const Head head = head_of(module);
    Ports ports = inouts(module, head);
    read_assignments(module, head, ports);
    read_gates(module, head, ports);
    for (const auto& [name, inner] : verilog_.modules) {
      if (name == module.name || !has_word(head.flat, name)) continue;
      split(inner);
      for (const Instance& one : instances(name, head.flat))
        read_instance(module, one, ports_[name], ports);
    }
    std::string in_body;
    std::map<std::size_t, std::pair<std::size_t, std::string>> declared;  // length and text
    for (const auto& [net, port] : ports) {
      const std::string &range = port.range, in = net + "$in", out = net + "$out", en = net + "$en";
      const auto write = [&, &net = net, &port = port](const std::string& in_list,
                                                       const std::string& declaration) {
        if (head.is_ansi || in_list != net)
          verilog_.edit(module, port.item.at, port.item.text.size(), in_list);
        if (head.is_ansi) return;
        auto& [length, text] = declared[port.at];
        length = port.length;
        text += declaration;
      };
      if (port.drivers.empty()) {
        write(head.is_ansi ? "input wire" + range + ' ' + net : net,
              "input" + range + ' ' + net + ';');
        continue;
      }
      std::string text = written(module, net, port);
      const bool has_net =
          !head.is_ansi &&
          Regex("\\b(wire|tri[01]?)\\b[^;=]*\\b" + net + "\\b\\s*[,;]").find(head.flat);
      const std::string joins =
          "assign " + net + " = (" + en + " & " + out + ") | (~" + en + " & " + in + ");";
      if (has_net) {
        verilog_.edit(module, module.body.size(), 0, ' ' + joins + ' ');
      } else {
        text = "wire" + range + ' ' + net + "; " + text + joins;
      }
      if (head.is_ansi) {
        write("input wire" + range + ' ' + in + ", output wire" + range + ' ' + out +
                  ", output wire" + range + ' ' + en,
              "");
        in_body += ' ' + text;
      } else {
        write(in + ", " + out + ", " + en, "input" + range + ' ' + in + "; output" + range + ' ' +
                                               out + ", " + en + "; " + text);
      }
    }
    if (!in_body.empty()) verilog_.edit(module, head.end, 0, in_body);
    for (const auto& [at, by] : declared) verilog_.edit(module, at, by.first, by.second);
    place->second = std::move(ports);
  }

  Verilog verilog_;
  std::map<std::string, Ports> ports_;  // of the modules that are split
};

}  // namespace

std::vector<std::string> with_split_inouts(const Sources& sources,
                                           const std::filesystem::path& to) {
  const bool has_any =
      std::any_of(sources.files.begin(), sources.files.end(), [&](const auto& file) {
        return text_of(sources.folder / file, file).find("inout") != std::string::npos;
      });
  return has_any ? Split(sources, to).files : sources.files;
}

}  // namespace cosim::rtl
