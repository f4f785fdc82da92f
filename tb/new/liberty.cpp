// Functions are turned into expressions of Verilog, flip-flops and latches into always blocks, at
// the pins' own edges where they are pins or inverted ones: so a clock or a reset of a cell is
// still that of the design. A cell is left out rather than read as something else.
#include "tb/new/liberty.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <cctype>
#include <set>
#include <string_view>
#include <vector>

#include "model/core/input_error.h"
#include "tb/util/pattern.h"

namespace cosim::cli {
namespace {

// Why no module can be made of a cell.
struct LeftOut {
  std::string why;
};

// In Verilog: one that is no plain name is escaped.
std::string verilog_name(const std::string& name) {
  static const Pattern plain("[A-Za-z_][\\w$]*");
  return plain.whole(name).empty() ? '\\' + name + ' ' : name;
}

// A function of Liberty: ! before and ' behind, then ^, then * & or nothing, then + or |.
class Function {
 public:
  Function(std::string_view text, const std::set<std::string>& buses)
      : text_(text), buses_(buses) {}

  std::string expression() {
    std::string all = any();
    if (!peek().empty()) throw LeftOut{fmt::format("its function {} is not read", text_)};
    return all;
  }

 private:
  std::string_view peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return text_.substr(at_, 1);
  }
  bool take(std::string_view signs) {
    if (peek().empty() || signs.find(text_[at_]) == std::string_view::npos) return false;
    ++at_;
    return true;
  }
  std::string any() {
    std::string all = every();
    while (take("+|")) all += " | " + every();
    return '(' + all + ')';
  }
  std::string every() {
    std::string all = odd();
    while (take("*&") || (!peek().empty() &&
                          std::string_view("+|^)'").find(text_[at_]) == std::string_view::npos)) {
      all += " & " + odd();
    }
    return '(' + all + ')';
  }
  std::string odd() {
    std::string all = one();
    while (take("^")) all += " ^ " + one();
    return '(' + all + ')';
  }
  std::string one() {
    if (take("!")) return "(~" + one() + ')';
    std::string all;
    if (take("(")) {
      all = any();
      if (!take(")")) throw LeftOut{fmt::format("its function {} is not read", text_)};
    } else {
      all = name();
    }
    while (take("'")) all = "(~" + all + ')';
    return all;
  }
  std::string name() {
    peek();
    std::string word;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
            std::string_view("_[]$.:").find(text_[at_]) != std::string_view::npos)) {
      word += text_[at_++];
    }
    if (word == "0" || word == "1") return "1'b" + word;
    if (word.empty()) throw LeftOut{fmt::format("its function {} is not read", text_)};
    return buses_.contains(word.substr(0, word.find('['))) ? word : verilog_name(word);
  }

  std::string_view text_;
  const std::set<std::string>& buses_;
  std::size_t at_ = 0;
};

class Cell {
 public:
  Cell(const LibertyGroup& cell, const LibertyGroup& library) : cell_(cell), library_(library) {}

  std::string module() {
    for (const char* other : {"ff_bank", "latch_bank", "statetable", "bundle"}) {
      for (const LibertyGroup& g : cell_.groups) {
        if (g.kind == other) throw LeftOut{fmt::format("{} is not read", other)};
      }
    }
    for (const LibertyGroup& g : cell_.groups) {
      if (g.kind == "bus") buses_.insert(g.name());
    }
    for (const LibertyGroup& g : cell_.groups) {
      if (g.kind == "ff" || g.kind == "latch") register_of(g);
    }
    for (const LibertyGroup& g : cell_.groups) {
      if (g.kind == "pin") {
        for (const std::string& name : g.names) pin(name, "", g);
      } else if (g.kind == "bus") {
        pin(g.name(), range_of(g), g);
      }
    }
    for (const LibertyGroup& g : cell_.groups) {
      if (g.kind == "pg_pin") add_port("input", "", verilog_name(g.name()));
    }
    return fmt::format("module {}({});\n{}{}{}endmodule\n", verilog_name(cell_.name()),
                       fmt::join(ports_, ", "), declared_, inner_, body_);
  }

 private:
  std::string in_verilog(const std::string& function) const {
    return Function(function, buses_).expression();
  }

  void add_port(const char* way, const std::string& range, const std::string& name) {
    ports_.push_back(name);
    declared_ += fmt::format("{} {}{};\n", way, range, name);
  }

  std::string range_of(const LibertyGroup& bus) const {
    for (const auto* in : {&cell_, &library_}) {
      for (const LibertyGroup& g : in->groups) {
        if (g.kind != "type" || g.name() != bus.value("bus_type")) continue;
        return fmt::format("[{}:{}] ", g.value("bit_from"), g.value("bit_to"));
      }
    }
    throw LeftOut{"bus " + bus.name() + " has no type"};
  }

  void pin(const std::string& name, const std::string& range, const LibertyGroup& about) {
    const std::string way = about.value("direction"), function = about.value("function");
    const std::string own = verilog_name(name);
    if (way == "input") return add_port("input", range, own);
    if (way == "internal") {
      declared_ += fmt::format("wire {}{};\n", range, own);
    } else if (way == "output") {
      add_port("output", range, own);
    } else {
      throw LeftOut{fmt::format("pin {} is {}", name, way.empty() ? "of no direction" : way)};
    }
    if (function.empty()) throw LeftOut{fmt::format("pin {} has no function", name)};
    const std::string off = about.value("three_state");
    const std::string driven = in_verilog(function);
    body_ += off.empty()
                 ? fmt::format("assign {} = {};\n", own, driven)
                 : fmt::format("assign {} = {} ? 1'bz : {};\n", own, in_verilog(off), driven);
  }

  // "posedge P", and the condition; of what is no pin a wire is made.
  struct Edge {
    std::string event, active;
  };
  Edge edge_of(const std::string& function, const std::string& wire) {
    static const Pattern pin("\\s*(!?)\\s*\\(?\\s*(\\w+)\\s*\\)?\\s*('?)\\s*");
    const Pattern::Parts part = pin.whole(function);
    if (!part.empty() && (part[1].empty() || part[3].empty())) {
      const bool falls = !part[1].empty() || !part[3].empty();
      const std::string name = verilog_name(part[2]);
      return {(falls ? "negedge " : "posedge ") + name, (falls ? "!" : "") + name};
    }
    inner_ += fmt::format("wire {} = {};\n", wire, in_verilog(function));
    return {"posedge " + wire, wire};
  }

  // The two names of `g` are what it holds and the inverse; where it is cleared and preset at once
  // clear_preset_var1 and clear_preset_var2 say what they are.
  void register_of(const LibertyGroup& g) {
    if (g.names.empty()) throw LeftOut{"a register has no name"};
    if (!g.value("clocked_on_also").empty()) throw LeftOut{"clocked_on_also is not read"};
    const bool is_latch = g.kind == "latch";
    const std::string q = verilog_name(g.names[0]);
    const std::string clear = g.value("clear"), preset = g.value("preset");
    inner_ += fmt::format("reg {};\n", q);
    std::string way, events, inverse = "~" + q;
    const auto give = [&](const std::string& function, const char* value, const char* what) {
      if (function.empty()) return;
      const Edge edge = edge_of(function, fmt::format("cosim_{}_{}", what, registers_));
      way +=
          fmt::format("if ({}) {} {} 1'b{};\nelse ", edge.active, q, is_latch ? "=" : "<=", value);
      events += " or " + edge.event;
    };
    const std::string both = g.value("clear_preset_var1");
    const bool sets_first = both == "H";
    if (!clear.empty() && !preset.empty() && both != "H" && both != "L") {
      throw LeftOut{"what it is where it is cleared and preset at once is not said"};
    }
    if (sets_first) give(preset, "1", "preset");
    give(clear, "0", "clear");
    if (!sets_first) give(preset, "1", "preset");
    if (is_latch) {
      const std::string enable = g.value("enable"), data = g.value("data_in");
      if (enable.empty() != data.empty()) throw LeftOut{"a latch without enable or data"};
      if (!enable.empty()) {
        way += fmt::format("if ({}) {} = {};\n", in_verilog(enable), q, in_verilog(data));
      }
      body_ += "always @*\n" + (enable.empty() ? way.substr(0, way.rfind("else")) : way);
    } else {
      const std::string clock = g.value("clocked_on"), next = g.value("next_state");
      if (clock.empty() || next.empty()) throw LeftOut{"a register without clock or next state"};
      const Edge edge = edge_of(clock, fmt::format("cosim_clock_{}", registers_));
      body_ += fmt::format("always @({}{})\n{}{} <= {};\n", edge.event, events, way, q,
                           in_verilog(next));
    }
    if (g.names.size() > 1) {
      const std::string inverse_both = g.value("clear_preset_var2");
      if (!clear.empty() && !preset.empty() && (inverse_both == "H" || inverse_both == "L")) {
        inverse = fmt::format("({}) & ({}) ? 1'b{} : ~{}", in_verilog(clear), in_verilog(preset),
                              inverse_both == "H" ? 1 : 0, q);
      }
      inner_ += fmt::format("wire {} = {};\n", verilog_name(g.names[1]), inverse);
    }
    ++registers_;
  }

  const LibertyGroup& cell_;
  const LibertyGroup& library_;
  std::set<std::string> buses_;
  std::vector<std::string> ports_;
  std::string declared_, inner_, body_;
  int registers_ = 0;
};

}  // namespace

bool is_liberty(const std::string& file) { return file.ends_with(".lib"); }

LibertyCells cells_of(const std::string& text, const std::string& file) {
  const LibertyGroup library = read_liberty(text, file);
  LibertyCells all;
  std::set<std::string> met;
  for (const LibertyGroup& cell : library.groups) {
    if (cell.kind != "cell" || !met.insert(cell.name()).second) continue;
    try {
      all.verilog += Cell(cell, library).module();
    } catch (const LeftOut& why) {
      all.left_out[cell.name()] = why.why;
    }
  }
  if (met.empty()) throw InputError(file + ": the library has no cell");
  return all;
}

}  // namespace cosim::cli
