#include "tb/show/wave.h"

#include <fmt/core.h>
#include <gtkwave/fstapi.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>

#include "model/core/input_error.h"
#include "model/core/value.h"
#include "tb/show/view.h"
#include "tb/util/leftover.h"
#include "tb/util/output_file.h"

namespace cosim {
namespace {

// The writer maps its file into memory, where a full disk is no error but a signal: so it is left
// some room.
void check_room(const std::string& path) {
  constexpr std::uintmax_t needed = 4U << 20;
  std::error_code error;
  const auto folder = std::filesystem::absolute(path, error).parent_path();
  const auto room = std::filesystem::space(folder, error);
  if (!error && room.available < needed) {
    throw InputError(fmt::format("{}: cannot write: {}", path, std::strerror(ENOSPC)));
  }
}

}  // namespace

// An FST file being written.
/// Scopes and variables first, then times and values. A value stays until the next one.
class Fst {
 public:
  using Handle = std::uint32_t;

  /// InputError where the file cannot be written, here, in time() and in close().
  explicit Fst(const std::string& path);
  ~Fst();
  Fst(const Fst&) = delete;
  Fst& operator=(const Fst&) = delete;

  void open_scope(const std::string& name);
  void close_scope();
  /// A variable of `width` bits; `range` as "[7:4]", else they are counted from 0.
  Handle variable(const std::string& name, int width, const std::string& range = "");
  /// A variable that holds a real number.
  Handle real(const std::string& name);

  /// A variable that holds text.
  Handle text(const std::string& name);

  /// In nanoseconds; rising.
  void time(std::uint64_t t);
  /// The low `width` bits of `value`, width <= 64.
  void value(Handle handle, int width, Word value);
  /// `width` bits of any number, the lowest byte first.
  void bytes(Handle handle, int width, const unsigned char* bytes);
  void number(Handle handle, double number);
  void text(Handle handle, const std::string& text);

  /// Completes the file. To be called last.
  void close();

 private:
  std::string path_;
  Leftover half_, hierarchy_;  // what the writer writes, and what it puts beside that meanwhile
  decltype(fstWriterCreate(nullptr, 0)) writer_ = nullptr;  // another type in newer libraries
  std::string digits_;
  std::map<Handle, std::string> texts_;  // as they are now
};

Fst::Fst(const std::string& path)
    : path_(path), half_(beside(path)), hierarchy_(half_.path() + ".hier") {
  check_room(path);
  // The writer opens whatever has that name: made first, it is nobody else's.
  const int made = open_beside(path, half_.path());
  if (made >= 0) {
    ::close(made);
    writer_ = fstWriterCreate(half_.path().c_str(), 1);
  }
  if (writer_ == nullptr) {
    throw InputError(fmt::format("{}: cannot write: {}", path, std::strerror(errno)));
  }
  fstWriterSetTimescale(writer_, -9);
  fstWriterSetVersion(writer_, "cosim");
  fstWriterSetDate(writer_, "");  // the same run gives the same file
  fstWriterSetPackType(writer_, FST_WR_PT_LZ4);
}

Fst::~Fst() {
  if (writer_ != nullptr) fstWriterClose(writer_);
}

void Fst::open_scope(const std::string& name) {
  fstWriterSetScope(writer_, FST_ST_VCD_MODULE, name.c_str(), nullptr);
}

void Fst::close_scope() { fstWriterSetUpscope(writer_); }

Fst::Handle Fst::variable(const std::string& name, int width, const std::string& range) {
  const std::string bits = range.empty() ? range_of_bits(width) : range;
  const std::string full = bits.empty() ? name : name + ' ' + bits;
  return fstWriterCreateVar(writer_, FST_VT_VCD_WIRE, FST_VD_IMPLICIT,
                            static_cast<std::uint32_t>(width), full.c_str(), 0);
}

Fst::Handle Fst::real(const std::string& name) {
  return fstWriterCreateVar(writer_, FST_VT_VCD_REAL, FST_VD_IMPLICIT, sizeof(double), name.c_str(),
                            0);
}

Fst::Handle Fst::text(const std::string& name) {
  return fstWriterCreateVar(writer_, FST_VT_GEN_STRING, FST_VD_IMPLICIT, 0, name.c_str(), 0);
}

void Fst::time(std::uint64_t t) { fstWriterEmitTimeChange(writer_, t); }

void Fst::value(Handle handle, int width, Word value) {
  static_assert(std::endian::native == std::endian::little);
  bytes(handle, width, reinterpret_cast<const unsigned char*>(&value));
}

void Fst::bytes(Handle handle, int width, const unsigned char* bytes) {
  digits_.resize(static_cast<std::size_t>(width));
  for (int i = 0; i < width; ++i) {
    digits_[static_cast<std::size_t>(width - 1 - i)] =
        (bytes[i / 8] >> (i % 8) & 1) != 0 ? '1' : '0';
  }
  fstWriterEmitValueChange(writer_, handle, digits_.data());
}

void Fst::number(Handle handle, double number) {
  fstWriterEmitValueChange(writer_, handle, &number);
}

void Fst::text(Handle handle, const std::string& text) {
  // The writer has no look at what it was before.
  if (const auto now = texts_.find(handle); now != texts_.end() && now->second == text) return;
  texts_[handle] = text;
  fstWriterEmitVariableLengthValueChange(writer_, handle, text.data(),
                                         static_cast<std::uint32_t>(text.size()));
}

void Fst::close() {
  fstWriterClose(writer_);
  writer_ = nullptr;
  // The writer does not say that the disk was full; a file that is not whole cannot be opened.
  auto* const reader = fstReaderOpen(half_.path().c_str());
  if (reader == nullptr) throw InputError(fmt::format("{}: cannot write it whole", path_));
  fstReaderClose(reader);
  if (std::rename(half_.path().c_str(), path_.c_str()) != 0) {
    throw InputError(fmt::format("{}: cannot write: {}", path_, std::strerror(errno)));
  }
  half_.keep();
}

namespace {

// Opens and closes scopes so that those of `to` are open; `from` are.
void change_scope(Fst& fst, const std::vector<std::string>& from,
                  const std::vector<std::string>& to) {
  const auto [left, right] = std::mismatch(from.begin(), from.end(), to.begin(), to.end());
  for (auto i = left; i != from.end(); ++i) fst.close_scope();
  for (auto i = right; i != to.end(); ++i) fst.open_scope(*i);
}

std::vector<std::uint32_t> variables(Fst& fst, const char* scope, const WaveShape& shape,
                                     const std::vector<Bus>& buses) {
  fst.open_scope(scope);
  std::vector<std::uint32_t> handles;
  handles.reserve(buses.size());
  for (const Bus& b : buses) {
    handles.push_back(fst.variable(b.name, b.width, shape.range_of(b)));
  }
  fst.close_scope();
  return handles;
}

// The words of a wide number lie one behind the other, the lowest byte first.
static_assert(std::endian::native == std::endian::little);
void draw(Fst& fst, std::uint32_t handle, const Bus& bus, const std::vector<Word>& words) {
  fst.bytes(handle, bus.width, reinterpret_cast<const unsigned char*>(&words[bus.first]));
}

}  // namespace

Wave::Wave(const std::string& path) : path_(path), fst_(std::make_unique<Fst>(path)) {}

Wave::~Wave() = default;

void Wave::begin(const WaveShape& shape, const WaveRange& /*range*/,
                 const std::vector<Signal>& rtl) {
  shape_ = &shape;
  input_buses_ = buses_of(shape.inputs);
  buses_ = buses_of(shape.compared);
  rtl_ = rtl;
  Fst& fst = *fst_;
  fst.open_scope("cosim");
  clk_ = fst.variable("clk", 1);
  clock_ = fst.variable("clock", clock_width);
  inputs_ = variables(fst, "inputs", shape, input_buses_);
  expected_ = variables(fst, shape.sides.expected, shape, buses_);
  actual_ = variables(fst, shape.sides.actual, shape, buses_);
  fst.open_scope("mismatch");
  any_ = fst.variable("any", 1);
  for (const Bus& b : buses_) mismatch_.push_back(fst.variable(b.name, 1));
  fst.close_scope();
  if (!shape.texts.empty()) {
    fst.open_scope("text");
    for (const std::string& name : shape.texts) texts_.push_back(fst.text(name));
    fst.close_scope();
  }
  fst.open_scope("number");
  for (const Bus& b : buses_) {
    numbers_.push_back(has_number(b.field) ? fst.real(b.name) : 0);
    expected_numbers_.push_back(has_number(b.field) ? fst.real("expected_" + b.name) : 0);
  }
  fst.close_scope();
  std::vector<std::string> scope;
  for (const Probe& probe : shape.probes) {
    change_scope(fst, scope, {probe.scope});
    scope = {probe.scope};
    probes_.push_back(fst.variable(probe.name, probe.width));
    const bool both = probe.side == Probe::Side::both;
    expected_probes_.push_back(
        both ? fst.variable(std::string("expected_") + probe.name, probe.width) : 0);
  }
  change_scope(fst, scope, {});
  fst.close_scope();
  scope.clear();
  for (const Signal& s : rtl_) {
    change_scope(fst, scope, s.scope);
    scope = s.scope;
    rtl_handles_.push_back(fst.variable(s.name, s.width, s.range));
  }
  change_scope(fst, scope, {});
}

void Wave::clock(const WaveClock& now) {
  Fst& fst = *fst_;
  fst.time(now.clock * wave_period);
  fst.value(clk_, 1, 1);
  fst.value(clock_, clock_width, static_cast<Word>(now.clock));
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    draw(fst, inputs_[i], input_buses_[i], now.inputs);
  }
  for (std::size_t i = 0; i < expected_.size(); ++i) {
    const Bus& bus = buses_[i];
    draw(fst, expected_[i], bus, now.expected);
    draw(fst, actual_[i], bus, now.actual);
    fst.value(mismatch_[i], 1, now.differs_in(bus) ? 1 : 0);
    if (!has_number(bus.field)) continue;
    fst.number(numbers_[i], number_of(bus.field, now.actual[bus.first]));
    fst.number(expected_numbers_[i], number_of(bus.field, now.expected[bus.first]));
  }
  for (std::size_t i = 0; i < texts_.size(); ++i) fst.text(texts_[i], now.texts[i]);
  const auto& differs = now.differs;
  fst.value(any_, 1, std::ranges::find(differs, true) == differs.end() ? 0 : 1);
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const Probe& probe = shape_->probes[i];
    const bool expected = probe.side == Probe::Side::expected;
    fst.value(probes_[i], probe.width, expected ? now.expected_probes[i] : now.actual_probes[i]);
    if (probe.side == Probe::Side::both) {
      fst.value(expected_probes_[i], probe.width, now.expected_probes[i]);
    }
  }
  for (std::size_t i = 0; i < rtl_.size(); ++i) {
    // The clock is drawn as it looks, not as it stands when the signals are read.
    if (rtl_[i].is_clock) {
      const bool is_taken = rtl_[i].takes_edge == nullptr || *rtl_[i].takes_edge != 0;
      fst.value(rtl_handles_[i], 1, is_taken != rtl_[i].falls ? 1 : 0);
    } else {
      fst.bytes(rtl_handles_[i], rtl_[i].width, rtl_[i].bytes);
    }
  }
  fst.time(now.clock * wave_period + wave_period / 2);
  fst.value(clk_, 1, 0);
  for (std::size_t i = 0; i < rtl_.size(); ++i) {
    if (rtl_[i].is_clock) fst.value(rtl_handles_[i], 1, rtl_[i].falls ? 1 : 0);
  }
  end_ = (now.clock + 1) * wave_period;
}

void Wave::end(const WaveRange& range) {
  fst_->time(end_);
  fst_->close();
  write_view(path_, *shape_, range);
}

}  // namespace cosim
