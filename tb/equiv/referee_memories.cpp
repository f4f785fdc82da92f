#include "tb/equiv/referee_memories.h"

#include <fmt/core.h>

#include <algorithm>

#include "tb/util/output_file.h"
#include "tb/util/random.h"

namespace cosim::equiv {

void RefereeMemories::add_to(Stimulus& s) {
  constexpr std::size_t most = 4096;
  std::size_t number = 0;
  Random random = Random::for_case(1631518, 3);
  for (const Cell& cell : side_.module().cells) {
    if (!cell.is_memory()) continue;
    Contents one{cell.name, cell.number("OFFSET"), cell.number("SIZE"), ""};
    const std::size_t width = cell.number("WIDTH");
    const std::string& init = cell.parameter("INIT");
    number_of_[cell.name] = number++;
    if (one.words > most || cell.name.front() == '$') continue;
    std::string text, &all = contents_[cell.name];
    for (std::size_t w = 0; w < one.words; ++w) {
      std::string word;
      for (std::size_t i = width; i-- > 0;) {
        const std::size_t at = w * width + i;
        word += at < init.size() ? init[init.size() - 1 - at] : 'x';
      }
      if (word.find_first_not_of('x') == std::string::npos) {
        for (char& digit : word) digit = random.below(2) == 0 ? '0' : '1';
        text += fmt::format("@{:x} {}\n", w + one.low, word);
      }
      all.append(word.rbegin(), word.rend());
    }
    if (!text.empty()) {
      one.file = (files_.path() / fmt::format("memory{}", number)).string();
      write_file(one.file, text);
    }
    s.memories.push_back(std::move(one));
  }
}

std::string RefereeMemories::begin(const Contents& one, const Simulated& ran,
                                   Stepped& stepped) const {
  const std::size_t number = number_of_.at(one.name);
  const Cell& cell = *std::ranges::find(side_.module().cells, one.name, &Cell::name);
  const std::string& init = cell.parameter("INIT");
  const std::size_t width = cell.number("WIDTH");
  const auto at = ran.memories.find(one.name);
  if (at == ran.memories.end()) return "";
  for (std::size_t w = 0; w < at->second.size(); ++w) {
    for (std::size_t i = 0; i < width && i < at->second[w].size(); ++i) {
      const std::size_t bit = w * width + i;
      const char says = bit < init.size() ? init[init.size() - 1 - bit] : 'x';
      const char is = at->second[w][at->second[w].size() - 1 - i];
      if (is_known(is) != is_known(says) || (is_known(is) && is != says)) {
        return fmt::format("word {} of memory {} begins as {}, and {} reads another value",
                           w + one.low, one.name, at->second[w], name_of(side_.front_end()));
      }
    }
  }
  stepped.begin_memory(number, contents_.at(one.name));
  return "";
}

}  // namespace cosim::equiv
