#include "tb/rtl/names.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "model/core/input_error.h"
#include "tb/rtl/files.h"
#include "tb/rtl/regex.h"

namespace cosim::rtl {
namespace {

namespace fs = std::filesystem;

std::string blank(std::string text) {
  for (char& c : text) c = c == '\n' ? c : ' ';
  return text;
}

// C++ with blanks in place of its comments, strings and characters.
std::string plain(const std::string& text) {
  static const Regex piece(
      "\\w'|\"(\\\\.|[^\"\\\n])*\"|'(\\\\.|[^'\\\n])'|//[^\n]*|/\\*([^*]|\\*+[^*/])*\\*+/");
  return piece.replaced(text, [](const Match& m) {
    return m.size() == 2 && m[0].back() == '\'' ? m[0] : blank(m[0]);
  });
}

// The fewest edits that make y of x.
int edits(const std::string& x, const std::string& y) {
  std::vector<std::vector<int>> d(x.size() + 1, std::vector<int>(y.size() + 1));
  for (std::size_t i = 0; i <= x.size(); ++i) {
    for (std::size_t j = 0; j <= y.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = static_cast<int>(i + j);
        continue;
      }
      d[i][j] = std::min(
          {d[i - 1][j - 1] + (x[i - 1] == y[j - 1] ? 0 : 1), d[i - 1][j] + 1, d[i][j - 1] + 1});
      if (i > 1 && j > 1 && x[i - 1] == y[j - 2] && x[i - 2] == y[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[x.size()][y.size()];
}

std::string small(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

using Names = std::set<std::string>;

// The name that was meant; "" where none was. A name of three letters is meant where one is
// missing, one too many, or one of another case, if there are any so short. Two edits make another
// word of a shorter name than one of ten letters: computed is not compared.
std::string meant(const std::string& name, const Names& known, std::size_t shortest = 4) {
  const auto is_near = [&](const std::string& one) {
    const int most = one.size() < 4 && name.size() == one.size() ? 0 : one.size() < 10 ? 1 : 2;
    return one.size() >= shortest && edits(small(name), small(one)) <= most;
  };
  const auto one =
      known.contains(name) ? known.end() : std::find_if(known.begin(), known.end(), is_near);
  return one == known.end() ? "" : *one;
}

struct Text {
  std::string file, text;
  [[noreturn]] void refuse(std::size_t at, const std::string& what,
                           const std::string& meant) const {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
    throw InputError(file + ':' + std::to_string(1 + std::count(text.begin(), end, '\n')) + ": " +
                     what + " means nothing: is " + meant + " meant?");
  }
};

// What each kind of struct may have.
struct StructNames {
  Names clocks, streams, driver;
};

// Looks at the functions, the types and the constants of a struct that has In, that names a stream,
// or that drives one: at its other members, which have any name, it does not.
void check_struct(const Text& of, const StructNames& names) {
  static const Regex model("\\bstruct\\s+(\\w+)[^;{()]*\\{");
  static const Regex has_in("\\bstruct\\s+In\\b"), has_stream("\\bstream\\s*<");
  static const Regex driven("\\bstream\\s*<\\s*[A-Za-z0-9_:]+\\s*,\\s*([A-Za-z0-9_:]+)\\s*>");
  Names drivers;
  for (const Match& m : driven.all(of.text)) drivers.insert(m[1]);
  static const Regex member(
      "\\bstruct\\s+(\\w+)|\\bstatic\\s+constexpr\\b[^;={]*\\b(\\w+)\\s*[={]|(\\w+)\\s*\\(");
  for (const Match& m : model.all(of.text)) {
    std::string body;
    int depth = 0;
    std::size_t at = m.end();
    for (; at < of.text.size() && depth >= 0; ++at) {
      const char c = of.text[at];
      if (c == '}' || c == ')') --depth;
      body += depth == 0 || c == '\n' ? c : ' ';
      if (c == '{' || c == '(') ++depth;
    }
    const bool streams = bool(has_stream.find(of.text.substr(m.end(), at - m.end())));
    Names known = streams ? names.streams : Names();
    if (has_in.find(body)) known.insert(names.clocks.begin(), names.clocks.end());
    if (drivers.contains(m[1])) known = names.driver;
    Names types, others;
    for (const std::string& one : known) {
      (std::isupper(static_cast<unsigned char>(one.front())) != 0 ? types : others).insert(one);
    }
    for (const Match& one : member.all(body)) {
      const std::string name = one[1] + one[2] + one[3];
      const std::string is = meant(name, one[1].empty() ? others : types, streams ? 3 : 4);
      if (!is.empty()) of.refuse(m.end() + one.begin(), name + " in struct " + m[1], is);
    }
  }
}

struct Checked {
  fs::path root;
  Names met = {};
  StructNames of_struct = {};
  std::string read = {};  // the files, as ninja wants them

  void learn(const fs::path& folder) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() != ".h") continue;
      const std::string text = text_of(entry.path());
      static const Regex said("\\b(m\\.|M::|First::|Model::)([A-Za-z]\\w+)");
      static const Regex of_driver("\\b([Dd]river(::|_?\\.))([A-Za-z]\\w+)");
      const bool is_stream = folder.filename() == "stream";
      Names& names = is_stream ? of_struct.streams : of_struct.clocks;
      for (const Match& m : said.all(text)) names.insert(m[2]);
      for (const Match& m : of_driver.all(text)) {
        if (is_stream) of_struct.driver.insert(m[3]);
      }
    }
  }
  void check(const fs::path& file) {
    static const Regex include("(^|\n)[ \t]*#[ \t]*include[ \t]*\"([^\"\n]+)\""), odd("[ #]");
    const fs::path path = fs::weakly_canonical(file);
    const auto is_below = [&](const char* folder) {
      return path.string().starts_with((root / folder / "").string());
    };
    if (!met.insert(path).second || is_below("model/core") || is_below("model/clocked") ||
        is_below("tb"))
      return;
    read += ' ' + odd.replaced(path.string(), [](const Match& m) { return '\\' + m[0]; });
    const std::string text = text_of(file);
    for (const Match& m : include.all(text)) {
      for (const fs::path& folder : {path.parent_path(), root}) {
        if (!fs::is_regular_file(folder / m[2])) continue;
        check(folder / m[2]);
        break;
      }
    }
    check_struct({file, plain(text)}, of_struct);
  }
};

}  // namespace

void check_names(const std::string& stamp, const fs::path& root,
                 const std::vector<std::string>& headers) {
  Checked checked{fs::canonical(root)};
  for (const char* folder : {"model/clocked", "tb/stream"}) checked.learn(checked.root / folder);
  for (const std::string& header : headers) checked.check(header);
  write_text(stamp + ".d", stamp + ':' + checked.read + '\n');
  write_text(stamp, "");
}

}  // namespace cosim::rtl
