// Regular expressions of libc, as `grep -E` has them, with `\w`, `\s` and `\b`. Unlike those of the
// C++ library they compile in no time and match a text of any length.
#pragma once

#include <regex.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cosim::rtl {

/// One match in a text, which it does not keep. Group 0 is the whole match.
class Match {
 public:
  explicit operator bool() const { return !groups_.empty(); }
  bool has(std::size_t group) const { return groups_[group].rm_so >= 0; }
  std::size_t begin(std::size_t group = 0) const { return place(groups_[group].rm_so); }
  std::size_t end(std::size_t group = 0) const { return place(groups_[group].rm_eo); }
  std::size_t size(std::size_t group = 0) const { return end(group) - begin(group); }
  /// "" where the group takes no part in the match.
  std::string operator[](std::size_t group) const {
    return has(group) ? std::string(text_.substr(begin(group), size(group))) : "";
  }

 private:
  friend class Regex;
  static std::size_t place(regoff_t at) { return static_cast<std::size_t>(at); }

  std::string_view text_;
  std::vector<regmatch_t> groups_;
};

class Regex {
 public:
  /// `flags`: REG_ICASE, and REG_NEWLINE: `^` and `$` are ends of lines, and only `\n` and `\s`
  /// match what ends one.
  explicit Regex(const std::string& expression, int flags = 0);
  ~Regex() { regfree(&compiled_); }
  Regex(const Regex&) = delete;
  Regex& operator=(const Regex&) = delete;

  /// The first match that begins at `from` or behind it, the longest one there.
  Match find(std::string_view text, std::size_t from = 0) const;
  /// All matches, each behind the one before.
  std::vector<Match> all(std::string_view text) const;
  /// The text with `by` of each match in its place.
  std::string replaced(std::string_view text,
                       const std::function<std::string(const Match&)>& by) const;
  /// With `by` in their place, in which `\1` to `\9` are groups of the match.
  std::string replaced(std::string_view text, std::string_view by) const;

 private:
  regex_t compiled_;
};

}  // namespace cosim::rtl
