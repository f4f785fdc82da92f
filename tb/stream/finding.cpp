// A finding in words. A wrong value is looked at with what came after it: the same values in
// another order, or shifted by one, say more than that they differ.
#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "tb/stream/run.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

using Kind = StreamFinding::Kind;

// How much of what came must fit for a name.
constexpr std::size_t looked_at = 4;
// How far one is looked for.
constexpr std::size_t looked_for = 256;

// What came and what was expected at an interface.
struct Both {
  const Interface& i;
  const Sequence& came;
  const Sequence& expected;

  /// Whether number n that came is what is expected as number k.
  bool same(std::size_t n, std::size_t k) const {
    const auto actual = came[n], right = expected[k];
    for (std::size_t c = 0; c < right.size(); ++c) {
      if (actual[c] != right[c] && i.is_compared(right, c)) return false;
    }
    return true;
  }
  /// Whether what came from n on is what is expected from k on, as far as both go.
  bool goes_on(std::size_t n, std::size_t k) const {
    std::size_t seen = 0;
    while (seen < looked_at && n + seen < came.size() && k + seen < expected.size()) {
      if (!same(n + seen, k + seen)) return false;
      ++seen;
    }
    // With nothing to look at, both must be at their end.
    return seen > 0 || (n >= came.size() && k >= expected.size());
  }
  /// The first from `from` on that is expected and is what came as number n; and one that came and
  /// is what is expected as number k.
  std::optional<std::size_t> later_expected(std::size_t n, std::size_t from) const {
    return first(from, expected, [&](std::size_t k) { return same(n, k); });
  }
  std::optional<std::size_t> later_came(std::size_t k, std::size_t from) const {
    return first(from, came, [&](std::size_t n) { return same(n, k); });
  }

 private:
  template <class Is>
  static std::optional<std::size_t> first(std::size_t from, const Sequence& in, const Is& is) {
    const std::size_t end = std::min(in.size(), from + looked_for);
    while (from < end && !is(from)) ++from;
    return from < end ? std::optional(from) : std::nullopt;
  }
};

std::string wrong_value(const Both& both, std::size_t n) {
  const std::string& stream = both.i.name;
  const std::string which = fmt::format("{} number {}", stream, n);
  if (n > 0 && both.same(n, n - 1) && both.goes_on(n + 1, n)) {
    return fmt::format("doubled: {} is number {} again", which, n - 1);
  }
  if (both.goes_on(n + 1, n)) {
    return fmt::format("extra: a value that is not expected comes before {}", which);
  }
  // One wrong among right ones is no more than that, whatever else it may be equal to.
  const auto comes_for = both.later_expected(n, n + 1);
  if (!comes_for || both.goes_on(n + 1, n + 1)) {
    return fmt::format("another value: {}", which);
  }
  if (both.later_came(n, n + 1)) {
    return fmt::format("reordered: {} comes after number {}", which, *comes_for);
  }
  // What follows must come from further on too.
  if (n + 1 == both.came.size() || both.later_expected(n + 1, *comes_for + 1)) {
    const std::string gone =
        *comes_for == n + 1 ? which : fmt::format("{} to {}", which, *comes_for - 1);
    return fmt::format("lost: {}; number {} comes instead", gone, *comes_for);
  }
  return fmt::format("another value: {}", which);
}

}  // namespace

std::string signal_of(const StreamShape& shape, const StreamFinding& finding) {
  const Interface& i = (finding.goes_in ? shape.in : shape.out)[finding.stream];
  return finding.kind == Kind::value ? label_of(i.cells[finding.cell]) : i.name;
}

std::string to_text(const StreamShape& shape, const StreamOrder& order,
                    const StreamResult& result) {
  const StreamFinding& f = *result.finding;
  const Interface& i = (f.goes_in ? shape.in : shape.out)[f.stream];
  const std::string which = fmt::format("{} number {}", i.name, f.number);
  const std::string stands = count(shape.watchdog, "clock");
  std::string waits;
  if (f.waits) {
    const Interface& out = shape.out[*f.waits];
    waits = fmt::format("{} waits for {}, ", out.ready, out.valid);
  }
  switch (f.kind) {
    case Kind::value:
      return wrong_value({i, result.came, order.expected[f.stream]}, f.number);
    case Kind::extra: {
      const Sequence& expected = order.expected[f.stream];
      const std::string all = count(expected.size(), "transaction");
      if (f.number > 0 && Both{i, result.came, expected}.same(f.number, f.number - 1)) {
        return fmt::format("doubled: {} is number {} again; {} expected", which, f.number - 1, all);
      }
      return fmt::format("extra: {} comes; {} expected", which, all);
    }
    case Kind::missing:
      return fmt::format(
          "lost: {} never comes, of {}; all that goes in is taken, and nothing "
          "moves for {}",
          which, order.expected[f.stream].size(), stands);
    case Kind::hung:
      return fmt::format("hung: {} {}, {}and nothing moves for {}", which,
                         f.goes_in ? "is not taken" : "does not come", waits, stands);
    case Kind::late:
      return fmt::format("late: {} does not come within {} of what it needs", which,
                         count(static_cast<std::uint64_t>(i.latency), "clock"));
    case Kind::unsteady:
      if (i.pulse) return fmt::format("changed: {} changes while {} stays high", which, i.valid);
      return fmt::format("taken back: {} was offered, and is changed before it is taken", which);
    case Kind::said:
      return result.said;
    case Kind::credit:
      return f.goes_in ? fmt::format("credit: {} gives back more than the {} there are", i.name,
                                     i.credits)
                       : fmt::format("credit: {} comes without any", which);
  }
  return "";
}

}  // namespace cosim
