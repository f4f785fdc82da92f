#include "tb/equiv/yosys_messages.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "tb/util/pattern.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

struct Place {
  std::string file;
  int line = 0;  // 0: not known
};

// A word of yosys's grammar as a person writes or calls it.
std::string token(const std::string& word) {
  static const std::map<std::string, std::string> words{
      {"TOK_ID", "a name"},
      {"TOK_CONSTVAL", "a number"},
      {"TOK_REALVAL", "a real number"},
      {"TOK_STRING", "a string"},
      {"TOK_SVA_LABEL", "a label"},
      {"TOK_BASE", "a base"},
      {"invalid token", "a character that Verilog does not have"},
      {"end of file", "the end of the file"}};
  if (const auto known = words.find(word); known != words.end()) return known->second;
  static const Pattern keyword("(?:TOK|OP)_(\\w+)");
  const Pattern::Parts part = keyword.whole(word);
  if (part.empty()) return word;
  std::string small = part[1];
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
  return "'" + small + "'";
}

// "syntax error, unexpected TOK_ID, expecting ',' or ';'"
std::string syntax_error(const std::string& message) {
  static const Pattern form("syntax error(?:, unexpected (.+?))?(?:, expecting (.+))?");
  const Pattern::Parts part = form.whole(message);
  if (part.empty()) return "";
  std::string text = "syntax error";
  if (!part[1].empty()) text += ": " + token(part[1]) + " is not expected";
  std::string wanted;
  for (std::size_t at = 0; at < part[2].size();) {
    const std::size_t end = std::min(part[2].find(" or ", at), part[2].size());
    wanted += (wanted.empty() ? "" : " or ") + token(part[2].substr(at, end - at));
    at = end + 4;
  }
  return text + (wanted.empty() ? "" : ", but " + wanted);
}

// Without the marks that yosys puts at names, and without names that are its own.
std::string plain_names(std::string text) {
  static const std::vector<std::pair<Pattern, std::string>> marks{
      {Pattern(R"(\$paramod\$[0-9a-f]+\\([\w$]+))"), "$1"},
      {Pattern(R"(\$paramod\\([\w$]+)(\\[\w$]+=\w*'\w*)*)"), "$1"},
      {Pattern(R"(\$abstract\\)"), ""},
      {Pattern(R"(`([^'` ]*)['`])"), "$1"},
      {Pattern(R"(\$\d+\\\S*)"), "a signal without a name"},
      {Pattern(R"(\\(?=\S))"), ""},
      {Pattern(R"(\b\d+'m?\b)"), "a value"},
      {Pattern(R"([\w.]*\$\w*\$[^ ]*:(\d+)\$\d+(_\w+)?)"), "an expression of line $1"},
      {Pattern(R"(\$(auto|procmux|procdff|flatten)\$\S*)"), "a signal without a name"},
      {Pattern(R"( (in|at) (frontends|kernel|passes|backends)/\S+)"), ""}};
  for (const auto& [pattern, by] : marks) text = pattern.replaced(text, by);
  return text;
}

// What yosys printed, and what is known of where it was.
class Said {
 public:
  explicit Said(const std::string& text) {
    std::istringstream in(text);
    bool is_over = false;
    for (std::string line; std::getline(in, line);) {
      constexpr std::size_t longest = 4000;
      line.resize(std::min(line.size(), longest));
      if (is_over) {
        after_.push_back(line);
      } else if (const std::size_t at = line.find("ERROR: "); at != std::string::npos) {
        is_over = true;
        error = line.substr(at + 7);
        if (at > 0) prefix(line.substr(0, at));
      } else {
        before(line);
      }
    }
    static const Pattern process("using process `(.*)'");
    // A warning may be all that is said before a crash.
    static const Pattern tells("Async reset value .*|found logic loop .*");
    if (error.empty() && !tells.whole(warning_).empty()) {
      error = warning_;
      last_ = warned_at_;
      signal = warned_of_;
      module = warned_in_;
    }
    const auto all = process.all(last_);
    if (!all.empty() && resets_.contains(all.front()[1])) reset = resets_.at(all.front()[1]) + ' ';
    module = plain_names(module);
    find_place();
    if (real_at_.file != place.file || real_at_.line != place.line) real.clear();
  }

  std::string error;  // "" where it only ended
  Place place;
  std::string module, signal;  // that it was at
  std::string reset;           // the asynchronous one of the signal, with a blank
  std::string real;            // a real number that it took for a whole one, there
  bool is_in_hierarchy = false;
  bool is_of_top = false;  // of what the command line gives the top

 private:
  static bool take(const Pattern& pattern, const std::string& line, Place& to) {
    const auto all = pattern.all(line);
    if (all.empty()) return false;
    to = {all.front()[1], std::atoi(all.front()[2].c_str())};
    return true;
  }

  // "FILE:LINE: "
  void prefix(const std::string& text) {
    static const Pattern form("(.+):(\\d+): ");
    const Pattern::Parts part = form.whole(text);
    if (part.empty()) return;
    is_of_top = part[1] == "input";
    if (!is_of_top) place = {part[1], std::atoi(part[2].c_str())};
  }

  void before(const std::string& line) {
    static const Pattern converts("(.+):(\\d+): Warning: converting real value (\\S+) to .*");
    static const Pattern quoted("[^`]*`(.*)'[^`']*");
    static const Pattern resets("Found async reset \\\\?(\\S+) in `(.*)'\\.");
    static const Pattern registered(
        "Creating (?:register|latch) for signal `.*\\.\\\\?(\\S+)' using process `.*'\\.");
    if (const std::size_t at = line.find("Warning: "); at != std::string::npos) {
      warning_ = line.substr(at + 9);
      warned_at_ = last_;
      warned_of_ = signal;
      warned_in_ = module;
      if (const auto part = converts.whole(line); !part.empty()) {
        real = fmt::format("{}", std::strtod(part[3].c_str(), nullptr));
        real_at_ = {part[1], std::atoi(part[2].c_str())};
      }
      return;
    }
    if (line.empty()) return;
    last_ = line;
    signal.clear();
    const auto is = [&](const char* begin) { return line.starts_with(begin); };
    const auto name = [&] {
      const auto part = quoted.whole(line);
      return part.empty() ? "" : part[1];
    };
    if (is("Generating RTLIL representation")) {
      module = name();
      const bool is_techmap = module.starts_with("\\_") || module.starts_with("\\$");
      if (is_techmap) module.clear();
    } else if (is("Parsing ")) {
      file_ = name();
    } else if (is("Storing AST representation")) {
      files_[plain_names(name())] = file_;
    } else if (is("Successfully finished")) {
      file_.clear();
    } else if (is("Creating ")) {
      if (const auto part = registered.whole(line); !part.empty()) signal = part[1];
    } else if (is("Found async reset")) {
      if (const auto part = resets.whole(line); !part.empty()) resets_[part[2]] = part[1];
    } else if (line.find(". Executing ") != std::string::npos &&
               line.find(" AST ") == std::string::npos) {
      is_in_hierarchy = line.find(" HIERARCHY ") != std::string::npos;
    }
  }

  void find_place() {
    static const Pattern src("\\\\src \"([^\"|]+):(\\d+)\\.");
    static const Pattern own("\\$\\w*\\$([^$]+):(\\d+)\\$\\d+");
    if (place.line > 0) return;
    for (const std::string& line : after_) {
      if (take(src, line, place)) return;
    }
    if (take(own, error, place) || take(own, last_, place)) return;
    if (place.file.empty()) place.file = file_;
    if (const auto at = files_.find(module);
        place.file.empty() && !is_of_top && at != files_.end()) {
      place.file = at->second;
    }
  }

  Place real_at_;
  std::string last_, file_, warning_, warned_at_, warned_of_, warned_in_;
  std::map<std::string, std::string> resets_, files_;  // by processes, and by modules
  std::vector<std::string> after_;
};

// What is wrong in words of ours; the message itself where no rule fits.
std::string by_rules(const std::string& error, const Said& said) {
  const std::string message = plain_names(error);
  for (const Rule& rule : yosys_rules()) {
    if (rule.pattern.whole(message).empty()) continue;
    std::string text = rule.pattern.replaced(message, rule.text);
    const std::string signal = said.signal.empty() ? "a register" : "register " + said.signal;
    if (text.starts_with("{signal}")) text.replace(0, 8, signal);
    if (const std::size_t at = text.find("{reset}"); at != std::string::npos) {
      text.replace(at, 7, said.reset);
    }
    return text;
  }
  std::string text = message;
  while (text.ends_with('!') || text.ends_with('.')) text.pop_back();
  return text;
}

// It says nothing.
std::string of_a_crash(const Said& said, int status) {
  constexpr int of_signal = 128;
  if (status < of_signal) return "yosys ends without a reason";
  if (!said.is_in_hierarchy && !said.module.empty()) return "yosys crashes";
  return fmt::format("yosys crashes: does {} have itself in it?",
                     said.module.empty() ? "a module or a function"
                                         : "module " + said.module + ", or a function in it,");
}

std::string what_of(const Said& said, int status) {
  if (said.error.empty()) return of_a_crash(said, status);
  static const Pattern lacking("Can't find object for defparam `(.*)`!");
  if (const auto part = lacking.whole(said.error); said.is_of_top && !part.empty()) {
    return "the top has no parameter " + part[1];
  }
  if (const std::string text = syntax_error(said.error); !text.empty()) return text;
  static const Pattern internal("Found error in internal cell .* \\(\\$(\\w+)\\) at .*");
  if (const Pattern::Parts part = internal.whole(said.error); !part.empty()) {
    if (!said.real.empty()) return "a real number in an expression, " + said.real;
    return "yosys makes an operator of it that it does not take itself, " + part[1];
  }
  return by_rules(said.error, said);
}

std::string as_a_person_does(const std::string& file, const FileNames& files) {
  for (const auto& [own, name] : files) {
    if (file == own) return name;
    if (!own.empty() && file.starts_with(own + '/')) return name + file.substr(own.size());
  }
  return file;
}

// Text of the source is what a person knows best.
std::string source_line(const std::string& file, int number) {
  constexpr std::size_t longest = 60;
  std::ifstream in(file);
  std::string line;
  for (int i = 0; i < number && std::getline(in, line);) ++i;
  static const Pattern around("^\\s+|\\s+$"), newer(
                                                  "\\b(logic|bit|int|byte|always_(ff|comb|latch)|"
                                                  "typedef|struct|enum|import|package|interface|"
                                                  "unique|inside)\\b");
  if (!in || line.size() > 1000) return "";
  line = around.replaced(line, "");
  if (line.empty()) return "";
  const bool is_newer = file.ends_with(".v") && newer.in(line);
  return fmt::format(": {}{}{}", line.substr(0, longest), line.size() > longest ? "..." : "",
                     is_newer ? " (SystemVerilog is read from files .sv)" : "");
}

}  // namespace

std::string yosys_message(const std::string& text, int status, const FileNames& files) {
  const Said said(text);
  std::string what = what_of(said, status);
  const std::string file = as_a_person_does(said.place.file, files);
  if (what.starts_with("syntax error")) what += source_line(file, said.place.line);
  const bool names_module = what.find("odule") != std::string::npos || said.is_of_top;
  if (said.place.line == 0 && !said.module.empty() && !names_module) {
    what.insert(0, "in module " + said.module + ": ");
  }
  // A file may be named behind the place, too.
  for (const auto& [own, name] : files) {
    for (std::size_t at = 0; !own.empty() && (at = what.find(own, at)) != std::string::npos;
         at += name.size()) {
      what.replace(at, own.size(), name);
    }
  }
  const std::string line = said.place.line > 0 ? fmt::format(":{}", said.place.line) : "";
  return one_line((file.empty() ? "" : file + line + ": ") + what);
}

}  // namespace cosim::equiv
