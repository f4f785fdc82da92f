#include "tb/wave/view.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tb/support/output_file.h"

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

std::string with_range(const std::string& name, int width) {
  return width == 1 ? name : fmt::format("{}[{}:0]", name, width - 1);
}

class View {
 public:
  explicit View(OutputFile& file) : file_(file) {}

  void signal(const std::string& name, int width, unsigned flags, const std::string& shown,
              std::optional<Color> color = {}) {
    if (color) file_.line("[color] {}", static_cast<int>(*color));
    file_.line("@{:x}", flags);
    file_.line("+{{{}}} {}", shown, with_range(name, width));
  }
  void words(const std::string& name, int width, const std::string& filter,
             const std::string& shown) {
    file_.line("[color] {}", static_cast<int>(yellow));
    file_.line("@{:x}", hex | translated);
    file_.line("^1 {}", filter);
    file_.line("+{{{}}} {}", shown, with_range(name, width));
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

std::string source_of(const Field& f) {
  return *f.source == '\0' ? "" : fmt::format(" ({})", f.source);
}

unsigned format_of(const Bus& b) { return format_of(b.field, b.width); }

void add_pair(View& view, const Bus& b) {
  const std::string& name = b.name;
  view.signal("cosim.expected." + name, b.width, format_of(b), name + " expected", green);
  view.signal("cosim.actual." + name, b.width, format_of(b), name + " actual", orange);
  if (has_number(b.field)) {
    view.signal("cosim.number.expected_" + name, 1, signed_decimal, name + " expected", green);
    view.signal("cosim.number." + name, 1, signed_decimal, name + " actual", orange);
  }
  view.signal("cosim.mismatch." + name, 1, binary, name + " mismatch", red);
}

void add_probe(View& view, const Probe& probe, const std::string& words) {
  const std::string name = fmt::format("cosim.{}.{}", probe.scope, probe.name);
  if (probe.kind == Probe::Kind::words) {
    view.words(name, probe.width, words, probe.name);
    return;
  }
  const unsigned format = format_of({probe.name, probe.width, probe.format, "", ""}, probe.width);
  const bool analog = probe.kind == Probe::Kind::analog;
  view.signal(name, probe.width, format | (analog ? analog_step | analog_full : 0U), probe.name,
              green);
  if (analog) view.higher(3);
}

// Those of a group together, where they stand side by side.
void add_probes(View& view, const std::string& path, const std::vector<Probe>& probes) {
  std::string group;
  const auto change = [&](const std::string& to) {
    if (to == group) return;
    if (!group.empty()) view.end_group(group);
    if (!to.empty()) view.group(to);
    group = to;
  };
  for (const Probe& probe : probes) {
    change(probe.group);
    add_probe(view, probe, name_of(words_file(path, probe)));
  }
  change("");
}

void add_registers(View& view, const WaveShape& shape) {
  view.group("Registers (block of the source)");
  for (const Bus& b : buses_of(shape.compared)) {
    if (b.first >= shape.registers) break;
    const Field& f = b.field;
    const std::string shown = b.name + source_of(f);
    if (!has_number(f)) {
      view.signal("cosim.actual." + b.name, b.width, format_of(b), shown);
    } else if (f.fraction > 0) {
      view.signal("cosim.number." + b.name, 1, signed_decimal | analog_step | analog_full, shown,
                  orange);
      view.higher(3);
    } else {
      view.signal("cosim.number." + b.name, 1, signed_decimal, shown);
    }
  }
  view.end_group("Registers (block of the source)");
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
  const std::uint64_t all = range.last - range.first + 1;
  const std::uint64_t clocks = std::min(all, shown_clocks);
  const std::uint64_t before =
      range.mismatch ? std::min(*range.mismatch - range.first, clocks * 2 / 3) : 0;
  const std::uint64_t from = range.mismatch ? *range.mismatch - before : range.first;

  // GTKWave's zoom z is 2^-z ns to 200 pixels.
  constexpr double frames = 1100 / 200.0;
  const double zoom = -std::log2(static_cast<double>(clocks * wave_period) / frames);

  const std::string view_path = view_file(path);
  OutputFile file(view_path);
  file.line("[*] {}: to be opened in the folder it lies in", shape.title);
  file.line("[dumpfile] \"{}\"", name_of(path));
  file.line("[savefile] \"{}\"", name_of(view_path));
  file.line("[timestart] {}", from * wave_period);
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
  view.signal("cosim.clk", 1, binary, "clk");
  view.signal("cosim.clock", clock_width, decimal, "clock");
  view.signal("cosim.mismatch.any", 1, binary, "mismatch", red);
  const std::vector<Bus> compared = buses_of(shape.compared);
  for (const Bus& b : compared) {
    const auto cell = shape.compared.begin() + static_cast<std::ptrdiff_t>(b.first);
    if (std::none_of(cell, cell + static_cast<std::ptrdiff_t>(b.count),
                     [&](const Field& f) { return label_of(f) == range.signal; })) {
      continue;
    }
    view.group("First difference: " + range.signal);
    add_pair(view, b);
    view.end_group("First difference: " + range.signal);
  }
  add_probes(view, path, shape.probes);
  view.group("Pins (of the source)");
  for (const Bus& b : buses_of(shape.inputs)) {
    view.signal("cosim.inputs." + b.name, b.width, format_of(b), b.name + source_of(b.field));
  }
  for (const Bus& b : compared) {
    if (b.first < shape.registers) continue;
    view.signal("cosim.actual." + b.name, b.width, format_of(b), b.name + source_of(b.field),
                orange);
  }
  view.end_group("Pins (of the source)");
  add_registers(view, shape);
  view.group("Expected, actual, mismatch", false);
  for (const Bus& b : compared) add_pair(view, b);
  view.end_group("Expected, actual, mismatch", false);
  file.close();
}

}  // namespace cosim
