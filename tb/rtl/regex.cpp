#include "tb/rtl/regex.h"

#include <stdexcept>

namespace cosim::rtl {

Regex::Regex(const std::string& expression, int flags) {
  if (regcomp(&compiled_, expression.c_str(), REG_EXTENDED | flags) != 0) {
    throw std::logic_error(expression);
  }
}

Match Regex::find(std::string_view text, std::size_t from) const {
  Match match;
  match.text_ = text;
  match.groups_.resize(compiled_.re_nsub + 1);
  match.groups_[0] = {static_cast<regoff_t>(from), static_cast<regoff_t>(text.size())};
  if (from > text.size() || regexec(&compiled_, text.data(), match.groups_.size(),
                                    match.groups_.data(), REG_STARTEND) != 0) {
    match.groups_.clear();
  }
  return match;
}

std::vector<Match> Regex::all(std::string_view text) const {
  std::vector<Match> all;
  for (Match match = find(text); match;) {
    all.push_back(match);
    match = find(text, match.end() + (match.size() == 0 ? 1 : 0));
  }
  return all;
}

std::string Regex::replaced(std::string_view text,
                            const std::function<std::string(const Match&)>& by) const {
  std::string made;
  std::size_t from = 0;
  for (const Match& match : all(text)) {
    made += text.substr(from, match.begin() - from);
    made += by(match);
    from = match.end();
  }
  return made.append(text.substr(from));
}

std::string Regex::replaced(std::string_view text, std::string_view by) const {
  return replaced(text, [&](const Match& match) {
    std::string made;
    for (std::size_t i = 0; i < by.size(); ++i) {
      if (by[i] == '\\') {
        made += match[static_cast<std::size_t>(by[++i] - '0')];
      } else {
        made += by[i];
      }
    }
    return made;
  });
}

}  // namespace cosim::rtl
