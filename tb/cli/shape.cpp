#include "tb/cli/shape.h"

#include <fmt/core.h>

#include <algorithm>

#include "tb/cli/number.h"

namespace cosim::cli {
namespace {

std::string text_of(const std::vector<Parameter>& parameters) {
  std::string text;
  for (const Parameter& p : parameters) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", p.name, to_text(p));
  }
  return text;
}

bool has(const AnyBench& bench, const Parameter& wanted) {
  const auto all = bench.parameters();
  return std::ranges::any_of(all, [&](const Parameter& p) {
    return std::string(p.name) == wanted.name && p.value == wanted.value;
  });
}

bool has_all(const AnyBench& bench, const Shape& shape) {
  return std::ranges::all_of(shape, [&](const Parameter& wanted) { return has(bench, wanted); });
}

}  // namespace

void ShapeOptions::add(const Command& command, const std::string& otherwise) {
  for (std::size_t i = 0; i < options_.size(); ++i) {
    const ShapeOption& o = options_[i];
    command.text(o.option, typed_[i], o.parameter,
                 i == 0 ? fmt::format("{}; default {}", o.help, otherwise) : o.help);
  }
}

Shape ShapeOptions::shape() const {
  constexpr std::uint64_t high = 32;
  Shape shape;
  for (std::size_t i = 0; i < options_.size(); ++i) {
    if (!typed_[i]) continue;
    const ShapeOption& o = options_[i];
    shape.push_back({o.parameter, static_cast<int>(whole(o.option, *typed_[i], o.low, high))});
  }
  return shape;
}

std::vector<const AnyBench*> matching(const std::string& design, const Shape& shape) {
  std::vector<const AnyBench*> found;
  std::string built;
  for (const auto& bench : benches()) {
    if (bench->design() != design) continue;
    built += (built.empty() ? "" : ", ") + text_of(bench->parameters());
    if (has_all(*bench, shape)) found.push_back(bench.get());
  }
  if (found.empty()) {
    throw InputError(
        fmt::format("{} {} was not built; built are {}", design, text_of(shape), built));
  }
  std::stable_sort(found.begin(), found.end(), [](const AnyBench* a, const AnyBench* b) {
    const auto one = a->parameters(), other = b->parameters();
    return !one.empty() && !other.empty() && one.front().value < other.front().value;
  });
  return found;
}

}  // namespace cosim::cli
