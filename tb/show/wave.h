// A waveform of a run: the RTL's whole hierarchy, and beside it what the model expects. All values
// of clock c stand from 10 c ns to 10 c + 10 ns, after the rising edge that caused them.
//
//   cosim.clk, cosim.clock         the clock, and its number
//   cosim.mismatch.any             1 where any compared signal differs
//   cosim.mismatch.NAME            1 where that one does
//   cosim.expected.NAME            what the model has in it
//   cosim.actual.NAME              what the RTL has in it
//   cosim.inputs.NAME              the pins driven
//   cosim.text.NAME                what passes at an interface, in words of the design's own
//   cosim.number.NAME              a ones' complement register of the RTL as the number it is
//   cosim.number.expected_NAME     and the model's
//   cosim.SCOPE.NAME               a probe of the design, by the side that it names or the RTL
//   cosim.SCOPE.expected_NAME      one of both sides, by the model
//   DESIGN....                     the RTL
//
// Where two RTLs are compared the scopes `expected` and `actual` are called by their names
// (WaveSides).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tb/show/signal.h"
#include "tb/show/wave_shape.h"

namespace cosim {

/// What takes a run clock by clock: the file of a wave, a picture.
class WaveSink {
 public:
  virtual ~WaveSink() = default;
  /// First. `shape` and `rtl`, the signals of the RTL, live until end(); the range's signal is not
  /// known yet.
  virtual void begin(const WaveShape& shape, const WaveRange& range,
                     const std::vector<Signal>& rtl) = 0;
  /// The next clock of the range; the RTL's signals are read as they are now.
  virtual void clock(const WaveClock& now) = 0;
  /// Last.
  virtual void end(const WaveRange& range) = 0;
};

class Fst;

/// The FST file, and beside it its view for GTKWave. InputError where one cannot be written.
class Wave final : public WaveSink {
 public:
  explicit Wave(const std::string& path);
  ~Wave() override;

  void begin(const WaveShape& shape, const WaveRange& range,
             const std::vector<Signal>& rtl) override;
  void clock(const WaveClock& now) override;
  void end(const WaveRange& range) override;

 private:
  std::string path_;
  std::unique_ptr<Fst> fst_;
  const WaveShape* shape_ = nullptr;
  std::vector<Bus> input_buses_, buses_;
  std::vector<Signal> rtl_;
  std::vector<std::uint32_t> rtl_handles_, inputs_, expected_, actual_, mismatch_, numbers_,
      expected_numbers_, probes_, expected_probes_, texts_;
  std::uint32_t clk_ = 0, clock_ = 0, any_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace cosim
