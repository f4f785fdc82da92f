#include "tb/show/picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "tb/show/rows.h"
#include "tb/show/svg.h"
#include "tb/show/view.h"
#include "tb/util/show.h"

namespace cosim {
namespace {

// How many clocks are shown where something differs, and where nothing does.
constexpr std::uint64_t clocks_around = 24, clocks_first = 48;
constexpr std::size_t most_points = 2000;   // of a path
constexpr std::size_t most_text = 350'000;  // of the wave, in bytes: two of them are a page
constexpr std::size_t most_rows = 160;

using Values = std::vector<Word> WaveClock::*;

std::string text_of(const Bus& b, const std::vector<Word>& words) {
  if (b.count == 1) return show_short(b.field, words[b.first]);
  std::string text;  // a wide number, its lowest word first
  for (std::size_t i = b.count; i-- > 0;) {
    const int below = b.field.width * static_cast<int>(i);
    const int width = std::min(b.field.width, b.width - below);
    text += fmt::format("{:0{}x}", static_cast<std::uint64_t>(words[b.first + i]), (width + 3) / 4);
  }
  return text;
}

class PictureRows {
 public:
  PictureRows(const WaveShape& shape, const std::vector<WaveClock>& clocks)
      : shape_(shape),
        clocks_(clocks),
        inputs_(buses_of(shape.inputs)),
        compared_(buses_of(shape.compared)) {}

  void add(const WaveGroup& group) {
    if (!group.is_open) return;
    if (!group.title.empty())
      all.push_back({SvgRow::Kind::heading, SvgRow::Side::plain, group.title});
    for (const WaveRow& row : group.rows) add(row);
    if (!all.empty() && all.back().kind == SvgRow::Kind::heading) all.pop_back();
  }

  std::vector<SvgRow> all;
  std::size_t left_out = 0;

 private:
  void add(const WaveRow& row) {
    switch (row.kind) {
      case WaveRow::Kind::input:
        if (is_at_rest(inputs_[row.at], &WaveClock::inputs)) break;
        add(inputs_[row.at], SvgRow::Side::plain, &WaveClock::inputs, row.shown);
        break;
      case WaveRow::Kind::pair:
        add_pair(compared_[row.at], row.shown);
        break;
      case WaveRow::Kind::probe:
        add_probe(shape_.probes[row.at], row.at);
        break;
      default:
        add_compared(compared_[row.at], row.shown);
    }
  }

  // An element of an array that keeps its value: of hundreds only few are written.
  bool is_at_rest(const Bus& b, Values values) {
    if (b.field.index < 0 || b.field.is_word) return false;
    for (const WaveClock& c : clocks_) {
      const bool differs = values != &WaveClock::inputs && c.differs[b.first];
      if (differs || (c.*values)[b.first] != (clocks_.front().*values)[b.first]) return false;
    }
    ++left_out;
    return true;
  }

  void add_compared(const Bus& b, const std::string& shown) {
    if (is_at_rest(b, &WaveClock::actual)) return;
    const bool same =
        std::ranges::none_of(clocks_, [&](const WaveClock& c) { return c.differs_in(b); });
    if (same || shape_.is_finding(b)) {
      add(b, SvgRow::Side::plain, &WaveClock::actual, shown);
    } else {
      add_pair(b, shown);
    }
  }
  void add_pair(const Bus& b, const std::string& shown) {
    add(b, SvgRow::Side::expected, &WaveClock::expected,
        fmt::format("{} {}", shown, shape_.sides.expected));
    add(b, SvgRow::Side::actual, &WaveClock::actual,
        fmt::format("{} {}", shown, shape_.sides.actual));
  }

  void add(const Bus& b, SvgRow::Side side, Values values, const std::string& shown) {
    const Field& f = b.field;
    SvgRow row{f.format == Format::flag && b.count == 1 ? SvgRow::Kind::flag : SvgRow::Kind::bus,
               side, shown, f.meaning};
    const Values others =
        values == &WaveClock::expected ? &WaveClock::actual : &WaveClock::expected;
    for (const WaveClock& c : clocks_) {
      row.text.push_back(text_of(b, c.*values));
      row.number.push_back(static_cast<double>((c.*values)[b.first]));
      const bool is_compared = values != &WaveClock::inputs;
      row.differs.push_back(is_compared && c.differs_in(b));
      row.left_out.push_back(is_compared && !c.compared[b.first]);
      row.other.push_back(row.differs.back() ? text_of(b, c.*others) : "");
    }
    all.push_back(std::move(row));
  }

  void add_probe(const Probe& probe, std::size_t at) {
    const Field field{probe.name, probe.width, probe.format, "", ""};
    const auto text = [&](Word value) {
      const auto n = static_cast<std::size_t>(value);
      if (probe.kind != Probe::Kind::words) return show_short(field, low_bits(value, probe.width));
      return n < probe.words.size() ? std::string(probe.words[n]) : fmt::format("{}", value);
    };
    const bool is_curve = probe.kind == Probe::Kind::analog;
    const bool by_model = probe.side == Probe::Side::expected;
    const bool by_both = probe.side == Probe::Side::both;
    SvgRow row{is_curve ? SvgRow::Kind::curve : SvgRow::Kind::bus,
               by_both ? SvgRow::Side::actual : SvgRow::Side::plain, probe.name,
               by_model ? "of the model" : "of the RTL"};
    bool same = true;
    for (const WaveClock& c : clocks_) {
      const Word expected = c.expected_probes[at];
      const Word actual = by_model ? expected : c.actual_probes[at];
      row.text.push_back(text(actual));
      row.number.push_back(static_cast<double>(units_of(field, low_bits(actual, probe.width))));
      row.expected.push_back(static_cast<double>(units_of(field, low_bits(expected, probe.width))));
      row.differs.push_back(by_both && expected != actual);
      same = same && !row.differs.back();
    }
    const auto moves = [](const std::vector<double>& values) {
      return std::ranges::any_of(values, [&](double one) { return one != values.front(); });
    };
    if (is_curve && !moves(row.number) && !moves(row.expected)) row.kind = SvgRow::Kind::bus;
    if (same || !is_curve) row.expected.clear();
    if (same) row.side = SvgRow::Side::plain;
    all.push_back(std::move(row));
  }

  const WaveShape& shape_;
  const std::vector<WaveClock>& clocks_;
  const std::vector<Bus> inputs_, compared_;
};

// The numbers of the probes x and y of one scope.
std::optional<std::pair<std::size_t, std::size_t>> path_probes(const std::vector<Probe>& probes) {
  for (std::size_t i = 0; i + 1 < probes.size(); ++i) {
    const Probe &x = probes[i], &y = probes[i + 1];
    if (std::strcmp(x.name, "x") == 0 && std::strcmp(y.name, "y") == 0 &&
        std::strcmp(x.scope, y.scope) == 0) {
      return std::pair(i, i + 1);
    }
  }
  return {};
}

}  // namespace

struct PictureSink::Kept {
  const WaveShape& shape;
  std::uint64_t first, end;  // of the clocks that are shown
  std::optional<std::pair<std::size_t, std::size_t>> xy;
  std::vector<WaveClock> clocks;
  SvgPath path;

  std::pair<double, double> point(const std::vector<Word>& probes) const {
    const auto number = [&](std::size_t i) {
      const Probe& p = shape.probes[i];
      return static_cast<double>(
          units_of({p.name, p.width, p.format, "", ""}, low_bits(probes[i], p.width)));
    };
    return {number(xy->first), number(xy->second)};
  }
};

PictureSink::PictureSink() = default;
PictureSink::~PictureSink() = default;

void PictureSink::begin(const WaveShape& shape, const WaveRange& range,
                        const std::vector<Signal>& /*rtl*/) {
  const std::uint64_t clocks = range.mismatch ? clocks_around : clocks_first;
  const std::uint64_t first = seen_first(range, clocks);
  kept_ =
      std::make_unique<Kept>(Kept{shape, first, first + clocks, path_probes(shape.probes), {}, {}});
  picture_.title = shape.title;
  picture_.sides = shape.sides;
  picture_.path_first = range.first;
}

void PictureSink::clock(const WaveClock& now) {
  Kept& k = *kept_;
  if (k.xy && k.path.actual.size() < most_points) {
    k.path.expected.push_back(k.point(now.expected_probes));
    k.path.actual.push_back(k.point(now.actual_probes));
    picture_.path_last = now.clock;
  }
  if (now.clock >= k.first && now.clock < k.end) k.clocks.push_back(now);
}

void PictureSink::end(const WaveRange& range) {
  const Kept& k = *kept_;
  picture_.clocks = range.clocks;
  if (k.clocks.empty()) return;
  picture_.first = k.clocks.front().clock;
  picture_.last = k.clocks.back().clock;
  PictureRows rows(k.shape, k.clocks);
  for (const WaveGroup& group : wave_groups(k.shape, range.signal)) rows.add(group);
  // As many as a page has room for.
  std::size_t most = most_rows;
  do {
    if (rows.all.size() > most) {
      picture_.left_out += rows.all.size() - most;
      picture_.is_cut = true;
      rows.all.resize(most);
    }
    picture_.wave = wave_svg(rows.all, {k.first, k.clocks.size(), range.mismatch});
    most = rows.all.size() / 2;
  } while (picture_.wave.size() > most_text && most > 0);
  picture_.left_out += rows.left_out;
  if (k.xy) picture_.path = path_svg(k.path);
}

}  // namespace cosim
