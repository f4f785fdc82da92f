#include "tb/equiv/result.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "tb/equiv/testbench.h"
#include "tb/show/signal.h"
#include "tb/show/wave.h"
#include "tb/util/pattern.h"

namespace cosim::equiv {
namespace {

// A VCD file as Verilator writes it, read forward in time: what its signals are as a simulation's
// are read.
class Vcd {
 public:
  /// Takes the signals of the scopes below `from`, the name of a scope, as those of `name`. Logic
  /// of two values: what is x or z counts as 0. Reals are left out.
  Vcd(const std::string& text, const std::string& from, const std::string& name);
  Vcd(const Vcd&) = delete;
  Vcd& operator=(const Vcd&) = delete;

  /// Their bytes are valid as long as this object lives.
  const std::vector<Signal>& signals() const { return signals_; }
  /// All changes before the time `ps`, in picoseconds; no earlier than that of the last call.
  void go_to(std::uint64_t ps);

 private:
  struct Value {
    int width = 1;
    std::vector<unsigned char> bytes;  ///< the lowest first
  };
  void header(const std::string& from, const std::string& name);
  void change(const std::string& word);

  std::istringstream in_;
  std::map<std::string, Value> values_;  ///< by the file's code
  std::vector<Signal> signals_;
  std::uint64_t tick_ = 1;  ///< picoseconds
  std::uint64_t now_ = 0;   ///< of the changes that come next, in picoseconds
};

// "1ps", or in two words.
std::uint64_t picoseconds(const std::string& text) {
  constexpr std::uint64_t thousand = 1000;
  const std::uint64_t number = std::stoull(text);
  const std::string unit = text.substr(text.find_first_not_of("0123456789"));
  std::uint64_t ticks = number;
  for (const char* one : {"ps", "ns", "us", "ms"}) {
    if (unit == one) return ticks;
    ticks *= thousand;
  }
  return number;
}

Vcd::Vcd(const std::string& text, const std::string& from, const std::string& name) : in_(text) {
  header(from, name);
}

void Vcd::header(const std::string& from, const std::string& name) {
  std::vector<std::string> scope;
  for (std::string word; in_ >> word && word != "$enddefinitions";) {
    std::vector<std::string> words;
    for (std::string more; in_ >> more && more != "$end";) words.push_back(more);
    if (word == "$timescale" && !words.empty()) {
      tick_ = picoseconds(words.size() == 1 ? words[0] : words[0] + words[1]);
    } else if (word == "$scope" && words.size() == 2) {
      scope.push_back(words[1]);
    } else if (word == "$upscope" && !scope.empty()) {
      scope.pop_back();
    } else if (word == "$var" && words.size() >= 4 && words[0] != "real") {
      const auto at = std::ranges::find(scope, from);
      if (at == scope.end()) continue;
      const int width = std::stoi(words[1]);
      Value& value = values_[words[2]];
      value.width = std::max(width, value.width);
      value.bytes.resize((static_cast<std::size_t>(value.width) + 7) / 8);
      Signal signal;
      signal.scope = {name};
      signal.scope.insert(signal.scope.end(), at + 1, scope.end());
      signal.name = words[3];
      signal.width = width;
      if (words.size() > 4) signal.range = words[4];
      signal.bytes = value.bytes.data();
      signals_.push_back(std::move(signal));
    }
  }
  std::string end;
  in_ >> end;
}

void Vcd::go_to(std::uint64_t ps) {
  while (now_ < ps) {
    std::string word;
    if (!(in_ >> word)) return;
    if (word.front() == '#') {
      now_ = std::stoull(word.substr(1)) * tick_;
    } else {
      change(word);
    }
  }
}

// "1CODE", or "b0101 CODE".
void Vcd::change(const std::string& word) {
  std::string bits, code;
  if (word.front() == 'b' || word.front() == 'B') {
    bits = word.substr(1);
    in_ >> code;
  } else if (word.front() == 'r') {
    in_ >> code;
    return;
  } else {
    bits = word.substr(0, 1);
    code = word.substr(1);
  }
  const auto at = values_.find(code);
  if (at == values_.end()) return;
  auto& bytes = at->second.bytes;
  std::fill(bytes.begin(), bytes.end(), static_cast<unsigned char>(0));
  for (std::size_t i = 0; i < bits.size() && i < 8 * bytes.size(); ++i) {
    if (bits[bits.size() - 1 - i] == '1') bytes[i / 8] |= static_cast<unsigned char>(1U << i % 8);
  }
}

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
