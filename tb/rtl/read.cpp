#include "tb/rtl/read.h"

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/rtl/files.h"
#include "tb/rtl/preprocessed.h"
#include "tb/rtl/regex.h"
#include "tb/rtl/tree.h"
#include "tb/rtl/verilator_errors.h"

namespace cosim::rtl {
namespace {

using Words = std::vector<std::string>;

// In a file .v a word of SystemVerilog may be a name, as a port `do`; others use SystemVerilog in
// it.
constexpr const char* verilog_2005 = "+1364-2005ext+v";

void append(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
}

std::string without_folders(const std::string& error) {
  static const Regex folders("^[^:]*/");
  return folders.replaced(error, "");
}

class RtlReader {
 public:
  RtlReader(const RtlAsked& asked, const Run& run) : asked_(asked), run_(run) {
    std::filesystem::create_directories(asked_.work);
  }

  void write_tree() {
    Words tree = tree_options(asked_.verilator, run_);
    append(tree, {(asked_.work / "tree").string(), "-Werror-STMTDLY"});
    append(tree, asked_.files);
    const auto attempt = [&] { return verilator(tree); };
    Ran ran = attempt();
    // Verilator 5.006 can fail in an optimization that it can do without.
    static const Regex internal("Internal Error: [^\n]*V3Dfg");
    if (ran.status != 0 && internal.find(ran.text)) {
      read_.verilator.emplace_back("-fno-dfg");
      ran = attempt();
    }
    static const Regex other_language(
        "%Error: ([^\n]*[.]v:[0-9]+:[0-9]+: [^\n]*(syntax error|SystemVerilog)[^\n]*)");
    const Match wrong = other_language.find(ran.text);
    if (ran.status != 0 && wrong) {
      read_.verilator.insert(read_.verilator.begin(), verilog_2005);
      if (attempt().status == 0) {
        read_.language =
            "files .v are read as Verilog-2005, for in SystemVerilog: " + without_folders(wrong[1]);
        return;
      }
    }
    if (ran.status != 0) throw InputError(error_in(ran.text, "Verilator cannot read it"));
  }

  RtlRead take() {
    write_tree();
    preprocess();
    const std::string warnings = lint();
    read_.found = registers_in({asked_.work / "tree", warnings, netlist(), asked_.clocks});
    if (!read_.found.loops.empty() && !has_no_loop_) find_loop();
    return std::move(read_);
  }

 private:
  Ran run_here(const Words& words) const {
    Words all{"env", "-C", asked_.folder.string()};
    append(all, words);
    return run_(all);
  }
  Ran verilator(const Words& words) const {
    Words all{asked_.verilator, "--top-module", asked_.top,   "-Mdir",      asked_.work.string(),
              "-Wno-fatal",     "-Wno-lint",    "-Wno-style", "--no-timing"};
    append(all, asked_.options);
    append(all, read_.verilator);
    append(all, words);
    return run_here(all);
  }
  // yosys keeps a history in the user's home. What it does not know, such as a name in an
  // interface, is a new net for it, with a warning: an error here.
  Ran yosys(const std::string& commands, const Words& options) const {
    Words all{"env",
              "-u",
              "HOME",
              "-u",
              "XDG_STATE_HOME",
              asked_.yosys,
              "-q",
              "-e",
              "Identifier .*[.$].* is implicitly declared",
              "-p",
              commands};
    append(all, options);
    all.insert(all.begin(), {"timeout", "--foreground", "40"});
    return run_here(all);
  }

  // With all that it warns of, even if the RTL turns it off; a latch that is meant is one too.
  void preprocess() {
    plain_ = (asked_.work / "plain.sv").string();
    for (const std::string& file : asked_.files) {
      if (!file.ends_with(".vlt")) files_.push_back(file);
    }
    Words words{"sh", "-c", "to=$0 && exec \"$@\" > \"$to\"", plain_, asked_.verilator, "-E"};
    append(words, asked_.options);
    append(words, read_.verilator);
    append(words, files_);
    if (const Ran ran = run_here(words); ran.status != 0) {
      throw InputError(error_in(ran.text, "Verilator cannot read it"));
    }
    const std::string text = text_of(plain_);
    static const Regex from("^`line [0-9]+ \"(/[^\n]*)\"", REG_NEWLINE);
    for (const Match& m : from.all(text)) {
      if (std::ranges::find(read_.sources, m[1]) == read_.sources.end()) {
        read_.sources.push_back(m[1]);
      }
    }
    write_text(plain_, with_warnings(text, read_.language.empty() ? Words() : files_));
  }

  // Its warnings.
  std::string lint() {
    const Words options{"--lint-only", "-Wwarn-LATCH", "-Wwarn-UNOPTFLAT", plain_};
    Ran ran = verilator(options);
    // What writes an array with `<=` in a loop must be unrolled; other loops had better not be.
    if (ran.text.find("%Error-BLKLOOPINIT") != std::string::npos) {
      append(read_.verilator, {"--unroll-count", "65536", "--unroll-stmts", "1000000"});
      ran = verilator(options);
    }
    if (ran.status != 0) throw InputError(error_in(ran.text, "Verilator cannot lint it"));
    return ran.text;
  }

  // Reads files .v as Verilog-2005 where Verilator had to, and elaborates.
  std::string commands() const {
    std::string options, files[2], parameters;
    for (const std::string& option : asked_.options) {
      static const Regex parameter("^-G([^=]+)=(.*)$"), text("^\"(.*)\"$");
      const Match given = parameter.find(option);
      if (!given) {
        options += ' ' + option;
        continue;
      }
      std::string value = given[2];
      if (const Match word = text.find(value)) value = bits_of(word[1]);
      parameters += " -chparam " + given[1] + ' ' + value;
    }
    for (const std::string& file : files_) {
      const bool is_old = !read_.language.empty() && file.ends_with(".v");
      files[is_old ? 1 : 0] += " \"" + file + '"';
    }
    std::string all;
    for (const bool is_old : {false, true}) {
      if (files[is_old].empty()) continue;
      all += std::string("read_verilog") + (is_old ? "" : " -sv") + " -defer" + options +
             files[is_old] + "; ";
    }
    return all + "hierarchy -check -top " + asked_.top + parameters + "; proc; flatten; ";
  }
  static std::string bits_of(const std::string& text) {
    constexpr const char* digits = "0123456789abcdef";
    std::string bits = std::to_string(8 * text.size()) + "'h";
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      bits += {digits[byte / 16], digits[byte % 16]};
    }
    return bits;
  }

  // The netlist as JSON; empty where yosys cannot say it in 40 s. There is no loop if yosys finds
  // none even if each bit that a cell gives depends on all that it takes.
  std::filesystem::path netlist() {
    if (asked_.yosys.empty()) return {};
    const std::filesystem::path json = asked_.work / "netlist.json";
    const std::filesystem::path log = asked_.work / "netlist.log";
    const Ran ran =
        yosys(commands() + "scc", {"-l", log.string(), "-b", "json", "-o", json.string()});
    if (ran.status == 0) {
      static const Regex loops("^Found ([0-9]+) SCCs[.]$", REG_NEWLINE);
      const std::string said = text_of(log);
      const std::vector<Match> found = loops.all(said);
      has_no_loop_ = !found.empty() && found.back()[1] == "0";
      is_read_ = true;
      return json;
    }
    static const Regex error("[^\n]*ERROR: [^\n]*");
    const Match said = error.find(ran.text);
    read_.unread = ran.status == 124
                       ? "yosys does not read the RTL in 40 s"
                       : "yosys cannot read the RTL: " + without_folders(said ? said[0] : ran.text);
    return {};
  }

  // Verilator takes nets for whole and sees a loop in any carry chain; yosys looks at each bit.
  void find_loop() {
    const std::filesystem::path log = asked_.work / "loop.log";
    const std::string& first = read_.found.loops.front();
    if (!is_read_ || yosys(commands() + "opt_clean; techmap; opt_clean; scc -select; select -list",
                           {"-l", log.string()})
                             .status != 0) {
      read_.doubt = first;
      return;
    }
    static const Regex found("^Found [0-9]+ SCCs[.]$", REG_NEWLINE),
        listed("^[^ /]+/.*$", REG_NEWLINE), net("^[^ /]+/([^$]*)$", REG_NEWLINE);
    std::string said = text_of(log);
    if (const auto counts = found.all(said); !counts.empty()) said.erase(0, counts.back().end());
    if (const Match m = net.find(said)) throw InputError(m[1] + ": a combinational loop");
    if (listed.find(said)) throw InputError(first + ": a combinational loop");
  }

  const RtlAsked& asked_;
  const Run& run_;
  RtlRead read_;
  std::string plain_;
  Words files_;  // those of RTL
  bool is_read_ = false, has_no_loop_ = false;
};

}  // namespace

std::filesystem::path write_tree(const RtlAsked& asked, const Run& run) {
  RtlReader(asked, run).write_tree();
  return asked.work / "tree";
}

RtlRead read_rtl(const RtlAsked& asked, const Run& run) { return RtlReader(asked, run).take(); }

}  // namespace cosim::rtl
