#include "tb/equiv/misread.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "model/core/input_error.h"
#include "tb/equiv/front_end.h"
#include "tb/equiv/prints.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"
#include "tb/util/pattern.h"

namespace cosim::equiv {

std::vector<std::string> indices_at(std::string_view plain, std::size_t at) {
  std::vector<std::string> all;
  for (;;) {
    at = plain.find_first_not_of(" \t\r\n", at);
    if (at == std::string_view::npos || plain[at] != '[') return all;
    const std::size_t from = ++at;
    for (int depth = 1; at < plain.size() && depth > 0; ++at) {
      depth += plain[at] == '[' ? 1 : plain[at] == ']' ? -1 : 0;
    }
    all.emplace_back(plain.substr(from, at - from - 1));
  }
}

namespace {

// What stands between comments translate_off and translate_on: where each part begins and ends.
std::vector<std::pair<std::size_t, std::size_t>> hidden_in(const std::string& text) {
  static const rtl::Regex off("(synopsys|synthesis)[ \t]*translate_off");
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (const rtl::Match& found : off.all(text)) {
    all.emplace_back(found.end(), std::min(text.find("translate_on", found.end()), text.size()));
  }
  return all;
}

// Whether it assigns; what is in brackets counts not.
bool assigns(std::string_view statement) {
  int depth = 0;
  for (std::size_t i = 0; i < statement.size(); ++i) {
    const char c = statement[i];
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (depth == 0 &&
        (c == '=' || statement.substr(i, 2) == "++" || statement.substr(i, 2) == "--"))
      return true;
  }
  return false;
}

// A statement that waits: front ends take no time for it, and so no `if` before it. In `initial` it
// is one that something is assigned behind; the others check parameters, or print.
void refuse_waits(const SourceText& source) {
  static const rtl::Regex wait(
      "(\\)|;|\\bbegin|\\belse|\\bend|\\binitial|:|[^<>=!]=)\\s*#\\s*[0-9A-Za-z_`]|(\\)|\\bbegin|"
      "\\belse|"
      "\\binitial)\\s*#"
      "\\s*\\(|\\bwait\\s*\\("),
      block("\\b(initial|final|always\\w*|task|function|endtask|module)\\b");
  std::string text = source.text;
  if (hides_simulation(text)) {
    for (const auto& [from, to] : hidden_in(text)) blank(text, from, to);
  }
  const std::string plain = rtl::blanked(text);
  std::string in = "module";
  std::size_t began = 0;
  std::vector<rtl::Match> blocks = block.all(plain);
  std::size_t next = 0;
  for (const rtl::Match& found : wait.all(plain)) {
    for (; next < blocks.size() && blocks[next].begin() < found.begin(); ++next) {
      in = blocks[next][1];
      began = blocks[next].end();
    }
    if (in == "initial") {
      const std::size_t at = found.end(), end = behind_statement(plain, began, true);
      if (at >= end || !assigns(std::string_view(plain).substr(at, end - at))) continue;
    } else if (!in.starts_with("always") && in != "task") {
      continue;
    }
    throw InputError(fmt::format(
        "{}: a statement that waits; only q <= #1 d and assign #1 y = a, whose delays count for "
        "nothing, are read",
        place_in(source, found.begin())));
  }
}

// Whether an index of as many bits as it takes can be beyond a dimension; so it is of one whose
// size is no number.
bool has_beyond(const std::string& dimension) {
  static const Pattern range(R"(\[\s*(\d+)\s*:\s*0\s*\]|\[\s*0\s*:\s*(\d+)\s*\]|\[\s*(\d+)\s*\])");
  const auto part = range.whole(dimension);
  if (part.empty()) return true;
  const std::string last = part[1] + part[2];
  if (last.size() + part[3].size() > 9) return true;
  const unsigned long size = last.empty() ? std::stoul(part[3]) : std::stoul(last) + 1;
  return (size & (size - 1)) != 0;
}

// Words whose values are known when the RTL is read: of loops, parameters and the like.
class Constants {
 public:
  explicit Constants(const std::string& plain) {
    static const rtl::Regex loop("\\bfor\\s*\\(\\s*(\\w+\\s+)*(\\w+)\\s*="),
        each("\\bforeach\\s*\\(([^)]*)\\)"),
        constant("\\b(parameter|localparam|genvar)\\b([^;=]*)[=;]"), word("\\w+");
    for (const rtl::Match& one : loop.all(plain)) known_.insert(one[2]);
    const auto add = [&](const std::string& names) {
      for (const rtl::Match& name : word.all(names)) known_.insert(name[0]);
    };
    for (const rtl::Match& one : each.all(plain)) add(one[1]);
    for (const rtl::Match& one : constant.all(plain)) add(one[2]);
  }
  bool make(const std::string& index) const {
    static const rtl::Regex word("(^|[^'.$[:alnum:]_])([A-Za-z_]\\w*)");
    const auto words = word.all(index);
    return std::ranges::all_of(words, [&](const auto& w) { return known_.contains(w[2]); });
  }

 private:
  std::set<std::string> known_;
};

// A bit or a word beyond the end of what has two values is 0, and any value for both front ends.
void refuse_two_valued_beyond(const SourceText& source) {
  static const std::string ranges = "((\\[[^]]*\\]\\s*)*)";
  static const rtl::Regex declaration(
      "\\b(bit|byte|shortint|int|longint)\\b(\\s+(signed|unsigned)\\b)?\\s*" + ranges +
      "([A-Za-z_]\\w*)\\s*" + ranges + "[;,=)]"),
      dimension("\\[[^]]*\\]");
  const std::string plain = rtl::blanked(source.text);
  const Constants constants(plain);
  for (const rtl::Match& declared : declaration.all(plain)) {
    const std::string both = declared[4] + declared[7], name = declared[6];
    const auto dimensions = dimension.all(both);
    if (std::ranges::none_of(dimensions, [](const auto& d) { return has_beyond(d[0]); })) continue;
    const rtl::Regex use("\\b" + name + "\\s*\\[");
    for (const rtl::Match& found : use.all(plain)) {
      const auto indices = indices_at(plain, found.end() - 1);
      const bool is_known = std::ranges::all_of(indices, [&](const std::string& index) {
        return index.find(':') != std::string::npos || constants.make(index);
      });
      if (is_known) continue;
      throw InputError(
          fmt::format("{}: {} has two values, and is 0 beyond its end in SystemVerilog: no front "
                      "end reads it so",
                      place_in(source, found.begin()), name));
    }
  }
}

// A parameter that two defparams set, one of them from further above: the last one counts, and
// front ends and simulators take another one.
void refuse_rival_defparams(const SourceText& source) {
  static const rtl::Regex statement("\\bdefparam\\b([^;]*);"), path("([^=,]+)=[^,]*,?"),
      unneeded("\\[[^]]*\\]|\\s+"), parts("^(.*\\.)?([^.]+\\.[^.]+)$");
  const std::string plain = rtl::blanked(source.text);
  std::map<std::string, int> paths;  // to the last two names
  std::set<std::string> far;         // those that a longer path leads to
  for (const rtl::Match& set : statement.all(plain)) {
    const std::string all = set[1];
    for (const rtl::Match& one : path.all(all)) {
      const std::string whole = unneeded.replaced(one[1], "");
      const rtl::Match names = parts.find(whole);
      if (!names) continue;
      if (!names[1].empty()) far.insert(names[2]);
      if (++paths[names[2]] < 2 || !far.contains(names[2])) continue;
      throw InputError(fmt::format("{}: another defparam sets {}, too",
                                   place_in(source, set.begin()), names[2]));
    }
  }
}

void refuse_where(const std::vector<SourceText>& sources, const std::string& expression,
                  const char* what) {
  const std::string place = place_of(sources, expression);
  if (!place.empty()) throw InputError(fmt::format("{}: {}", place, what));
}

void refuse_misread_by_yosys(const std::vector<SourceText>& sources) {
  for (const SourceText& one : sources) {
    if (!one.is_included) continue;  // the others are written otherwise
    if (with_casts_apart(one.text) != one.text) {
      throw InputError(fmt::format(
          "{}: an operator before a cast, as |5'(x), which yosys misreads in a file that is "
          "included: put brackets around the cast",
          one.file.string()));
    }
    if (without_pragmas(one.text) != one.text) {
      throw InputError(fmt::format(
          "{}: translate_off in a file that is included: yosys leaves out what Verilog does not",
          one.file.string()));
    }
  }
  const std::string begins = "\\btask\\b[^;(]*", argument = "\\binout\\b",
                    arguments = ";(\\s*(input|output|reg|integer)\\b[^;]*;)*\\s*";
  refuse_where(sources, begins + "(\\([^;)]*|" + arguments + ")" + argument,
               "yosys misreads a task with an inout argument");
  refuse_where(sources, "\\bbind\\s+[A-Za-z_]", "yosys misreads bind");
  refuse_where(sources, "\\b(tri0|tri1|trireg)\\b", "yosys misreads tri0, tri1 and trireg");
}

}  // namespace

std::size_t behind_statement(std::string_view plain, std::size_t at, bool with_else) {
  static const rtl::Regex word("\\b(begin|case[xz]?|fork|end|endcase|join\\w*)\\b|[();]"),
      otherwise("^\\s*else\\b");
  int depth = 0;
  while (const rtl::Match found = word.find(plain.substr(at))) {
    at += found.end();
    const std::string is = found[0];
    if (is == "(" || is == "begin" || is == "fork" || is.starts_with("case")) ++depth;
    if (is == ")" || is.starts_with("end") || is.starts_with("join")) --depth;
    if (depth > 0 || is == ")") continue;
    if (!with_else || !otherwise.find(plain.substr(at))) return at;
  }
  return plain.size();
}

void refuse_misread(const std::vector<SourceText>& sources, FrontEnd front_end) {
  for (const SourceText& one : sources) {
    refuse_acting_statements(one);
    refuse_waits(one);
    refuse_two_valued_beyond(one);
    refuse_rival_defparams(one);
    refuse_routines(one);
    refuse_wide_indices(one);
    refuse_mixed_assignments(one);
  }
  refuse_where(sources, "\\[[^]]*(\\+\\+|--)[^]]*\\]\\s*([-+*/%&|^]|<<<?|>>>?)=[^=]",
               "an index that counts, before +=, is read as if it stood there twice");
  if (front_end == FrontEnd::yosys) return refuse_misread_by_yosys(sources);
  // Of a net that has one driver all other strengths are the same.
  refuse_where(sources, "\\bhighz[01]\\b", "slang misreads the strengths highz0 and highz1");
  refuse_where(sources, "[(,;]\\s*(const\\s+)?ref\\s+\\w",
               "slang misreads an argument that is a reference: ref");
  refuse_where(sources, "\\b(tri0|tri1|trireg)\\b", "slang does not read tri0, tri1 and trireg");
  refuse_where(sources, "(^|;|\\bend\\w*)\\s*program\\s+\\w+\\s*[;(#]",
               "slang leaves out a program");
  for (const SourceText& one : sources) {
    const std::size_t at = one.text.find("__slang__");
    if (at == std::string::npos) continue;
    throw InputError(
        fmt::format("{}: asks for the macro __slang__, which slang alone has", place_in(one, at)));
  }
}

// Verilog knows no such comments, and yosys leaves out what is between them.
std::string without_pragmas(const std::string& text) {
  static const rtl::Regex pragma("((synopsys|synthesis)[ \t]*translate)_(off|on)");
  return pragma.replaced(text, [](const rtl::Match& found) { return found[1] + '-' + found[3]; });
}

bool hides_simulation(const std::string& text) {
  static const rtl::Regex simulation("\\$[a-z]|\\binitial\\b");
  const auto parts = hidden_in(text);
  return std::ranges::all_of(parts, [&](const auto& part) {
    return bool(
        simulation.find(std::string_view(text).substr(part.first, part.second - part.first)));
  });
}

std::string without_macro_of_yosys(const std::string& text) {
  static const rtl::Regex word("`\\w+\\s+YOSYS\\b");
  return word.find(text) ? "`undef YOSYS " + text : text;
}

std::string revealed(const std::string& text) {
  const std::string seen = hides_simulation(text) ? text : without_pragmas(text);
  return with_resets_apart(without_macro_of_yosys(seen));
}

bool has_rows(const std::vector<SourceText>& sources) {
  static const std::string range = "\\s*\\[[^]]*\\]";
  static const rtl::Regex array("([A-Za-z_]\\w*)" + range + range + "(" + range + ")*\\s*[;,=)]"),
      type("\\b(reg|logic|wire|bit|byte|int|integer|\\w+_t)\\b");
  for (const SourceText& one : sources) {
    const std::string plain = rtl::blanked(one.text);
    const Constants constants(plain);
    for (const rtl::Match& found : array.all(plain)) {
      // A declaration, and no expression.
      const std::size_t from = plain.find_last_of(";=(", found.begin()) + 1;
      if (!type.find(std::string_view(plain).substr(from, found.begin() - from))) continue;
      const rtl::Regex use("\\b" + found[1] + "\\s*\\[");
      for (const rtl::Match& used : use.all(plain)) {
        const auto indices = indices_at(plain, used.end() - 1);
        if (!std::all_of(indices.begin() + 1, indices.end(),
                         [&](const std::string& index) { return constants.make(index); })) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace cosim::equiv
