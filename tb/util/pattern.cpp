#include "tb/util/pattern.h"

#include <regex>

namespace cosim {

struct Pattern::Compiled {
  std::regex regex;
};

namespace {

template <class Match>
Pattern::Parts parts_of(const Match& match) {
  Pattern::Parts parts;
  for (const auto& part : match) parts.push_back(part.str());
  return parts;
}

}  // namespace

Pattern::Pattern(const std::string& expression)
    : compiled_(std::make_shared<const Compiled>(Compiled{std::regex(expression)})) {}

Pattern::Parts Pattern::whole(const std::string& text) const {
  std::smatch match;
  if (!std::regex_match(text, match, compiled_->regex)) return {};
  return parts_of(match);
}

std::vector<Pattern::Parts> Pattern::all(const std::string& text) const {
  std::vector<Parts> all;
  for (std::sregex_iterator i(text.begin(), text.end(), compiled_->regex), end; i != end; ++i) {
    all.push_back(parts_of(*i));
  }
  return all;
}

bool Pattern::in(const std::string& text) const {
  return std::regex_search(text, compiled_->regex);
}

std::string Pattern::replaced(const std::string& text, const std::string& by) const {
  return std::regex_replace(text, compiled_->regex, by);
}

}  // namespace cosim
