#include "tb/sim/mismatch.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/util/show.h"

namespace cosim {
namespace {

constexpr std::size_t widest_line = 120;
// Of a table of more rows than this only what changes around the difference is shown.
constexpr std::size_t most_rows = 40;

const char* letter(Trace::Kind kind) {
  switch (kind) {
    case Trace::Kind::input:
      return "in ";
    case Trace::Kind::reg:
      return "reg";
    case Trace::Kind::output:
      return "out";
  }
  return "";
}

// Whether it keeps its value on the clocks from `first` to before `end`, without a difference.
bool is_at_rest(const Trace& t, std::size_t first, std::size_t end) {
  const auto at = [&](std::size_t c) {
    return t.expected.begin() + static_cast<std::ptrdiff_t>(c);
  };
  for (std::size_t c = first; c < end; ++c) {
    if (t.differs(c)) return false;
  }
  return std::adjacent_find(at(first), at(end), std::not_equal_to<>()) == at(end);
}

}  // namespace

std::string difference_text(const Mismatch& m) {
  std::string text = m.finding.empty() ? "" : m.finding + '\n';
  if (!m.finding.empty() && m.field.width == 0) {
    text += fmt::format("  on clock {}\n", m.clock);
  } else {
    text += fmt::format("first difference: clock {}, {}{}{}\n  expected {}\n  actual   {}\n",
                        m.clock, m.signal, *m.field.source != '\0' ? ", block " : "",
                        m.field.source, show(m.field, m.expected), show(m.field, m.actual));
  }
  for (const std::string& line : m.told) text += "  " + line + '\n';
  return text;
}

std::string table_text(const Mismatch& m) {
  std::string text;
  // Every cell first: a column is as wide as its widest.
  struct Row {
    std::string head;
    std::vector<std::string> cells;
  };
  std::vector<Row> rows{{"clock", {}}};
  std::size_t clocks = m.traces.empty() ? 0 : m.traces.front().expected.size(), begin = 0;
  // A word of a memory that keeps its value is always left out: of hundreds only few are written.
  const auto is_resting_word = [&](const Trace& t) {
    return t.kind != Trace::Kind::input && t.field.index >= 0 &&
           is_at_rest(t, begin, begin + clocks);
  };
  const auto resting = static_cast<std::size_t>(std::ranges::count_if(m.traces, is_resting_word));
  const bool is_wide = m.traces.size() - resting > most_rows;
  const std::size_t all = clocks;
  if (is_wide) {
    const std::size_t at = std::min(clocks - 1, static_cast<std::size_t>(m.clock - m.first));
    begin = at - std::min<std::size_t>(at, 3);
    clocks = std::min(clocks, at + 2) - begin;
  }
  for (std::size_t c = 0; c < clocks; ++c) {
    const std::uint64_t at = m.first + begin + c;
    rows[0].cells.push_back(at == m.clock ? fmt::format(">{}", at) : fmt::format("{}", at));
  }
  std::size_t left_out = 0;
  for (const Trace& t : m.traces) {
    if (is_wide ? is_at_rest(t, begin, begin + clocks) : is_resting_word(t)) {
      ++left_out;
      continue;
    }
    bool same = true;
    for (std::size_t c = begin; c < begin + clocks; ++c) same = same && !t.differs(c);
    Row expected{fmt::format("{} {}{}", letter(t.kind), label_of(t.field), same ? "" : " expected"),
                 {}};
    Row actual{same ? "" : fmt::format("{} {} actual", letter(t.kind), label_of(t.field)), {}};
    for (std::size_t c = begin; c < begin + clocks; ++c) {
      expected.cells.push_back(t.compared(c) ? show_short(t.field, t.expected[c]) : "-");
      actual.cells.push_back(show_short(t.field, t.actual[c]) + (t.differs(c) ? "!" : ""));
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
  // As many clocks side by side as fit, the others below.
  for (std::size_t first = 0, end = 0; first < clocks; first = end) {
    std::size_t width = 2 + head;
    while (end < clocks && (end == first || width + 2 + widths[end] <= widest_line)) {
      width += 2 + widths[end++];
    }
    if (first != 0) text += '\n';
    for (const Row& r : rows) {
      text += fmt::format("  {:<{}}", r.head, head);
      for (std::size_t c = first; c < end; ++c) {
        text += fmt::format("  {:>{}}", r.cells[c], widths[c]);
      }
      text += '\n';
    }
  }
  if (is_wide) {
    text += fmt::format(
        "  left out: {} clocks, and {} signals that do not change here; a wave has all\n",
        all - clocks, left_out);
  } else if (left_out != 0) {
    text += fmt::format("  left out: {} elements of arrays that do not change here\n", left_out);
  }
  return text;
}

std::string to_text(const Mismatch& m) { return difference_text(m) + table_text(m); }

void refuse_unsteady(const std::string& title) {
  throw InputError(title +
                   ": a failing case passes when it runs again, or fails otherwise: does its model "
                   "or its RTL depend on something outside the case?");
}

}  // namespace cosim
