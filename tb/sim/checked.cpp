#include "tb/sim/checked.h"

#include <algorithm>
#include <stdexcept>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

struct Shown {
  const std::string& unit;
  std::string operator()(std::uint64_t value) const { return count(value, unit); }
  std::string operator()(double value) const { return amount(value, unit); }
};

struct Add {
  const Measure& one;
  template <class Value>
  void operator()(Value& value) const {
    const Value other = std::get<Value>(one.value);
    value = one.sum == Measure::Sum::total ? value + other : std::max(value, other);
  }
};

void add_measure(Measure& sum, const Measure& one) {
  if (sum.sum != one.sum || sum.value.index() != one.value.index()) {
    throw InputError("the measure " + in_quotes(sum.name) + " is taken in two ways");
  }
  std::visit(Add{one}, sum.value);
}

}  // namespace

std::string to_text(const Measure& measure) {
  return measure.title + (measure.title.empty() ? "" : " ") +
         std::visit(Shown{measure.unit}, measure.value);
}

const Measure& Checked::measure(std::string_view name) const {
  const auto at = std::ranges::find(measures, name, &Measure::name);
  if (at == measures.end()) throw std::out_of_range("no measure " + std::string(name));
  return *at;
}

std::uint64_t Checked::count(std::string_view name) const {
  return std::get<std::uint64_t>(measure(name).value);
}

double Checked::number(std::string_view name) const {
  return std::get<double>(measure(name).value);
}

void add(Checked& sum, const Checked& one) {
  sum.jobs += one.jobs;
  if (sum.error.empty()) sum.error = one.error;
  for (const Measure& measure : one.measures) {
    const auto at = std::ranges::find(sum.measures, measure.name, &Measure::name);
    if (at == sum.measures.end()) {
      sum.measures.push_back(measure);
    } else {
      add_measure(*at, measure);
    }
  }
}

}  // namespace cosim
