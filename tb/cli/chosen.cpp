#include "tb/cli/chosen.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

bool has(const AnyBench& bench, const std::string& word) {
  if (bench.view() == word) return true;
  const auto all = bench.parameters();
  return std::ranges::any_of(
      all, [&](const Parameter& p) { return fmt::format("{}={}", p.name, p.value) == word; });
}

bool something_was_left_out = false;

}  // namespace

void leave_out(const std::string& line) {
  complain(line);
  something_was_left_out = true;
}

bool was_left_out() { return something_was_left_out; }

std::vector<const AnyBench*> chosen_benches(const std::vector<std::string>& given) {
  // A line of `list` may be one word of the shell, in quotes.
  const auto words = words_in(fmt::format("{}", fmt::join(given, " ")));
  std::vector<const AnyBench*> found;
  if (words.empty()) {
    for (const Unusable& design : unusable()) leave_out(design.why);
  }
  for (const auto& bench : benches()) {
    const bool same =
        words.empty() || (bench->design() == words.front() &&
                          std::all_of(words.begin() + 1, words.end(),
                                      [&](const std::string& word) { return has(*bench, word); }));
    if (same) found.push_back(bench.get());
  }
  if (found.empty()) {
    throw InputError(fmt::format("{} is not built; see {} list",
                                 in_quotes(fmt::format("{}", fmt::join(words, " "))),
                                 program_name()));
  }
  return found;
}

std::vector<const AnyBench*> chosen_shapes(const std::vector<std::string>& words) {
  std::vector<const AnyBench*> all = chosen_benches(words);
  const auto same = [](const AnyBench* a, const AnyBench* b) {
    return a->built_as() == b->built_as();
  };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

std::pair<const AnyBench*, std::size_t> bench_before(const std::vector<std::string>& words) {
  if (words.empty()) throw InputError("DESIGN: is needed");
  const auto parameters = chosen_benches({words.front()}).front()->parameters();
  const auto end = std::find_if_not(words.begin() + 1, words.end(), [&](const std::string& word) {
    return std::ranges::any_of(parameters, [&](const Parameter& p) {
      return word.starts_with(std::string(p.name) + '=');
    });
  });
  return {chosen_benches({words.begin(), end}).front(),
          static_cast<std::size_t>(end - words.begin())};
}

}  // namespace cosim::cli
