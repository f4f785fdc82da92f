#include <algorithm>
#include <set>
#include <vector>

#include "model/core/input_error.h"
#include "tb/rtl/regex.h"
#include "tb/rtl/vhdl.h"

namespace cosim::rtl {
namespace {

// A literal of VHDL as one of Verilog; another word as it is.
std::string constant(const std::string& text) {
  static const Regex part("^(\\w+) \\(([0-9]+)( downto ([0-9]+))?\\)$");
  static const Regex bits("^[\"']([01XZ]+)[\"']$", REG_ICASE);
  if (const Match m = part.find(text))
    return m[1] + '[' + m[2] + (m.has(3) ? ':' + m[4] : "") + ']';
  const Match m = bits.find(text);
  return m ? std::to_string(m.size(1)) + "'b" + m[1] : text;
}

// What nets are made of.
struct Nets {
  explicit Nets(const std::string& text) {
    static const Regex statement(
        "^(  assign (\\w+) = (.*);.*|  always @\\*\n    (\\w+) = (\\w+); // \\(isignal\\)|"
        "  always @\\*\n    case \\(.*\\)\n      \\S+ (\\w+) <=.*)$",
        REG_NEWLINE);
    static const Regex is_signal("// \\(i?signal\\)$"), word("\\b[A-Za-z_]\\w*");
    for (const Match& m : statement.all(text)) {
      const std::string net = m[2] + m[4] + m[6];
      std::string value = m[3] + m[5];
      if (m.has(6))
        value = text.substr(m.begin() + 8, text.find("\n    endcase", m.begin()) - m.begin() - 8);
      if (!m.has(6) && is_signal.find(m[0])) signals.insert(net);
      for (const Match& one : word.all(value)) users[one[0]].push_back(net);
    }
  }
  // The nets and the signals that follow from a net, but not through a signal.
  std::set<std::string> reach(const std::string& net) const {
    std::set<std::string> seen;
    std::vector<std::string> next{net};
    while (!next.empty()) {
      const auto of = users.find(next.back());
      next.pop_back();
      for (const std::string& one : of == users.end() ? std::vector<std::string>{} : of->second) {
        if (seen.insert(one).second && !signals.contains(one)) next.push_back(one);
      }
    }
    return seen;
  }

  std::set<std::string> signals;
  std::map<std::string, std::vector<std::string>> users;
};

void replace_first(std::string& text, const std::string& expression, std::string_view by) {
  const Regex regex(expression, REG_NEWLINE);
  if (const Match m = regex.find(text)) {
    text.replace(m.begin(), m.size(), regex.replaced(m[0], by));
  }
}

// A register that is written at an index is a loop through an edge, which GHDL writes as 0: with
// the edge as 1 the loop is what the register takes. InputError where an edge is used for anything
// else.
std::string with_registers_for_edges(std::string text, const NetlistModule& netlist) {
  static const Regex edges(
      "^  /\\* (\\S+:[0-9]+):[0-9]+  \\*/\n  assign (\\w+) = 1'b0; // (pos|neg)edge$", REG_NEWLINE);
  if (!edges.find(text)) return text;
  const Nets nets(text);
  const std::string before = text;
  for (const Match& m : edges.all(before)) {
    const std::string edge = m[2];
    const std::set<std::string> seen = nets.reach(edge);
    const auto clock = netlist.edges.find(edge);
    bool is_register = clock != netlist.edges.end();
    std::string rest = text;
    if (is_register) {  // a register that takes a net on the same edge
      rest = Regex("^  always @\\(" + clock->second + "\\)\n    \\w+ <= \\w+;\n", REG_NEWLINE)
                 .replaced(rest, "");
    }
    std::vector<std::string> registers;
    for (const std::string& net : seen) {
      const bool follows_itself = nets.reach(net).contains(net);
      if (nets.signals.contains(net)) {
        registers.push_back(net);
        is_register = is_register && follows_itself;
      } else {
        is_register =
            is_register && !follows_itself &&
            !Regex("(<= |\\()" + net + "\\b([^(]|$)|^   output .*\\b" + net + "\\b", REG_NEWLINE)
                 .find(rest);
      }
    }
    if (!is_register || registers.empty()) {
      throw InputError(m[1] + ": GHDL makes no register of the signal that this edge writes");
    }
    for (const std::string& net : registers) {
      const std::string takes = "  always @(" + clock->second + ")\n    " + net + " <= \\";
      replace_first(text,
                    "^  (assign " + net + " = (\\w+); // \\(signal\\)|always @\\*\n    " + net +
                        " = (\\w+); // \\(isignal\\))$",
                    takes + "2\\3;");
      replace_first(text, "^  wire ((\\[[0-9]+:0\\] )?" + net + ";)$", "  reg \\1");
    }
    replace_first(text, "^(  assign " + edge + " = )1'b0", "\\11'b1");
  }
  return text;
}

// The accesses of a memory in their order: a read behind a write on the same edge sees what is
// written, and the last one of two writes at an address stays.
std::string with_memories_in_order(const std::string& text) {
  static const Regex access(
      "^  always @\\((\\w+ \\w+)\\)\n    if \\((\\S+)\\)\n"
      "      ((\\w+)\\[(\\S+)\\] <= (\\S+)|(\\w+) <= (\\w+)\\[(\\S+)\\]);\n",
      REG_NEWLINE);
  static const Regex place("^<writes (\\w+ (\\w+ \\w+))>\n", REG_NEWLINE);
  struct Write {
    std::string enable, at, data;
  };
  std::map<std::string, std::vector<Write>> writes;  // by the memory and the clock
  const std::string marked = access.replaced(text, [&](const Match& m) {
    const std::string on = ' ' + m[1];
    if (m.has(4)) {
      writes[m[4] + on].push_back({m[2], m[5], m[6]});
      return "<writes " + m[4] + on + ">\n";
    }
    std::string value = m[8] + '[' + m[9] + ']';
    for (const Write& w : writes[m[8] + on])
      value = '(' + w.enable + " && " + w.at + " == " + m[9] + " ? " + w.data + " : " + value + ')';
    return "  always @(" + m[1] + ")\n    if (" + m[2] + ")\n      " + m[7] + " <= " + value +
           ";\n";
  });
  return place.replaced(marked, [&](const Match& m) {
    std::string all;
    const std::string to = m[1].substr(0, m[1].find(' '));
    for (const Write& w : writes[m[1]])
      all += "    if (" + w.enable + ")\n      " + to + '[' + w.at + "] <= " + w.data + ";\n";
    writes[m[1]].clear();
    return all.empty() ? "" : "  always @(" + m[2] + ") begin\n" + all + "  end\n";
  });
}

}  // namespace

std::map<std::string, NetlistModule> netlist_modules(const std::string& vhdl) {
  static const Regex begin("^architecture \\w+ of (\\S+) is", REG_NEWLINE);
  static const Regex initial("^  signal (n[0-9]+_q) : [^;]* := ([^;]*);$", REG_NEWLINE);
  static const Regex choice("^  with \\S+ select (\\w+) <=\n(    .*,\n)*    (.*) when others;$",
                            REG_NEWLINE);
  static const Regex edge(
      "^  (\\w+) <= '1' when (rising|falling)_edge \\((wrap_)?(\\w+)\\) else '0';$", REG_NEWLINE);
  static const Regex wrap("^wrap_(\\w)");
  std::map<std::string, NetlistModule> all;
  const std::vector<Match> modules = begin.all(vhdl);
  for (std::size_t i = 0; i < modules.size(); ++i) {
    const std::size_t from = modules[i].begin();
    const std::string text =
        vhdl.substr(from, (i + 1 < modules.size() ? modules[i + 1].begin() : vhdl.size()) - from);
    NetlistModule& module = all[in_small_letters(modules[i][1])];
    for (const Match& m : initial.all(text)) module.initial[m[1]] = constant(m[2]);
    for (const Match& m : choice.all(text))
      module.defaults[m[1]] = constant(wrap.replaced(m[3], "\\1"));
    for (const Match& m : edge.all(text))
      module.edges[m[1]] = (m[2] == "rising" ? "posedge " : "negedge ") + m[4];
  }
  return all;
}

void refuse_lost_values(const std::string& verilog, const std::string& said) {
  static const Regex value(
      "^  /\\* (\\S+:[0-9]+):([0-9]+)  \\*/\n  (assign|always @\\*\n   ) (\\S+) = (.*); // "
      "\\((i?)signal\\)$",
      REG_NEWLINE);
  for (const Match& m : value.all(verilog)) {
    const std::string warning = '\n' + m[1] + ':' + m[2] + ":warning: ";
    const auto warns = [&](const std::string& text) {
      return ('\n' + said).find(warning + text) != std::string::npos;
    };
    const bool is_without = warns("signal \"" + m[4] + "\" is never assigned"),
               in_part = warns("no assignment for offset");
    if (m[5].find("'bX") != std::string::npos && !is_without && !in_part) {
      throw InputError(m[1] + ": GHDL gives " + m[4] +
                       " no value: only its reset writes it, or nothing does");
    }
    if (m.size(6) != 0 && in_part) {
      throw InputError(m[1] + ": GHDL loses the initial value of bits of " + m[4] +
                       " that nothing writes");
    }
  }
}

std::string repaired(std::string text, const NetlistModule& netlist, bool has_any) {
  // An operand is one group, and two with a sign: the second one is the word.
  static const std::string word = "(\\w+|[0-9]+'b\\w+)", bits = "\\$(un)?signed\\(" + word + "\\)";
  static const std::string sized = "(resize ?\\()?" + bits + "(, [0-9]+\\))?";
  static const Regex wire("^  wire (\\[([0-9]+):0\\] )?(\\w+);$", REG_NEWLINE);
  static const Regex digits("\"([01XZ]+)\"");
  static const struct {
    Regex what;
    const char* by;
  } operators[]{
      {Regex(" = " + word + " / " + word + "; // sdiv$", REG_NEWLINE),
       " = $signed(\\1) / $signed(\\2); // sdiv"},
      {Regex(" = " + word + " % " + word + "; // srem$", REG_NEWLINE),
       " = $signed(\\1) % $signed(\\2); // srem"},
      {Regex(" = " + word + " % " + word + "; // smod$", REG_NEWLINE),
       " = ($signed(\\1) < 0) == ($signed(\\2) < 0) || $signed(\\1) % $signed(\\2) == 0 ? "
       "$signed(\\1) % $signed(\\2) : "
       "$signed(\\1) % $signed(\\2) + $signed(\\2); // smod"},
      {Regex("( = \\$signed\\(" + word + "\\)) >> "), "\\1 >>> "},
      {Regex("^  (\\w+) <= std_logic_vector\\(abs " + bits + "\\);$", REG_NEWLINE),
       "  assign \\1 = $signed(\\3) < 0 ? -\\3 : \\3;"},
      {Regex("^  (\\w+) <= " + word + " when " + bits + " ([<>]) " + bits + " else " + word + ";$",
             REG_NEWLINE),
       "  assign \\1 = $signed(\\4) \\5 $signed(\\7) ? \\2 : \\8;"},
      {Regex("^  (\\w+) <= std_logic_vector \\(" + sized + " \\+ " + sized + "\\);$", REG_NEWLINE),
       "  assign \\1 = \\4 + \\8;"},
      {Regex("^  (\\w+) <= " + word + "; -- \\((port|nop)\\)$", REG_NEWLINE),
       "  assign \\1 = \\2;"}};
  static const struct {
    Regex what;
    std::size_t to, from, by;  // groups
    const char *shift, *back;
  } rotations[]{{Regex("^  (\\w+) <= std_logic_vector \\(rotate_left \\(" + bits +
                           ", to_integer \\(" + bits + "\\)\\)\\);$",
                       REG_NEWLINE),
                 1, 3, 5, " << (", " >> ("},
                {Regex("^   gate_ror inst_[0-9]+ \\(\n    \\.a\\(" + word + "\\),\n    \\.b\\(" +
                           word + "\\),\n    \\.o\\((\\w+)\\)\\);$",
                       REG_NEWLINE),
                 3, 1, 2, " >> (", " << ("}};
  // An assertion has lost its severity, and an assumption is no Verilog.
  static const Regex assertion(
      "^(  always @\\*\n    if \\(!\\S+\\)\n      \\$fatal\\(.*\\);|  \\S+: assert .*; --  "
      "(assume|cover))\n",
      REG_NEWLINE);
  static const Regex one_hot("^    case \\(\\w+\\)\n      [0-9]+'b1?0*: (\\w+) <= ", REG_NEWLINE);
  static const Regex is_x("'b[X-]+$", REG_ICASE);
  static const Regex reset(
      "^  always @\\(.* or posedge \\w+\\)\n.*\n      (\\w+) <= .*\n    else\n.*\n", REG_NEWLINE);
  static const Regex odd(
      "^ *\\S.*(<unassigned>|\\*(err|nil)\\*|std_logic_vector|\\bgate_|-- \\(|//\\(dyn_extract\\)| "
      "when | = \"\";).*$",
      REG_NEWLINE);
  static const Regex place("^  /\\* (\\S+:[0-9]+):[0-9]+  \\*/$", REG_NEWLINE);

  // More than 32 bits are a string, which has eight bits a digit.
  text =
      digits.replaced(text, [](const Match& m) { return std::to_string(m.size(1)) + "'b" + m[1]; });
  for (const auto& one : operators) text = one.what.replaced(text, one.by);
  std::map<std::string, std::string> width;
  for (const Match& m : wire.all(text))
    width[m[3]] = std::to_string(1 + (m.has(1) ? std::stoul(m[2]) : 0));
  for (const auto& one : rotations) {
    text = one.what.replaced(text, [&](const Match& m) {
      const std::string w = width.contains(m[one.to]) ? width[m[one.to]] : "1", from = m[one.from],
                        n = m[one.by] + " % " + w;
      return "  assign " + m[one.to] + " = " + from + one.shift + n + ") | " + from + one.back + w +
             " - " + n + ");";
    });
  }
  text = assertion.replaced(text, "");
  // The default of a case, and the initial value of a register with an asynchronous reset.
  for (Match m = one_hot.find(text); m;) {
    const std::size_t from = m.end(), end = text.find("\n    endcase\n", from);
    const auto value = netlist.defaults.find(m[1]);
    if (end == std::string::npos) break;
    if (value != netlist.defaults.end() && (has_any || !is_x.find(value->second))) {
      text.insert(end + 1, "      default: " + m[1] + " <= " + value->second + ";\n");
    }
    m = one_hot.find(text, from);
  }
  text = reset.replaced(text, [&](const Match& m) {
    const auto value = netlist.initial.find(m[1]);
    return m[0] + (value == netlist.initial.end()
                       ? ""
                       : "  initial\n    " + m[1] + " <= " + value->second + ";\n");
  });
  text = with_memories_in_order(with_registers_for_edges(text, netlist));
  for (const Match& m : odd.all(text)) {
    const std::string line = m[0], word_of = line.substr(line.find_first_not_of(' '), 2);
    if (word_of == "//" || word_of == "/*") continue;
    const std::vector<Match> places = place.all(std::string_view(text).substr(0, m.begin()));
    throw InputError((places.empty() ? "VHDL" : places.back()[1]) +
                     ": GHDL cannot convert it to Verilog: " + line);
  }
  return text;
}

std::set<std::string> scalar_types(const std::vector<std::string>& texts) {
  static const Regex type(
      "\\b(type\\s+(\\w+)\\s+is\\s*(\\(|range\\b)|subtype\\s+(\\w+)\\s+is\\s+(\\w+))", REG_ICASE);
  std::set<std::string> all{"bit", "boolean", "integer", "natural", "positive"};
  for (const std::string& text : texts) {
    for (const Match& m : type.all(text)) {
      if (m.has(2)) all.insert(in_small_letters(m[2]));
      if (m.has(4) && all.contains(in_small_letters(m[5]))) all.insert(in_small_letters(m[4]));
    }
  }
  return all;
}

std::string with_first_values(const std::string& text, const std::set<std::string>& scalars) {
  static const Regex declared(
      "--[^\n]*|(\\bsignal\\s+[A-Za-z0-9_,[:space:]]+:|:\\s*(out|buffer)\\b)\\s*(\\w+)([^:;]*);",
      REG_ICASE),
      entity("\\b(entity\\s+\\w+\\s+is|end)\\b", REG_ICASE), to("\\b(to|downto)\\b", REG_ICASE),
      range("^\\s+range\\b", REG_ICASE);
  const std::vector<Match> marks = entity.all(text);
  // A parameter of a procedure cannot have a value to begin with.
  const auto is_port = [&](std::size_t at) {
    const auto next = std::ranges::find_if(marks, [&](const Match& m) { return m.begin() > at; });
    return next != marks.begin() && std::prev(next)->size() > 3;
  };
  return declared.replaced(text, [&](const Match& m) {
    if (!m.has(1) || !scalars.contains(in_small_letters(m[3]))) return m[0];
    if (m.has(2) && !is_port(m.begin())) return m[0];
    const std::string tail = m[4];
    // The last port ends with the bracket of all of them.
    std::size_t end = 0;
    for (int open = 0; end < tail.size(); ++end) {
      open += (tail[end] == '(') - (tail[end] == ')');
      if (open < 0) break;
    }
    const std::string values = tail.substr(0, end);
    const Match word = range.find(values), ends = to.find(values);
    const bool is_whole = values.find_first_not_of(" \t\r\n") == std::string::npos;
    if (!is_whole && (!word || !ends)) return m[0];
    const std::string first =
        is_whole ? m[3] + "'left"
                 : '(' + values.substr(word.end(), ends.begin() - word.end()) + ')';
    return m[1] + ' ' + m[3] + values + " := " + first + tail.substr(end) + ';';
  });
}

}  // namespace cosim::rtl
