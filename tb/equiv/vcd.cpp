#include "tb/equiv/vcd.h"

#include <algorithm>

namespace cosim::equiv {
namespace {

// "1ps", or in two words.
std::uint64_t picoseconds(const std::string& text) {
  constexpr std::uint64_t thousand = 1000;
  const std::uint64_t number = std::stoull(text);
  const std::string unit = text.substr(text.find_first_not_of("0123456789"));
  std::uint64_t ticks = number;
  for (const char* one : {"ps", "ns", "us", "ms"}) {
    if (unit == one) return ticks;
    ticks *= thousand;
  }
  return number;
}

}  // namespace

Vcd::Vcd(const std::string& text, const std::string& from, const std::string& name) : in_(text) {
  header(from, name);
}

void Vcd::header(const std::string& from, const std::string& name) {
  std::vector<std::string> scope;
  for (std::string word; in_ >> word && word != "$enddefinitions";) {
    std::vector<std::string> words;
    for (std::string more; in_ >> more && more != "$end";) words.push_back(more);
    if (word == "$timescale" && !words.empty()) {
      tick_ = picoseconds(words.size() == 1 ? words[0] : words[0] + words[1]);
    } else if (word == "$scope" && words.size() == 2) {
      scope.push_back(words[1]);
    } else if (word == "$upscope" && !scope.empty()) {
      scope.pop_back();
    } else if (word == "$var" && words.size() >= 4 && words[0] != "real") {
      const auto at = std::ranges::find(scope, from);
      if (at == scope.end()) continue;
      const int width = std::stoi(words[1]);
      Value& value = values_[words[2]];
      value.width = std::max(width, value.width);
      value.bytes.resize((static_cast<std::size_t>(value.width) + 7) / 8);
      Signal signal;
      signal.scope = {name};
      signal.scope.insert(signal.scope.end(), at + 1, scope.end());
      signal.name = words[3];
      signal.width = width;
      if (words.size() > 4) signal.range = words[4];
      signal.bytes = value.bytes.data();
      signals_.push_back(std::move(signal));
    }
  }
  std::string end;
  in_ >> end;
}

void Vcd::go_to(std::uint64_t ps) {
  while (now_ < ps) {
    std::string word;
    if (!(in_ >> word)) return;
    if (word.front() == '#') {
      now_ = std::stoull(word.substr(1)) * tick_;
    } else {
      change(word);
    }
  }
}

// "1CODE", or "b0101 CODE".
void Vcd::change(const std::string& word) {
  std::string bits, code;
  if (word.front() == 'b' || word.front() == 'B') {
    bits = word.substr(1);
    in_ >> code;
  } else if (word.front() == 'r') {
    in_ >> code;
    return;
  } else {
    bits = word.substr(0, 1);
    code = word.substr(1);
  }
  const auto at = values_.find(code);
  if (at == values_.end()) return;
  auto& bytes = at->second.bytes;
  std::fill(bytes.begin(), bytes.end(), static_cast<unsigned char>(0));
  for (std::size_t i = 0; i < bits.size() && i < 8 * bytes.size(); ++i) {
    if (bits[bits.size() - 1 - i] == '1') bytes[i / 8] |= static_cast<unsigned char>(1U << i % 8);
  }
}

}  // namespace cosim::equiv
