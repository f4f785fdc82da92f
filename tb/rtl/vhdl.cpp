#include "tb/rtl/vhdl.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "model/core/input_error.h"
#include "tb/rtl/files.h"
#include "tb/rtl/regex.h"
#include "tb/rtl/verilog.h"

namespace cosim::rtl {
namespace {

namespace fs = std::filesystem;

struct Generic {
  std::string name, value;  // "" without a default
};

struct Entity {
  std::string name;
  std::vector<Generic> generics;
};

std::string uncommented(const std::string& text) {
  static const Regex comment("--[^\n]*");
  return comment.replaced(text, "");
}

// GHDL on copies of the files, in which functions of numeric_vhd stand in front of those of
// numeric_std, and signals have their first values.
class Ghdl {
 public:
  Ghdl(const Sources& sources, const std::vector<std::string>& texts, const fs::path& work,
       const Run& run)
      : files_(sources.files), work_(work), run_(run) {
    fs::remove_all(work_);
    fs::create_directories(work_);
    const auto uses = [](const std::string& text) {
      static const Regex unsigned_package("\\bnumeric_std_unsigned\\b", REG_ICASE);
      return static_cast<bool>(unsigned_package.find(text));
    };
    declare_functions(std::any_of(texts.begin(), texts.end(), uses));
    const std::set<std::string> scalars = scalar_types(texts);
    std::vector<std::string> words;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      refuse_full_names(files_[i], texts[i]);
      words.push_back("cosim_" + std::to_string(i) + ".vhd");
      write_text(work_ / words.back(), with_functions(with_first_values(texts[i], scalars)));
    }
    words.push_back("numeric.vhd");
    write_text(work_ / words.back(), std::string(numeric_vhd));
    (*this)("-i", words);
  }

  // What GHDL writes; its first error where it ends with one.
  std::string operator()(const std::string& command,
                         const std::vector<std::string>& arguments) const {
    static const Regex error("^\\S+:[0-9]+:[0-9]+:"), kind("^(note|warning)"),
        anew("[0-9]+: redeclaration of non-object alias (\"\\S+\").*");
    static const Regex column("^(\\S+:[0-9]+):[0-9]{4,}:");  // of what is put into a line
    std::vector<std::string> words{
        "sh",           "-c",        "cd \"$0\" && exec \"$@\" > out 2> said",
        work_.string(), "ghdl",      command,
        "--std=08",     "-fsynopsys"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const int status = run_(words).status;
    if (status == 0) return text_of(work_ / "out");
    if (status == 127) throw InputError("needs ghdl, which turns VHDL into Verilog");
    std::string first;
    const std::string text = said();
    for (const Match& m : Regex("[^\n]+").all(text)) {
      const std::string line = m[0];
      const Match place = error.find(line);
      if (place && !kind.find(line.substr(place.end()))) {
        first = line;
        break;
      }
      if (first.empty() && line.front() != '*' && !trimmed(line).empty()) first = line;
    }
    if (first.empty()) first = "ghdl says nothing";
    if (text.find("GHDL Bug occurred") != std::string::npos) {
      first = "GHDL ends in an error of its own; it names no line";
    }
    throw InputError(column.replaced(
        own_names(anew.replaced(first, " declares \\1 of numeric_std anew: give it another name")),
        "\\1:"));
  }
  std::string said() const { return text_of(work_ / "said"); }
  // The text with the names of the files for those of the copies.
  std::string own_names(const std::string& text) const {
    static const Regex copy("cosim_([0-9]+)\\.vhd");
    return copy.replaced(text, [&](const Match& m) { return files_[std::stoul(m[1])]; });
  }
  // Does something whose errors name the copies.
  void own_errors(const std::function<void()>& what) const {
    try {
      what();
    } catch (const InputError& error) {
      throw InputError(own_names(error.what()));
    }
  }

 private:
  void declare_functions(bool on_vectors) {
    static const Regex function("^  function (\\S+) \\(([^)]*)\\) return (\\w+);$", REG_NEWLINE),
        type(": (\\w+)");
    for (const Match& m : function.all(numeric_vhd)) {
      const std::string name = m[1], arguments = m[2];
      if (name.starts_with("wide") ||
          (!on_vectors && arguments.find("std_ulogic_vector") != std::string::npos))
        continue;
      const auto full = [](const std::string& of) {
        return of == "signed" || of == "unsigned" ? "ieee.numeric_std." + of
               : of.starts_with("std_ulogic")     ? "ieee.std_logic_1164." + of
                                                  : of;
      };
      std::string types;
      for (const Match& one : type.all(arguments))
        types += (types.empty() ? "" : ", ") + full(one[1]);
      functions_.insert(name);
      aliases_ += " alias " + name + " is work.cosim_numeric." + name + " [" + types + " return " +
                  full(m[3]) + "];";
    }
  }
  void refuse_full_names(const std::string& file, const std::string& text) const {
    static const Regex full("\\bnumeric_std\\s*\\.\\s*((\"[^\"]+\")|(\\w+)\\s*\\()", REG_ICASE);
    const std::string plain = uncommented(text);
    for (const Match& m : full.all(plain)) {
      const std::string name = in_small_letters(m[2] + m[3]);
      if (!functions_.contains(name)) continue;
      const auto line =
          1 +
          std::count(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(m.begin()), '\n');
      throw InputError(file + ':' + std::to_string(line) + ": numeric_std." + name +
                       ": GHDL reads it wrong: write it without numeric_std");
    }
  }
  std::string with_functions(const std::string& text) const {
    static const Regex body(
        "(--[^\n]*|\"[^\"\n]*\"|'[^\n]')|\\b((architecture\\s+\\w+\\s+of\\s+[A-Za-z0-9_.]+|"
        "package\\s+body\\s+\\w+)\\s+is\\b)",
        REG_ICASE);
    return body.replaced(
        text, [&](const Match& m) { return m.has(1) ? m[1] : "library ieee; " + m[2] + aliases_; });
  }

  const std::vector<std::string>& files_;
  fs::path work_;
  const Run& run_;
  std::string aliases_;
  std::set<std::string> functions_;
};

// By their names in small letters.
std::map<std::string, Entity> entities_in(const std::string& text) {
  static const Regex begin("\\bentity\\s+(\\w+)\\s+is\\b", REG_ICASE), end("\\bend\\b", REG_ICASE);
  static const Regex list("\\bgeneric\\s*\\(", REG_ICASE),
      list_end("\\)\\s*;\\s*(port|$)", REG_ICASE);
  static const Regex generic(
      "^\\s*(constant\\s+)?([A-Za-z0-9_,[:space:]]+):([^:]+)(:=\\s*(\\S.*))?$", REG_ICASE);
  std::map<std::string, Entity> all;
  for (Match m = begin.find(text); m;) {
    const Match last = end.find(text, m.end());
    if (!last) break;
    Entity& entity = all[in_small_letters(m[1])];
    entity.name = m[1];
    const std::string body = text.substr(m.end(), last.begin() - m.end());
    const Match from = list.find(body);
    const Match to = from ? list_end.find(body, from.end()) : Match{};
    std::string rest = to ? body.substr(from.end(), to.begin() - from.end()) : "";
    for (const Match& one : Regex("[^;]+").all(rest)) {
      const std::string text_of_one = one[0];
      const Match g = generic.find(text_of_one);
      for (const Piece& name : g ? parts(g[2]) : std::vector<Piece>{})
        entity.generics.push_back({name.text, trimmed(g[5])});
    }
    m = begin.find(text, last.end());
  }
  return all;
}

// What a register takes stands where it takes it: a reset is to be seen there.
std::string with_values(std::string text) {
  static const Regex taken("^( +\\w+ <= )(n[0-9]+_o);$", REG_NEWLINE), word("\\bn[0-9]+_o\\b");
  static const Regex value("^  assign (n[0-9]+_o) = (.*);\n", REG_NEWLINE),
      wire("^  wire (\\[[0-9]+:0\\] )?(n[0-9]+_o);\n", REG_NEWLINE);
  std::map<std::string, int> counts;
  std::map<std::string, std::string> values;
  std::set<std::string> all;
  for (const Match& m : word.all(text)) ++counts[m[0]];
  for (const Match& m : taken.all(text)) all.insert(m[2]);
  for (const Match& m : value.all(text)) {
    if (counts[m[1]] == 3 && all.contains(m[1])) values[m[1]] = m[2];
  }
  text = value.replaced(text, [&](const Match& m) { return values.contains(m[1]) ? "" : m[0]; });
  text = wire.replaced(text, [&](const Match& m) { return values.contains(m[2]) ? "" : m[0]; });
  return taken.replaced(text, [&](const Match& m) {
    return values.contains(m[2]) ? m[1] + values[m[2]] + ';' : m[0];
  });
}

// The last one of a case is for all others, too: what is left open is no latch.
std::string with_defaults(const std::string& text) {
  static const Regex begin("^    case \\(", REG_NEWLINE),
      has_default("^      default:", REG_NEWLINE), last("^      \\S+:( [^\n]*\n)$"), takes(" <= ");
  std::string made;
  std::size_t at = 0;
  for (Match m = begin.find(text); m; m = begin.find(text, at)) {
    const std::size_t end = text.find("endcase", m.end());
    if (end == std::string::npos) break;
    const bool is_own_line = std::string_view(text).substr(0, end).ends_with("\n    ");
    std::string one = text.substr(m.begin(), end - m.begin() - (is_own_line ? 4 : 0));
    if (is_own_line) {
      one = takes.replaced(one, " = ");
      const std::size_t line = one.rfind('\n', one.size() - 2) + 1;
      if (!has_default.find(one))
        one.replace(line, one.size() - line,
                    last.replaced(std::string_view(one).substr(line), "      default:\\1"));
    }
    made += text.substr(at, m.begin() - at) + one;
    at = m.begin() + (end - m.begin() - (is_own_line ? 4 : 0));
  }
  return made + text.substr(at);
}

std::string with_parameters(const std::string& text, const Entity& top,
                            const std::map<std::string, std::string>& values) {
  static const Regex number("^-?[0-9]+$"), plain("^\"?([A-Za-z0-9_.:+-]+)\"?$");
  std::string list;
  for (const Generic& one : top.generics) {
    const auto given = values.find(in_small_letters(one.name));
    const std::string value = given == values.end() ? one.value : given->second;
    const Match m = plain.find(value);
    const bool is_number = static_cast<bool>(number.find(value));
    if (!is_number && (!m || given == values.end())) continue;
    list += (list.empty() ? "parameter " : ", parameter ") + one.name + " = " +
            (is_number ? value : '"' + m[1] + '"');
  }
  const std::size_t line = text.find('\n');
  return list.empty() ? text
                      : text.substr(0, line) + "\n  #(" + list + ")\n" + text.substr(line + 1);
}

}  // namespace

std::string in_small_letters(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string verilog_of_vhdl(const Sources& sources, const fs::path& work, const Run& run) {
  static const Regex instance(
      ":\\s*(entity\\s+\\w+\\.|component\\s+)?(\\w+)\\s*(\\(\\s*\\w+\\s*\\)\\s*)?(generic|port)\\s+"
      "map\\b",
      REG_ICASE);
  static const Regex begin("^module (\\S+)", REG_NEWLINE),
      by_netlist("^    case|or posedge|; // (pos|neg)edge$", REG_NEWLINE);
  static const Regex unknown("^  initial\n    \\S+ <= [0-9]+'bX+;\n", REG_NEWLINE),
      initial("^(  initial\n    \\S+) <= ", REG_NEWLINE);
  static const Regex nets("^  (wire|reg) (\\[[0-9]+:0\\] )?n[0-9]+_o;$", REG_NEWLINE);
  std::map<std::string, Entity> entities;
  std::set<std::string> used, done;
  std::vector<std::string> texts;
  bool has_any = false;
  for (const std::string& file : sources.files) {
    texts.push_back(text_of(sources.folder / file, file));
    const std::string text = uncommented(texts.back());
    refuse_misread_vhdl(file, text);
    has_any = has_any || text.find("'-'") != std::string::npos;
    entities.merge(entities_in(text));
    for (const Match& m : instance.all(text)) used.insert(in_small_letters(m[2]));
  }
  if (entities.empty()) throw InputError(sources.files.front() + ": no entity");
  const Ghdl ghdl(sources, texts, work, run);
  const std::string top = in_small_letters(sources.top);
  const bool is_top = entities.contains(top);
  std::map<std::string, std::string> values;
  for (const std::string& one : sources.parameters)
    values[in_small_letters(one.substr(0, one.find('=')))] = one.substr(one.find('=') + 1);
  std::string all;
  for (const auto& [root, entity] : entities) {
    if (is_top ? root != top : used.contains(root)) continue;
    ghdl("-m", {root});
    std::vector<std::string> words{"--out=verilog"};
    for (const auto& [name, value] : values) {
      if (is_top) words.push_back("-g" + name + '=' + value);
    }
    words.push_back(root);
    // GHDL 5 says behind a line what it is.
    static const Regex said("( //\\(module output\\)| // extract)$", REG_NEWLINE);
    const std::string text = said.replaced(ghdl("--synth", words), "");
    ghdl.own_errors([&] { refuse_lost_values(text, ghdl.said()); });
    std::map<std::string, NetlistModule> netlist;
    const std::vector<Match> modules = begin.all(text);
    for (std::size_t i = 0; i < modules.size(); ++i) {
      const std::string name = modules[i][1];
      if (!done.insert(name).second) continue;
      const std::size_t from = modules[i].begin();
      std::string module =
          text.substr(from, (i + 1 < modules.size() ? modules[i + 1].begin() : text.size()) - from);
      if (netlist.empty() && by_netlist.find(module)) {
        words[0] = "--out=vhdl";
        netlist = netlist_modules(ghdl("--synth", words));
      }
      ghdl.own_errors([&] { module = repaired(module, netlist[in_small_letters(name)], has_any); });
      module = with_values(with_names(module));
      module = with_defaults(initial.replaced(unknown.replaced(module, ""), "\\1 = "));
      if (is_top && in_small_letters(name) == root)
        module = with_parameters(module, entity, values);
      all += ghdl.own_names(module);
    }
  }
  // Small letters, for VHDL knows no others; the top as it is asked for.
  for (const std::string& name : done) {
    const std::string small = in_small_letters(name);
    if (name == small) continue;
    all = Regex("^(module |  )" + name + "(\\s)", REG_NEWLINE)
              .replaced(all, "\\1" + (small == top ? sources.top : small) + "\\2");
  }
  // Its own nets are no signals of the source: nobody covers their bits.
  all = nets.replaced(all, [](const Match& m) {
    return "/* verilator coverage_off */" + m[0] + " /* verilator coverage_on */";
  });
  return "// Made by GHDL from VHDL.\n/* verilator lint_off DECLFILENAME */\n/* verilator lint_off "
         "UNUSED */\n\n" +
         all;
}

}  // namespace cosim::rtl
