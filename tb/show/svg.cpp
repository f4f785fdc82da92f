#include "tb/show/svg.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/util/markup.h"

namespace cosim {
namespace {

// In pixels.
constexpr int letter = 8;       // of a row's text, at most
constexpr int axis = 52;        // the marker, the clocks' numbers, the clock itself
constexpr int high = 22;        // a row
constexpr int curve_high = 76;  // one with a curve
constexpr int heading_high = 26;
constexpr int slant = 3;
constexpr int in_sight = 440;
constexpr int narrowest = 26, widest = 92;  // a clock

int height_of(const SvgRow& row) {
  if (row.kind == SvgRow::Kind::heading) return heading_high;
  return row.kind == SvgRow::Kind::curve ? curve_high : high;
}

int width_of(const std::string& text) { return static_cast<int>(text.size()) * letter; }

// Clocks on which a row looks the same.
struct Stretch {
  std::size_t first, end;
};

std::vector<Stretch> stretches(const SvgRow& row) {
  const auto same = [&](std::size_t a, std::size_t b) {
    return row.text[a] == row.text[b] && row.differs[a] == row.differs[b] &&
           (row.left_out.empty() || row.left_out[a] == row.left_out[b]) &&
           (row.other.empty() || row.other[a] == row.other[b]);
  };
  std::vector<Stretch> all;
  for (std::size_t c = 0; c < row.text.size(); ++c) {
    if (all.empty() || !same(c - 1, c)) {
      all.push_back({c, c + 1});
    } else {
      ++all.back().end;
    }
  }
  return all;
}

bool is_left_out(const SvgRow& row, std::size_t clock) {
  return !row.left_out.empty() && row.left_out[clock];
}

// As much of a value as there is room for; of one that differs the part that does.
std::string fitting(const SvgRow& row, std::size_t clock, int room) {
  const std::string& text = row.text[clock];
  const std::size_t most = static_cast<std::size_t>(std::max(room, 0)) / letter;
  if (text.size() <= most) return text;
  if (most < 3) return "";
  std::size_t from = 0;
  if (!row.other.empty() && row.other[clock].size() == text.size()) {
    const auto apart = std::mismatch(text.begin(), text.end(), row.other[clock].begin()).first;
    const auto at = static_cast<std::size_t>(apart - text.begin());
    if (at + 1 >= most) from = std::min(at, text.size() - (most - 1));
  }
  const bool cut = from + most - 1 < text.size();
  return (from > 0 ? "…" : "") + text.substr(from, most - (from > 0 && cut ? 2 : 1)) +
         (cut ? "…" : "");
}

class Drawing {
 public:
  Drawing(const std::vector<SvgRow>& rows, const SvgClocks& clocks) : rows_(rows), clocks_(clocks) {
    for (const SvgRow& row : rows) {
      height_ += height_of(row);
      const int name = width_of(row.name) + (row.kind == SvgRow::Kind::heading ? 8 : 20);
      names_ = std::max(names_, name);
      if (row.kind == SvgRow::Kind::bus || row.kind == SvgRow::Kind::curve) fit(row);
    }
    clock_ = std::max(clock_, width_of(std::to_string(clocks.first + clocks.count)) + 6);
  }

  std::string text() {
    put("<div class=\"wave\" tabindex=\"0\"><svg class=\"names\" width=\"{}\" height=\"{}\">",
        names_, height_);
    put("<text class=\"h\" x=\"4\" y=\"31\">clock</text>");
    int y = axis;
    for (const SvgRow& row : rows_) {
      name(row, y);
      y += height_of(row);
    }
    const int width = x(clocks_.count) + 1;
    put("</svg><div class=\"clocks\">");
    if (clocks_.mismatch) {
      // Where a browser scrolls to first: some clocks before it are seen too.
      put("<i style=\"left:calc({}px - 55vw)\"></i>", x(marked()));
    }
    put("<svg width=\"{}\" height=\"{}\">", std::max(width, 130), height_);
    behind();
    numbers();
    y = axis;
    for (const SvgRow& row : rows_) {
      draw(row, y);
      y += height_of(row);
    }
    out_ += "</svg></div></div>\n";
    return std::move(out_);
  }

 private:
  template <class... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    out_ += fmt::format(format, std::forward<Values>(values)...);
  }
  int x(std::size_t clock) const { return static_cast<int>(clock) * clock_; }
  std::size_t marked() const { return *clocks_.mismatch - clocks_.first; }

  // A clock as wide as its values need, if they do not need too much.
  void fit(const SvgRow& row) {
    for (const Stretch& s : stretches(row)) {
      const int wanted = (width_of(row.text[s.first]) + 10) / static_cast<int>(s.end - s.first);
      clock_ = std::max(clock_, std::min(wanted, widest));
    }
  }

  void name(const SvgRow& row, int y) {
    if (row.kind == SvgRow::Kind::heading) {
      put("<text class=\"h\" x=\"4\" y=\"{}\">{}</text>", y + 18, markup(row.name));
      return;
    }
    put("<text class=\"{}\" x=\"14\" y=\"{}\">", side(row), y + height_of(row) / 2 + 4);
    if (!row.meaning.empty()) put("<title>{}</title>", markup(row.meaning));
    put("{}</text>", markup(row.name));
  }
  static const char* side(const SvgRow& row) {
    return row.side == SvgRow::Side::expected ? "e" : row.side == SvgRow::Side::actual ? "a" : "p";
  }

  // The clock that is marked, and where each clock begins.
  void behind() {
    if (clocks_.mismatch) {
      put("<rect class=\"mark\" x=\"{}\" y=\"0\" width=\"{}\" height=\"{}\"/>", x(marked()), clock_,
          height_);
      const bool right = x(marked()) > x(clocks_.count) / 2;
      put("<text class=\"bad\" x=\"{}\" y=\"13\"{}>first difference</text>",
          right ? x(marked() + 1) : x(marked()), right ? " text-anchor=\"end\"" : "");
    }
    put("<path class=\"grid\" d=\"");
    for (std::size_t c = 0; c <= clocks_.count; ++c) put("M{}.5 {}V{}", x(c), axis - 2, height_);
    put("\"/>");
  }
  void numbers() {
    std::string clk = "M0 48";
    for (std::size_t c = 0; c < clocks_.count; ++c) {
      const bool is_marked = clocks_.mismatch && c == marked();
      put("<text class=\"{}\" x=\"{}\" y=\"31\" text-anchor=\"middle\">{}</text>",
          is_marked ? "bad" : "n", x(c) + clock_ / 2, clocks_.first + c);
      clk += fmt::format("V38H{}V48H{}", x(c) + clock_ / 2, x(c + 1));
    }
    put("<path class=\"clk\" d=\"{}\"/>", clk);
  }

  void draw(const SvgRow& row, int y) {
    if (row.kind == SvgRow::Kind::heading) {
      put("<path class=\"grid\" d=\"M0 {0}.5H{1}\"/>", y + heading_high - 3, x(clocks_.count));
      return;
    }
    const auto all = stretches(row);
    for (const Stretch& s : all) {
      const bool differs = row.differs[s.first];
      if (!differs && !is_left_out(row, s.first)) continue;
      put("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
          differs ? "differs" : "off", x(s.first), y + 1, x(s.end - s.first), height_of(row) - 2);
    }
    switch (row.kind) {
      case SvgRow::Kind::flag:
        put("<path class=\"l {}\" d=\"{}\"/>", side(row), level(row.number, y + 4, high - 8));
        break;
      case SvgRow::Kind::bus:
        bus(row, all, y);
        break;
      default:
        curve(row, y);
    }
  }

  // Steps between the least and the most of all.
  std::string level(const std::vector<double>& values, int y, int tall, double least = 0,
                    double most = 1) const {
    std::string d;
    for (std::size_t c = 0; c < values.size(); ++c) {
      if (c > 0 && values[c] == values[c - 1]) continue;
      const double at = most == least ? 0.5 : (values[c] - least) / (most - least);
      d += c == 0 ? "M0 " : fmt::format("H{}V", x(c));
      d += fmt::format("{:.0f}", y + tall - at * tall);
    }
    return d + fmt::format("H{}", x(values.size()));
  }

  void bus(const SvgRow& row, const std::vector<Stretch>& all, int y) {
    std::string d;
    for (const Stretch& s : all) {
      const int left = x(s.first), right = x(s.end), half = (high - 6) / 2;
      d += fmt::format("M{0} {1}l{2}-{3}H{4}l{2} {3}l-{2} {3}H{5}z", left, y + high / 2, slant,
                       half, right - slant, left + slant);
    }
    put("<path class=\"l {}\" d=\"{}\"/>", side(row), d);
    for (const Stretch& s : all) {
      // A long one says its value again and again: some of it is always in sight.
      const int width = x(s.end - s.first), times = 1 + width / in_sight;
      for (int i = 0; i < times; ++i) {
        value(row, s.first, x(s.first) + width * (2 * i + 1) / (2 * times), y + high / 2 + 4,
              width / times - 8, " text-anchor=\"middle\"");
      }
    }
  }
  void value(const SvgRow& row, std::size_t clock, int at, int y, int room, const char* more) {
    const std::string shown = fitting(row, clock, room);
    if (shown.empty()) return;
    const char* const colour = row.differs[clock] ? "bad" : is_left_out(row, clock) ? "n" : "v";
    put("<text class=\"{}\" x=\"{}\" y=\"{}\"{}>", colour, at, y, more);
    if (shown != row.text[clock]) put("<title>{}</title>", markup(row.text[clock]));
    put("{}</text>", markup(shown));
  }

  void curve(const SvgRow& row, int y) {
    double least = row.number.front(), most = least;
    for (const auto* values : {&row.number, &row.expected}) {
      for (const double v : *values) least = std::min(least, v), most = std::max(most, v);
    }
    const int top = y + 16, tall = curve_high - 22;
    if (!row.expected.empty()) {
      put("<path class=\"l e\" d=\"{}\"/>", level(row.expected, top, tall, least, most));
    }
    put("<path class=\"l {}\" d=\"{}\"/>", side(row), level(row.number, top, tall, least, most));
    for (const Stretch& s : stretches(row)) {
      const double at = most == least ? 0.5 : (row.number[s.first] - least) / (most - least);
      value(row, s.first, x(s.first) + 3, static_cast<int>(top + tall - at * tall) - 4,
            x(s.end - s.first), "");
    }
  }

  const std::vector<SvgRow>& rows_;
  const SvgClocks clocks_;
  int names_ = 60, clock_ = narrowest, height_ = axis + 4;
  std::string out_;
};

}  // namespace

std::string wave_svg(const std::vector<SvgRow>& rows, const SvgClocks& clocks) {
  return Drawing(rows, clocks).text();
}

}  // namespace cosim
