#include "tb/rtl/file_list.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

#include "model/core/input_error.h"
#include "tb/rtl/files.h"

namespace cosim::rtl {
namespace {

namespace fs = std::filesystem;

// What says nothing of the RTL, by its beginning.
constexpr std::array ignored{
    "-sv",      "-sverilog", "--sv",        "-g20",         "+libext+", "+systemverilogext+",
    "+verilog", "+v2k",      "-timescale=", "--timescale=", "-W",       "--timing",
    "-full64",  "+lint=",    "--lint-only"};

struct Word {
  std::string text;
  int line;
};

class Reader {
 public:
  /// `within`: the lists that are being read, the outermost first; `folder`: where paths begin.
  Reader(std::vector<fs::path> within, fs::path list, fs::path folder, const Place& place,
         FileList& all)
      : open_(std::move(within)),
        list_(std::move(list)),
        folder_(std::move(folder)),
        place_(place),
        all_(all) {}

  void read() {
    if (std::ranges::find(open_, list_) != open_.end()) {
      throw InputError(list_.string() + ": is a list within itself");
    }
    const auto at = place_(list_);
    if (!at) throw InputError(list_.string() + ": no such list of files");
    open_.push_back(list_);
    all_.lists.push_back(*at);
    part(text_of(*at, list_.string()));
    for (at_ = 0; at_ < words_.size(); ++at_) take(words_[at_].text);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    const int line = words_[std::min(at_, words_.size() - 1)].line;
    throw InputError(list_.string() + ':' + std::to_string(line) + ": " + what);
  }

  void part(const std::string& text) {
    int line = 1;
    const auto skip_to = [&](std::size_t& i, const std::string& end) {
      const std::size_t to = std::min(text.find(end, i), text.size());
      line += static_cast<int>(
          std::count(text.begin() + std::ptrdiff_t(i), text.begin() + std::ptrdiff_t(to), '\n'));
      i = to;
    };
    for (std::size_t i = 0; i < text.size();) {
      if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
        line += text[i++] == '\n';
      } else if (text[i] == '#' || text.compare(i, 2, "//") == 0) {
        skip_to(i, "\n");
      } else if (text.compare(i, 2, "/*") == 0) {
        skip_to(i, "*/");
        i = std::min(i + 2, text.size());
      } else {
        Word word{"", line};
        bool is_quoted = false;
        for (; i < text.size(); ++i) {
          const bool is_blank = std::isspace(static_cast<unsigned char>(text[i])) != 0;
          if (text[i] == '\n' || (is_blank && !is_quoted)) break;
          if (text[i] == '"') {
            is_quoted = !is_quoted;
          } else {
            word.text += text[i];
          }
        }
        words_.push_back(std::move(word));
      }
    }
  }

  // With the variables of the environment in it.
  std::string filled(const std::string& text) const {
    std::string all;
    for (std::size_t i = 0; i < text.size();) {
      if (text[i] != '$' || i + 1 == text.size()) {
        all += text[i++];
        continue;
      }
      const char close = text[i + 1] == '{' ? '}' : text[i + 1] == '(' ? ')' : '\0';
      const std::size_t from = i + (close != '\0' ? 2 : 1);
      std::size_t to = from;
      while (to < text.size() &&
             (std::isalnum(static_cast<unsigned char>(text[to])) != 0 || text[to] == '_')) {
        ++to;
      }
      const std::string name = text.substr(from, to - from);
      if (name.empty() || (close != '\0' && (to == text.size() || text[to] != close))) {
        refuse("'" + text + "' names no variable behind its $");
      }
      const char* const value = std::getenv(name.c_str());
      if (value == nullptr) refuse("the variable " + name + " of the environment is not set");
      all += value;
      i = to + (close != '\0' ? 1 : 0);
    }
    return all;
  }

  fs::path path(const std::string& text) const {
    return (folder_ / filled(text)).lexically_normal();
  }
  std::string there(const std::string& text) const {
    const fs::path named = path(text);
    if (const auto at = place_(named)) return *at;
    const bool is_beside =
        place_((list_.parent_path() / filled(text)).lexically_normal()).has_value();
    refuse(named.string() + ": no such file" +
           (is_beside ? "; -F takes paths from the folder of the list" : ""));
  }
  void include(const std::string& folder) {
    if (const auto at = place_(path(folder))) all_.include_dirs.push_back(*at);
  }

  // The word behind an option.
  std::string next(const std::string& option) {
    if (at_ + 1 == words_.size()) refuse("no value after " + option);
    return words_[++at_].text;
  }
  // The parts of +incdir+A+B and the like.
  static std::vector<std::string> parts(const std::string& text) {
    std::vector<std::string> all;
    for (std::size_t from = text.find('+', 1) + 1; from <= text.size();) {
      const std::size_t to = std::min(text.find('+', from), text.size());
      if (to > from) all.push_back(text.substr(from, to - from));
      from = to + 1;
    }
    return all;
  }

  void take(const std::string& word) {
    if (word.empty()) return;
    if (word == "-f" || word == "-F") {
      const fs::path list = path(next(word));
      Reader(open_, list, word == "-F" ? list.parent_path() : folder_, place_, all_).read();
    } else if (word == "-y" || word == "-v") {
      all_.libraries.push_back(there(next(word)));
    } else if (word.starts_with("+incdir+")) {
      for (const std::string& folder : parts(word)) include(folder);
    } else if (word.starts_with("+define+")) {
      for (const std::string& define : parts(word)) all_.defines.push_back(filled(define));
    } else if (word == "-I" || word == "-incdir") {
      include(next(word));
    } else if (word == "-D" || word == "-define") {
      all_.defines.push_back(filled(next(word)));
    } else if (word.starts_with("-I")) {
      include(word.substr(2));
    } else if (word.starts_with("-D")) {
      all_.defines.push_back(filled(word.substr(2)));
    } else if (word == "-top" || word == "--top" || word == "--top-module") {
      all_.top = next(word);
    } else if (word == "-timescale" || word == "--timescale") {
      next(word);
    } else if (word.front() == '-' || word.front() == '+') {
      const auto begins = [&](const char* with) { return word.starts_with(with); };
      if (std::ranges::none_of(ignored, begins))
        refuse("'" + word + "' is not understood in a list of files");
    } else {
      all_.files.push_back(there(word));
    }
  }

  std::vector<fs::path> open_;
  fs::path list_, folder_;
  const Place& place_;
  FileList& all_;
  std::vector<Word> words_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<std::string> place_today(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return std::nullopt;
  return path.string();
}

bool is_file_list(const fs::path& file) { return file.extension() == ".f"; }

void read_file_list(const fs::path& list, bool has_own_folder, const Place& place, FileList& all) {
  Reader({}, list, has_own_folder ? list.parent_path() : "", place, all).read();
}

std::vector<std::string> with_defines(const std::vector<std::string>& listed,
                                      const std::vector<std::string>& typed) {
  const auto name = [](const std::string& define) { return define.substr(0, define.find('=')); };
  std::vector<std::string> all;
  for (const auto* defines : {&listed, &typed}) {
    for (const std::string& define : *defines) {
      std::erase_if(all, [&](const std::string& other) { return name(other) == name(define); });
      all.push_back(define);
    }
  }
  return all;
}

}  // namespace cosim::rtl
