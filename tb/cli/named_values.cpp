#include "tb/cli/named_values.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim::cli {

using Values = std::vector<std::pair<std::string, std::string>>;

Values named_values(const std::string& option, const std::vector<std::string>& words) {
  Values all;
  for (const std::string& word : words) {
    const std::size_t at = std::min(word.find('='), word.size());
    const std::string name = word.substr(0, at);
    if (name.empty() || at + 1 == word.size()) {
      throw InputError(fmt::format("{}: {} lacks a {}", option, in_quotes(word),
                                   name.empty() ? "name" : "value"));
    }
    const std::string value = at < word.size() ? word.substr(at + 1) : "";
    const auto known = std::ranges::find(all, name, &Values::value_type::first);
    if (known == all.end()) {
      all.emplace_back(name, value);
    } else if (known->second != value) {
      throw InputError(fmt::format("{}: {} is given twice, as {} and as {}", option,
                                   in_quotes(name), in_quotes(known->second), in_quotes(value)));
    }
  }
  return all;
}

Values named_values(const std::string& option, const std::vector<std::string>& words,
                    const char* form) {
  for (const std::string& word : words) {
    const std::size_t at = word.find('=');
    if (at == std::string::npos || at == 0 || at + 1 == word.size()) {
      throw InputError(fmt::format("{}: {} is not {}", option, in_quotes(word), form));
    }
  }
  return named_values(option, words);
}

}  // namespace cosim::cli
