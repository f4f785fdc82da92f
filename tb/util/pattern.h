// Regular expressions. The library's own header, which takes long to compile, is read in one place.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace cosim {

class Pattern {
 public:
  /// As ECMAScript writes them.
  explicit Pattern(const std::string& expression);

  /// A match: its text, then that of each group.
  using Parts = std::vector<std::string>;

  /// The match that is all of `text`; empty where there is none.
  Parts whole(const std::string& text) const;
  /// All matches in `text`, one behind the other.
  std::vector<Parts> all(const std::string& text) const;
  /// Whether there is a match in `text`.
  bool in(const std::string& text) const;
  /// `text` with `by` in place of every match; `$1` in it is what the first group holds.
  std::string replaced(const std::string& text, const std::string& by) const;

 private:
  struct Compiled;
  std::shared_ptr<const Compiled> compiled_;
};

}  // namespace cosim
