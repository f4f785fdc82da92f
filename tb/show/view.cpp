#include "tb/show/view.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tb/show/rows.h"
#include "tb/util/output_file.h"

namespace cosim {
namespace {

// What GTKWave's save file calls flags.
enum Flag : unsigned {
  hex = 0x22,
  decimal = 0x24,
  binary = 0x28,
  signed_decimal = 0x420,
  blank = 0x200,
  stretch = 0x20000,
  translated = 0x2000,
  analog_step = 0x8000,
  analog_full = 0x80000,
  group_open = 0x800200,
  group_end = 0x1000200,
  group_closed = 0xc00200,
  group_closed_end = 0x1401200,
};

enum Color { red = 1, orange = 2, yellow = 3, green = 4, blue = 5, indigo = 6, violet = 7 };

unsigned format_of(const Field& f, int width) {
  switch (f.format) {
    case Format::flag:
      return binary;
    case Format::bits:
      return width <= 16 ? binary : hex;  // as the tables show it
    case Format::number:
      return decimal;
    case Format::twos_complement:
      return signed_decimal;
    case Format::ones_complement:
      return width <= 8 ? binary : hex;  // its number stands beside it
  }
  return hex;
}

std::string name_of(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

std::string beside_wave(const std::string& path, const std::string& ending) {
  const std::filesystem::path fst = path;
  return (fst.parent_path() / fst.stem()).string() + ending;
}

// Of a name that is escaped in Verilog; braces end what is shown.
std::string without_braces(std::string shown) {
  std::ranges::replace(shown, '{', '(');
  std::ranges::replace(shown, '}', ')');
  return shown;
}

class View {
 public:
  explicit View(OutputFile& file) : file_(file) {}

  void signal(const std::string& name, const std::string& range, unsigned flags,
              const std::string& shown, std::optional<Color> color = {}) {
    if (color) file_.line("[color] {}", static_cast<int>(*color));
    file_.line("@{:x}", flags);
    file_.line("+{{{}}} {}{}", without_braces(shown), name, range);
  }
  void words(const std::string& name, int width, const std::string& filter,
             const std::string& shown) {
    file_.line("[color] {}", static_cast<int>(yellow));
    file_.line("@{:x}", hex | translated);
    file_.line("^1 {}", filter);
    file_.line("+{{{}}} {}{}", shown, name, range_of_bits(width));
  }
  // Makes the analog trace before it higher.
  void higher(int lines) {
    file_.line("@{:x}", static_cast<unsigned>(stretch));
    for (int i = 0; i < lines; ++i) file_.line("-");
  }
  void group(const std::string& name, bool open = true) {
    file_.line("@{:x}", static_cast<unsigned>(open ? group_open : group_closed));
    file_.line("-{}", name);
  }
  void end_group(const std::string& name, bool open = true) {
    file_.line("@{:x}", static_cast<unsigned>(open ? group_end : group_closed_end));
    file_.line("-{}", name);
  }

 private:
  OutputFile& file_;
};

unsigned format_of(const Bus& b) { return format_of(b.field, b.width); }

void add_pair(View& view, const Bus& b, const WaveShape& shape) {
  const WaveSides& sides = shape.sides;
  const std::string& name = b.name;
  const auto side = [&](const char* one, Color color) {
    view.signal(fmt::format("cosim.{}.{}", one, name), shape.range_of(b), format_of(b),
                fmt::format("{} {}", name, one), color);
  };
  side(sides.expected, green);
  side(sides.actual, orange);
  if (has_number(b.field)) {
    view.signal("cosim.number.expected_" + name, "", signed_decimal, name + " expected", green);
    view.signal("cosim.number." + name, "", signed_decimal, name + " actual", orange);
  }
  view.signal("cosim.mismatch." + name, "", binary, name + " mismatch", red);
}

void add_probe(View& view, const Probe& probe, const std::string& words) {
  const std::string name = fmt::format("cosim.{}.{}", probe.scope, probe.name);
  if (probe.kind == Probe::Kind::words) {
    view.words(name, probe.width, words, probe.name);
    return;
  }
  const unsigned format = format_of({probe.name, probe.width, probe.format, "", ""}, probe.width);
  const bool analog = probe.kind == Probe::Kind::analog;
  view.signal(name, range_of_bits(probe.width), format | (analog ? analog_step | analog_full : 0U),
              probe.name, green);
  if (analog) view.higher(3);
}

void add_register(View& view, const Bus& b, const std::string& shown, const WaveShape& shape) {
  if (!has_number(b.field)) {
    view.signal(fmt::format("cosim.{}.{}", shape.sides.actual, b.name), shape.range_of(b),
                format_of(b), shown);
  } else if (b.field.fraction > 0) {
    view.signal("cosim.number." + b.name, "", signed_decimal | analog_step | analog_full, shown,
                orange);
    view.higher(3);
  } else {
    view.signal("cosim.number." + b.name, "", signed_decimal, shown);
  }
}

void write_words(const std::string& path, const Probe& probe) {
  OutputFile file(path);
  for (std::size_t i = 0; i < probe.words.size(); ++i) file.line("{:x} {}", i, probe.words[i]);
  file.close();
}

}  // namespace

bool has_number(const Field& field) {
  return field.format == Format::ones_complement || field.fraction > 0;
}

double number_of(const Field& field, Word value) {
  const Word number = units_of(field, value);
  return std::ldexp(static_cast<double>(number), -field.fraction);
}

std::string view_file(const std::string& path) { return beside_wave(path, ".gtkw"); }

std::string words_file(const std::string& path, const Probe& probe) {
  return beside_wave(path, fmt::format(".{}.txt", probe.name));
}

std::vector<std::string> view_files(const std::string& path, const std::vector<Probe>& probes) {
  std::vector<std::string> all{view_file(path)};
  for (const Probe& probe : probes) {
    if (probe.kind == Probe::Kind::words) all.push_back(words_file(path, probe));
  }
  return all;
}

void write_view(const std::string& path, const WaveShape& shape, const WaveRange& range) {
  for (const Probe& probe : shape.probes) {
    if (probe.kind == Probe::Kind::words) write_words(words_file(path, probe), probe);
  }

  // A wave of many clocks is opened around the mismatch, or where it begins.
  constexpr std::uint64_t shown_clocks = 32;
  const std::uint64_t clocks = std::min(range.last - range.first + 1, shown_clocks);

  // GTKWave's zoom z is 2^-z ns to 200 pixels.
  constexpr double frames = 1100 / 200.0;
  const double zoom = -std::log2(static_cast<double>(clocks * wave_period) / frames);

  const std::string view_path = view_file(path);
  OutputFile file(view_path);
  file.line("[*] {}: to be opened in the folder it lies in", shape.title);
  file.line("[dumpfile] \"{}\"", name_of(path));
  file.line("[savefile] \"{}\"", name_of(view_path));
  file.line("[timestart] {}", seen_first(range, shown_clocks) * wave_period);
  file.line("[size] 1480 960");
  file.line("[pos] -1 -1");
  // The primary marker, and 26 named ones that are not set.
  std::string markers = range.mismatch ? std::to_string(*range.mismatch * wave_period) : "-1";
  for (char name = 'A'; name <= 'Z'; ++name) markers += " -1";
  file.line("*{:.6f} {}", zoom, markers);
  file.line("[sst_width] 160");
  file.line("[signals_width] 330");
  file.line("[sst_expanded] 0");

  View view(file);
  view.signal("cosim.clk", "", binary, "clk");
  view.signal("cosim.clock", range_of_bits(clock_width), decimal, "clock");
  view.signal("cosim.mismatch.any", "", binary, "mismatch", red);
  for (const std::string& name : shape.texts) {
    view.signal("cosim.text." + name, "", hex, name, yellow);
  }
  const std::vector<Bus> inputs = buses_of(shape.inputs), compared = buses_of(shape.compared);
  const auto add = [&](const WaveRow& row) {
    switch (row.kind) {
      case WaveRow::Kind::input:
        view.signal("cosim.inputs." + inputs[row.at].name, shape.range_of(inputs[row.at]),
                    format_of(inputs[row.at]), row.shown);
        break;
      case WaveRow::Kind::output:
        view.signal(fmt::format("cosim.{}.{}", shape.sides.actual, compared[row.at].name),
                    shape.range_of(compared[row.at]), format_of(compared[row.at]), row.shown,
                    orange);
        break;
      case WaveRow::Kind::reg:
        add_register(view, compared[row.at], row.shown, shape);
        break;
      case WaveRow::Kind::pair:
        add_pair(view, compared[row.at], shape);
        break;
      case WaveRow::Kind::probe:
        add_probe(view, shape.probes[row.at], name_of(words_file(path, shape.probes[row.at])));
        break;
    }
  };
  for (const WaveGroup& group : wave_groups(shape, range.signal)) {
    if (!group.title.empty()) view.group(group.title, group.is_open);
    for (const WaveRow& row : group.rows) add(row);
    if (!group.title.empty()) view.end_group(group.title, group.is_open);
  }
  file.close();
}

}  // namespace cosim
