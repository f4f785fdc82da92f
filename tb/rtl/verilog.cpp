#include "tb/rtl/verilog.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "model/core/input_error.h"
#include "tb/rtl/files.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"

namespace cosim::rtl {
namespace {

constexpr auto none = std::string_view::npos;

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Reads a text from a place on, without the blanks in front of what it reads.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;

  bool sign(char c) {
    while (at < text.size() && is_blank(text[at])) ++at;
    if (at == text.size() || text[at] != c) return false;
    ++at;
    return true;
  }
  std::string_view word() {
    while (at < text.size() && is_blank(text[at])) ++at;
    const std::size_t from = at;
    while (at < text.size() && is_of_name(text[at])) ++at;
    return text.substr(from, at - from);
  }
  // With its parentheses; empty where there is none.
  std::string_view group() {
    if (!sign('(')) return {};
    const std::size_t from = --at, end = group_end(text, from);
    if (end == none) return {};
    at = end;
    return text.substr(from, end - from);
  }
  std::size_t place(std::string_view of) const {
    return static_cast<std::size_t>(of.data() - text.data());
  }
};

// The places of a word.
std::size_t find_word(std::string_view text, std::string_view word, std::size_t from) {
  for (std::size_t at = from; (at = text.find(word, at)) != none; ++at) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_name(text[at - 1])) && (end == text.size() || !is_of_name(text[end]))) {
      return at;
    }
  }
  return none;
}

}  // namespace

std::string trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

std::vector<Piece> parts(std::string_view list, std::size_t at) {
  std::vector<Piece> all;
  int depth = 0;
  std::size_t from = 0;
  for (std::size_t i = 0; i <= list.size(); ++i) {
    const char c = i < list.size() ? list[i] : ',';
    if (c == '"') {  // no sign of a string ends a part
      std::size_t end = i + 1;
      while (end < list.size() && list[end] != '"') end += list[end] == '\\' ? 2 : 1;
      if (end < list.size()) i = end;
    }
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == ']' || c == '}') --depth;
    if (c != ',' || depth != 0) continue;
    std::size_t begin = from;
    while (begin < i && is_blank(list[begin])) ++begin;
    if (begin < i) all.push_back({trimmed(list.substr(begin, i - begin)), at + begin});
    from = i + 1;
  }
  return all;
}

std::size_t group_end(std::string_view text, std::size_t at) {
  int depth = 0;
  while ((at = text.find_first_of("()", at)) != none) {
    depth += text[at++] == '(' ? 1 : -1;
    if (depth == 0) return at;
  }
  return none;
}

std::string without_comments(std::string_view text) {
  std::string made;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view two = text.substr(at, 2);
    std::size_t end = at + 1;
    if (text[at] == '"') {
      while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
      ++end;
    } else if (two == "//" || two == "/*") {
      made += ' ';
      at = two == "//" ? text.find('\n', at) : text.find("*/", at + 2);
      if (at == none) break;
      if (two == "/*") at += 2;
      continue;
    }
    made += text.substr(at, end - at);
    at = end;
  }
  return made;
}

bool has_word(std::string_view text, const std::string& word) {
  return find_word(text, word, 0) != none;
}

Head head_of(const Module& module) {
  Head head;
  head.flat = module.body;
  for (std::size_t at = 0;;) {
    const std::size_t task = find_word(head.flat, "task", at);
    const std::size_t function = find_word(head.flat, "function", at);
    at = std::min(task, function);
    if (at == none) break;
    const std::size_t end =
        std::min(find_word(head.flat, "endtask", at), find_word(head.flat, "endfunction", at));
    if (end == none) break;
    const std::size_t behind = Cursor{head.flat, end}.word().size() + end;
    for (; at < behind; ++at) head.flat[at] = head.flat[at] == '\n' ? '\n' : ' ';
  }
  Cursor cursor{head.flat};
  for (Cursor next = cursor; next.word() == "import"; next = cursor) {
    cursor.at = std::min(head.flat.find(';', next.at), head.flat.size() - 1) + 1;
  }
  if (cursor.sign('#')) cursor.group();
  const std::string_view list = cursor.group();
  if (!cursor.sign(';')) throw InputError(module.name + ": its ports cannot be read");
  head.end = cursor.at;
  if (list.empty()) return head;
  head.list_end = cursor.place(list) + list.size() - 1;
  head.items = parts(inside(list), cursor.place(list) + 1);
  head.is_ansi = has_word(list, "input") || has_word(list, "output") || has_word(list, "inout");
  return head;
}

std::vector<Instance> instances(const std::string& of, std::string_view flat) {
  std::vector<Instance> all;
  for (std::size_t at = 0; (at = find_word(flat, of, at)) != none;) {
    Instance one;
    one.begin = at;
    Cursor cursor{flat, at += of.size()};
    if (cursor.sign('#')) {
      const std::string_view values = cursor.group();
      if (values.empty()) continue;
      one.has_values = true;
      one.values = {std::string(inside(values)), cursor.place(values) + 1};
    }
    one.name = cursor.word();
    if (cursor.sign('[')) {
      one.is_array = true;
      cursor.at = std::min(flat.find(']', cursor.at), flat.size() - 1) + 1;
    }
    const std::string_view pins = cursor.group();
    if (one.name.empty() || pins.empty() || !cursor.sign(';')) continue;
    one.end = at = cursor.at;
    one.last = cursor.place(pins) + pins.size() - 1;
    one.pins = parts(inside(pins), cursor.place(pins) + 1);
    all.push_back(std::move(one));
  }
  return all;
}

std::vector<Joined> joined(const std::vector<Piece>& pins) {
  static const Regex pin("^\\.\\s*(\\w+)\\s*(\\((.*)\\))?$");
  std::vector<Joined> all;
  for (const Piece& piece : pins) {
    if (const Match m = pin.find(piece.text))
      all.push_back({m[1], trimmed(m.has(2) ? m[3] : m[1])});
  }
  return all;
}

Verilog::Verilog(const std::filesystem::path& folder, const std::vector<std::string>& files)
    : folder_(folder), files_(files), edits_(files.size()) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    texts_.push_back(text_of(folder / files[i], files[i]));
    plain_.push_back(blanked(texts_.back()));
    const std::string& text = plain_.back();
    for (std::size_t at = 0; (at = find_word(text, "module", at)) != none;) {
      Cursor cursor{text, at += 6};
      std::string_view name = cursor.word();
      if (name == "automatic" || name == "static") name = cursor.word();
      const std::size_t end = find_word(text, "endmodule", cursor.at);
      if (name.empty() || end == none) continue;
      at = end;
      modules.try_emplace(std::string(name), Module{std::string(name), i, cursor.at,
                                                    text.substr(cursor.at, end - cursor.at)});
    }
  }
}

bool Verilog::has(const std::string& word) const {
  return std::any_of(plain_.begin(), plain_.end(),
                     [&](const std::string& text) { return has_word(text, word); });
}

void Verilog::edit(const Module& module, std::size_t at, std::size_t length, std::string by) {
  const auto from = module.body.begin() + static_cast<std::ptrdiff_t>(at);
  by.append(
      static_cast<std::size_t>(std::count(from, from + static_cast<std::ptrdiff_t>(length), '\n')),
      '\n');
  edits_[module.file].push_back({module.at + at, length, std::move(by)});
}

std::vector<std::string> Verilog::write(const std::filesystem::path& to, bool marks) const {
  static const Regex include("(`include\\s+\")([^\"/][^\"]*)\"");
  std::vector<std::string> all = files_;
  std::set<std::string> written;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (edits_[i].empty()) continue;
    std::string text = texts_[i];
    std::vector<Edit> edits = edits_[i];
    // The edit that takes text away is behind another one at its place.
    std::stable_sort(edits.begin(), edits.end(), [](const Edit& x, const Edit& y) {
      return x.at != y.at ? x.at > y.at : x.length > y.length;
    });
    for (const Edit& edit : edits) text.replace(edit.at, edit.length, edit.by);
    const std::filesystem::path file = folder_ / files_[i];
    const std::filesystem::path home = std::filesystem::canonical(file).parent_path();
    text = include.replaced(text, [&](const Match& m) {
      return m[1] + (exists(home / m[2]) ? (home / m[2]).string() : m[2]) + '"';
    });
    create_directories(to);
    all[i] = (to / file.filename()).string();
    if (written.contains(all[i]))
      all[i] = (to / (std::to_string(written.size()) + file.filename().string())).string();
    written.insert(all[i]);
    // Messages on a line name the file that the user has.
    if (marks && files_[i].find('"') == std::string::npos)
      text.insert(0, "`line 1 \"" + files_[i] + "\" 0\n");
    write_text(all[i], text);
  }
  return all;
}

}  // namespace cosim::rtl
