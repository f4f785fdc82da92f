#include "tb/mismatch.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/core/value.h"

namespace cosim {
namespace {

std::string digits(const Field& field, Word value) {
  return fmt::format("{:0{}b}", static_cast<std::uint64_t>(value), field.width);
}

// Narrow enough for a column: bits for bit strings, else the number.
std::string cell(const Field& field, Word value) {
  switch (field.format) {
    case Format::flag:
    case Format::number:
      return fmt::format("{}", static_cast<std::uint64_t>(value));
    case Format::bits:
      return field.width <= 16 ? digits(field, value)
                               : fmt::format("{:0{}x}", static_cast<std::uint64_t>(value),
                                             (field.width + 3) / 4);
    case Format::twos_complement:
      return fmt::format("{}", from_twos_complement(value, field.width));
    case Format::ones_complement: {
      const Word number = from_ones_complement(value, field.width);
      return number == 0 && value != 0 ? "-0" : fmt::format("{}", number);
    }
    case Format::ones_quarters: {
      const Word number = from_ones_complement(value, field.width);
      const Word size = number < 0 ? -number : number;
      return fmt::format("{}{}.{:02}", bit(value, field.width - 1) ? "-" : "", size / 4,
                         size % 4 * 25);
    }
  }
  return {};
}

const char* letter(Trace::Kind kind) {
  switch (kind) {
    case Trace::Kind::input: return "in ";
    case Trace::Kind::reg: return "reg";
    case Trace::Kind::output: return "out";
  }
  return "";
}

}  // namespace

std::string show(const Field& field, Word value) {
  const std::string number = cell(field, value);
  const std::string bits = digits(field, value);
  return number == bits ? bits : fmt::format("{} ({})", bits, number);
}

std::string to_text(const Mismatch& m) {
  std::string text = fmt::format("first difference: clock {}, {}{}{}\n  expected {}\n  actual   {}\n",
                                 m.clock, m.signal, *m.field.source != '\0' ? ", block " : "",
                                 m.field.source, show(m.field, m.expected), show(m.field, m.actual));

  // Every cell first: a column is as wide as its widest.
  struct Row {
    std::string head;
    std::vector<std::string> cells;
  };
  std::vector<Row> rows{{"clock", {}}};
  const std::size_t clocks = m.traces.empty() ? 0 : m.traces.front().expected.size();
  for (std::size_t c = 0; c < clocks; ++c) {
    const std::uint64_t at = m.first + c;
    rows[0].cells.push_back(at == m.clock ? fmt::format(">{}", at) : fmt::format("{}", at));
  }
  for (const Trace& t : m.traces) {
    const bool same = t.expected == t.actual;
    Row expected{fmt::format("{} {}{}", letter(t.kind), t.field.name, same ? "" : " expected"), {}};
    Row actual{same ? "" : fmt::format("{} {} actual", letter(t.kind), t.field.name), {}};
    for (std::size_t c = 0; c < clocks; ++c) {
      const bool parts = t.expected[c] != t.actual[c];
      expected.cells.push_back(cell(t.field, t.expected[c]));
      actual.cells.push_back(cell(t.field, t.actual[c]) + (parts ? "!" : ""));
    }
    rows.push_back(std::move(expected));
    if (!same) rows.push_back(std::move(actual));
  }
  std::size_t head = 0;
  std::vector<std::size_t> widths(clocks, 0);
  for (const Row& r : rows) {
    head = std::max(head, r.head.size());
    for (std::size_t c = 0; c < clocks; ++c) widths[c] = std::max(widths[c], r.cells[c].size());
  }
  for (const Row& r : rows) {
    text += fmt::format("  {:<{}}", r.head, head);
    for (std::size_t c = 0; c < clocks; ++c) text += fmt::format("  {:>{}}", r.cells[c], widths[c]);
    text += '\n';
  }
  return text;
}

}  // namespace cosim
