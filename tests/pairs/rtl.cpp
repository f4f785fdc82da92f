// A design as a file of Verilog: the old RTL as it was drawn, the new one in other words.
#include <algorithm>

#include "tests/pairs/write.h"

namespace cosim::pairs {
namespace {

std::string extended(const Expr& given, Type type) {
  std::string bits = given.bits;
  const std::size_t width = static_cast<std::size_t>(type.width);
  if (bits.size() > width) return bits.substr(bits.size() - width);
  return std::string(width - bits.size(), given.type.is_signed ? bits[0] : '0') + bits;
}

class Rtl {
 public:
  Rtl(const Design& design, Random& random, bool is_gate)
      : design_(design), random_(random), is_gate_(is_gate), w_(design, random, is_gate) {}

  Written all() {
    for (const Signal& s : design_.resets) w_.scope[s.name] = s;
    for (const Signal& s : design_.inputs) w_.scope[s.name] = s;
    for (const Item& item : design_.items) w_.scope[item.target.name] = item.target;
    const bool has_package = is_sv() && !design_.functions.empty() && random_.percent(50);
    std::string functions;
    for (const Function& f : design_.functions) functions += function(f);
    for (const Item& item : design_.items) {
      w_.may_name = is_gate_;
      // What a block reads of its own variable is not what it is assigned to outside.
      w_.may_declare = is_sv() && item.is != Is::comb && item.is != Is::instance;
      const std::string text = written(item);
      items_ += w_.lines + text;
      w_.lines.clear();
    }
    std::string text;
    if (has_package) text += "package lib;\n" + functions + "endpackage\n";
    text += children_ + "module t(";
    for (const Clock& clock : design_.clocks) text += "input " + clock.name + ", ";
    for (const Signal& s : design_.resets) text += "input " + s.name + ", ";
    for (const Signal& s : design_.inputs) text += w_.declared("input", s) + ", ";
    std::string outputs, inside;
    for (const Item& item : design_.items) {
      if (item.is == Is::memory) continue;
      const bool is_variable = variables_.count(item.target.name) != 0;
      const std::string kind = is_sv() ? "logic" : is_variable ? "reg" : "wire";
      if (item.is_output) {
        outputs += (outputs.empty() ? "" : ", ") + w_.declared("output " + kind, item.target);
      } else {
        inside += "  " + w_.declared(kind, item.target) + ";\n";
      }
    }
    text += outputs + ");\n";
    if (has_package) text += "  import lib::*;\n";
    text += declarations_ + inside + (has_package ? "" : functions) + items_ + "endmodule\n";
    return {text, files_};
  }

 private:
  bool is_sv() const { return design_.is_sv && !is_gate_; }

  std::string function(const Function& f) {
    const std::map<std::string, Signal> outer = w_.scope;
    // Icarus 11 does not run what reads parts of a function's own name.
    const Signal& value = f.value;
    w_.scope = {{value.name, value}};
    w_.may_name = w_.may_declare = false;
    std::string text =
        "  " + w_.declared(is_sv() ? "function automatic" : "function", f.result) + ";\n";
    for (const Signal& s : f.arguments) {
      w_.scope[s.name] = s;
      text += "    " + w_.declared("input", s) + ";\n";
    }
    text += "    " + w_.declared("reg", value) + ";\n";
    text += loop_variables(f.body, "    ");
    text += "    begin\n" + w_.statements(f.body, value, "=", "      ") + "      " + f.result.name +
            " = " + value.name + ";\n    end\n  endfunction\n";
    w_.scope = outer;
    return text;
  }

  std::string written(const Item& item) {
    const std::string& name = item.target.name;
    const int width = item.target.type.width;
    switch (item.is) {
      case Is::net:
        return "  assign " + name + " = " + w_.assigned(item.value, width) + ";\n";
      case Is::comb:
        if (w_.rarely(50)) {
          const std::string zeros = sized(std::string(static_cast<std::size_t>(width), '0'));
          const std::string value = w_.flat(item.body, item.target, zeros, true);
          w_.scope[name] = item.target;
          return "  assign " + name + " = " + value + ";\n";
        }
        return always(is_sv() ? "always_comb" : "always @*", item, "=");
      case Is::clocked:
        return clocked(item);
      case Is::memory:
        return memory(item);
      case Is::instance:
        return instance(item);
      case Is::generate:
        return generate(item);
    }
    return "";
  }

  std::string always(const std::string& head, const Item& item, const std::string& gets) {
    variables_[item.target.name] = true;
    declarations_ += loop_variables(item.body, "  ");
    w_.may_name = false;
    return "  " + head + " begin\n" + w_.statements(item.body, item.target, gets, "    ") +
           "  end\n";
  }

  std::string edge(const Item& item) const {
    const Clock& clock = design_.clocks[static_cast<std::size_t>(item.clock)];
    return (clock.falls ? "negedge " : "posedge ") + clock.name;
  }

  std::string clocked(const Item& item) {
    const std::string& name = item.target.name;
    variables_[name] = true;
    const std::string first = sized(item.initial);
    std::string head = "  initial " + name + " = " + first + ";\n";
    std::string events = edge(item), reset;
    if (item.how != Reset::none) {
      const std::string& pin = design_.resets[static_cast<std::size_t>(item.reset)].name;
      const bool is_low = pin.ends_with("_n");
      reset = (is_low ? "!" : "") + pin;
      if (item.how == Reset::asynchronous)
        events += (is_low ? " or negedge " : " or posedge ") + pin;
    }
    const std::string ff = (is_sv() ? "  always_ff @(" : "  always @(") + events + ")\n";
    const std::string otherwise =
        "    " +
        (reset.empty() ? "" : "if (" + reset + ") " + name + " <= " + first + ";\n    else ");
    if (!w_.rarely(55)) {
      declarations_ += loop_variables(item.body, "  ");
      w_.may_name = false;
      return head + ff + otherwise + "begin\n" +
             w_.statements(item.body, item.target, "<=", "      ") + "    end\n";
    }
    std::string next = w_.flat(item.body, item.target, name, false);
    if (item.how == Reset::synchronous && random_.percent(60)) {
      next = w_.wire(item.target.type, reset + " ? " + first + " : " + next);
      return head + "  always @(" + events + ") " + name + " <= " + next + ";\n";
    }
    return head + ff + otherwise + name + " <= " + next + ";\n";
  }

  std::string memory(const Item& item) {
    const std::string& name = item.target.name;
    const Type type = item.target.type;
    std::string text;
    if (w_.rarely(40)) {
      w_.opened[name] = item.words;
      for (int k = 0; k < item.words; ++k) {
        const std::string word = Writer::word_of(name, k);
        declarations_ += "  " + w_.declared("reg", {word, type, 0, false, true, ""}) + " = " +
                         sized(item.contents[static_cast<std::size_t>(k)]) + ";\n";
      }
      for (const Write& write : item.writes)
        enables_.push_back(w_.wire({}, '|' + w_.expr(write.enable)));
      const std::size_t first = enables_.size() - item.writes.size();
      for (int k = 0; k < item.words; ++k) {
        Signal word{Writer::word_of(name, k), type, 0, false, true, ""};
        w_.scope[word.name] = word;
        std::string now = word.name;
        for (std::size_t i = 0; i < item.writes.size(); ++i) {
          const Write& write = item.writes[i];
          Stmt put;
          put.target = Target::part;
          put.low = write.low;
          put.count = write.count;
          put.value = write.data;
          const std::string at = w_.wired(write.address, type_of(write.address));
          now = w_.wire(type, enables_[first + i] + " && " + at + " == " + std::to_string(k) +
                                  " ? " + w_.flat({put}, word, now, false) + " : " + now);
        }
        text += "  always @(" + edge(item) + ") " + word.name + " <= " + now + ";\n";
      }
      return text;
    }
    declarations_ +=
        "  " + w_.declared("reg", item.target) + " [0:" + std::to_string(item.words - 1) + "];\n";
    if (item.from_file) {
      std::string words;
      for (const std::string& word : item.contents) words += word + '\n';
      files_.emplace_back(name + ".mem", words);
      text += "  initial $readmemb(\"" + name + ".mem\", " + name + ");\n";
    } else {
      text += "  initial begin\n";
      for (std::size_t k = 0; k < item.contents.size(); ++k) {
        text += "    " + name + '[' + std::to_string(k) + "] = " + sized(item.contents[k]) + ";\n";
      }
      text += "  end\n";
    }
    text += "  always @(" + edge(item) + ") begin\n";
    for (const Write& write : item.writes) {
      const bool is_whole = write.count == type.width;
      const std::string bits = is_whole ? ""
                                        : '[' + std::to_string(write.low + write.count - 1) + ':' +
                                              std::to_string(write.low) + ']';
      text += "    if (" + w_.expr(write.enable) + ") " + name + '[' + w_.expr(write.address) +
              ']' + bits + " <= " + w_.assigned(write.data, write.count) + ";\n";
    }
    return text + "  end\n";
  }

  std::string instance(const Item& item) {
    std::map<std::string, Signal> inner;
    const int width = item.target.type.width;
    if (w_.rarely(70)) {
      for (const Argument& port : item.ports) {
        const std::string name =
            w_.wire(port.formal.type, w_.assigned(port.actual, port.formal.type.width));
        inner[port.formal.name] = {name, port.formal.type, 0, false, true, ""};
      }
      for (const Argument& p : item.parameters) {
        Signal s = p.formal;
        s.text = sized(extended(p.actual, s.type), s.type.is_signed);
        inner[s.name] = s;
      }
      inner.swap(w_.scope);
      const std::string value = w_.assigned(item.value, width);
      inner.swap(w_.scope);
      return "  assign " + item.target.name + " = " + value + ";\n";
    }
    const std::string module = "below_" + item.target.name;
    std::string head, pins, given;
    for (const Argument& p : item.parameters) {
      Signal formal = p.formal;
      formal.is_vector = p.is_typed;
      if (!p.is_typed) formal.type = {};
      head += (head.empty() ? " #(" : ", ") + w_.declared("parameter", formal) + " = 1";
      given += (given.empty() ? "#(." : ", .") + p.formal.name + '(' + w_.expr(p.actual) + ')';
      inner[p.formal.name] = p.formal;
    }
    if (!given.empty()) head += ')', given += ") ";
    head = "module " + module + head + '(';
    for (const Argument& port : item.ports) {
      head += w_.declared("input", port.formal) + ", ";
      pins +=
          '.' + port.formal.name + '(' + w_.assigned(port.actual, port.formal.type.width) + "), ";
      inner[port.formal.name] = port.formal;
    }
    std::string lines;
    inner.swap(w_.scope);
    lines.swap(w_.lines);
    const std::string value = w_.assigned(item.value, width);
    children_ += head + w_.declared("output", {"o", item.target.type, 0, false, true, ""}) +
                 ");\n" + w_.lines + "  assign o = " + value + ";\nendmodule\n";
    lines.swap(w_.lines);
    inner.swap(w_.scope);
    return "  " + module + ' ' + given + "u_" + item.target.name + '(' + pins + ".o(" +
           item.target.name + "));\n";
  }

  std::string generate(const Item& item) {
    const Signal& s = item.target;
    const int count = s.type.width / item.turns;
    Signal loop{item.loop, {32, true}, 0, false, false, ""};
    if (w_.rarely(75)) {
      std::string all;
      for (int k = 0; k < item.turns; ++k) {
        loop.text = "32'sd" + std::to_string(k);
        w_.scope[item.loop] = loop;
        all = w_.wire({count, false}, w_.assigned(item.value, count)) + (k == 0 ? "" : ", ") + all;
      }
      return "  assign " + s.name + " = {" + all + "};\n";
    }
    w_.scope[item.loop] = loop;
    w_.may_name = false;
    const std::string at = item.loop + " * " + std::to_string(count);
    const std::string bits = s.ascending
                                 ? std::to_string(s.low + s.type.width - 1) + " - " + at + " -: "
                                 : std::to_string(s.low) + " + " + at + " +: ";
    return "  genvar " + item.loop + ";\n  generate\n    for (" + item.loop + " = 0; " + item.loop +
           " < " + std::to_string(item.turns) + "; " + item.loop + " = " + item.loop +
           " + 1) begin : of_" + s.name + "\n      assign " + s.name + '[' + bits +
           std::to_string(count) + "] = " + w_.assigned(item.value, count) +
           ";\n    end\n  endgenerate\n";
  }

  const Design& design_;
  Random& random_;
  bool is_gate_;
  Writer w_;
  std::string children_, declarations_, items_;
  std::map<std::string, bool> variables_;
  std::vector<std::string> enables_;
  std::vector<std::pair<std::string, std::string>> files_;
};

}  // namespace

Written write_rtl(const Design& design, Random& random, bool is_gate) {
  return Rtl(design, random, is_gate).all();
}

}  // namespace cosim::pairs
