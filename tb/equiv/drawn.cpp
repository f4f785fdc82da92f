#include "tb/equiv/drawn.h"

#include <algorithm>
#include <deque>
#include <memory>

#include "tb/equiv/testbench.h"
#include "tb/equiv/vcd.h"
#include "tb/support/pattern.h"
#include "tb/wave/wave.h"

namespace cosim::equiv {
namespace {

constexpr int word_bits = 64;

// A name that is escaped in Verilog is so in a wave: GTKWave takes it whole.
std::string wave_name(const std::string& port) {
  static const Pattern plain("[A-Za-z_][\\w$]*");
  return plain.whole(port).empty() ? '\\' + port : port;
}
std::string port_of(const std::string& wave_name) {
  return wave_name.substr(wave_name.starts_with('\\') ? 1 : 0);
}

// The ports' ranges that are not those of bits counted from 0.
std::map<std::string, std::string> ranges_of(const Side& side) {
  std::map<std::string, std::string> ranges;
  for (const auto& [port, declaration] : side.declared) {
    const std::size_t at = declaration.find('[');
    if (at != std::string::npos) ranges[wave_name(port)] = declaration.substr(at);
  }
  return ranges;
}

// The fields of a wave have names that others own.
class Ports {
 public:
  void add(std::vector<Field>& fields, const std::string& port, std::size_t width) {
    const char* name = names_.emplace_back(wave_name(port)).c_str();
    const auto bits = static_cast<int>(width);
    const Format format = bits == 1 ? Format::flag : Format::bits;
    if (bits <= word_bits) {
      fields.push_back({name, bits, format, "", ""});
      return;
    }
    for (int low = 0; low < bits; low += word_bits) {
      Field word{name, std::min(word_bits, bits - low), format, "", ""};
      word.index = low / word_bits;
      word.low = low;
      word.is_word = true;
      fields.push_back(word);
    }
  }

 private:
  std::deque<std::string> names_;
};

// The bits of one field of a word, the highest first.
std::string_view bits_of(const Field& field, const std::string& text) {
  const auto width = static_cast<std::size_t>(field.width),
             low = static_cast<std::size_t>(field.low);
  return std::string_view(text).substr(text.size() - low - width, width);
}

Word value_of(std::string_view bits) {
  std::uint64_t value = 0;
  for (const char bit : bits) value = value << 1U | (bit == '1' ? 1U : 0U);
  return static_cast<Word>(value);
}

WaveClock at(const WaveShape& shape, const Row& row, bool is_compared) {
  WaveClock now;
  for (const Field& field : shape.inputs) {
    now.inputs.push_back(value_of(bits_of(field, row.inputs.at(port_of(field.name)))));
  }
  for (const Field& field : shape.compared) {
    std::string old(bits_of(field, row.gold.at(port_of(field.name))));
    const std::string_view is = bits_of(field, row.gate.at(port_of(field.name)));
    const bool all_x = old.find_first_not_of('-') == std::string::npos;
    for (std::size_t i = 0; i < old.size(); ++i) {
      if (old[i] == '-') old[i] = is[i];
    }
    now.expected.push_back(value_of(old));
    now.actual.push_back(value_of(is));
    now.compared.push_back(is_compared && !all_x);
    now.differs.push_back(now.compared.back() && old != is);
  }
  return now;
}

// The hierarchy of one of both, its clock as it looks.
std::unique_ptr<Vcd> recorded(const std::string& vcd, const Side& side, const char* name,
                              bool steps, std::vector<Signal>& signals) {
  if (vcd.empty()) return nullptr;
  auto read = std::make_unique<Vcd>(vcd, "cosim_dut", name);
  for (Signal signal : read->signals()) {
    if (signal.name.find('.') != std::string::npos) signal.name = wave_name(port_of(signal.name));
    const auto clock = side.clocks.find(signal.name);
    if (signal.scope.size() == 1 && !steps && clock != side.clocks.end()) {
      signal.is_clock = true;
      signal.falls = clock->second;
    }
    signals.push_back(std::move(signal));
  }
  return read;
}

}  // namespace

WavePicture draw(const Question& q, const Answer& a, std::uint64_t after, const std::string& fst) {
  Ports ports;
  WaveShape shape;
  shape.title = q.gold.files().top;
  shape.ranges = ranges_of(q.gold);
  shape.sides = {"old", "new", "the old RTL", "the new RTL"};
  for (const auto& [port, text] : a.clocks.front().inputs)
    ports.add(shape.inputs, port, text.size());
  for (const auto& [port, text] : a.clocks.front().gold)
    ports.add(shape.compared, port, text.size());

  WaveRange range;
  range.clocks = a.clocks.size() + a.after.size();
  range.mismatch = a.clocks.size() - 1;
  range.first = first_drawn(q, a);
  range.last = std::min(range.clocks - 1, *range.mismatch + after);
  for (const Field& field : shape.compared) {
    if (range.signal.empty() && port_of(field.name) == a.differing.front())
      range.signal = label_of(field);
  }

  std::vector<Signal> signals;
  const auto gold = recorded(a.recorded.gold, q.gold, "old", q.steps, signals);
  const auto gate = recorded(a.recorded.gate, q.gate, "new", q.steps, signals);
  Wave wave(fst);
  PictureSink picture;
  BothSinks sinks(wave, picture);
  sinks.begin(shape, range, signals);
  for (std::uint64_t clock = range.first; clock <= range.last; ++clock) {
    for (const auto& one : {gold.get(), gate.get()}) {
      if (one != nullptr) one->go_to(clock * clock_ps + settled_ps);
    }
    const bool is_after = clock >= a.clocks.size();
    const Row& row = is_after ? a.after[clock - a.clocks.size()] : a.clocks[clock];
    WaveClock now = at(shape, row, clock >= first_compared(q));
    now.clock = clock;
    sinks.clock(now);
  }
  sinks.end(range);
  return picture.take();
}

}  // namespace cosim::equiv
