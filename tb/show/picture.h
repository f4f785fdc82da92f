// A run as a page shows it: some clocks around the difference, or the first ones.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tb/show/wave.h"

namespace cosim {

struct WavePicture {
  std::string title;  ///< the machine
  WaveSides sides{};
  std::uint64_t first = 0;  ///< the clocks that it shows, both are in it
  std::uint64_t last = 0;
  std::uint64_t clocks = 0;  ///< of the run
  /// Signals that are not shown: elements of arrays that do not change there, and where there are
  /// too many for a page (`is_cut`) others.
  std::size_t left_out = 0;
  bool is_cut = false;
  std::string wave;              ///< HTML (svg.h)
  std::string path;              ///< SVG, where the design has one: probes x and y of one scope
  std::uint64_t path_first = 0;  ///< its clocks
  std::uint64_t path_last = 0;
};

/// Takes one run.
class PictureSink final : public WaveSink {
 public:
  PictureSink();
  ~PictureSink() override;
  void begin(const WaveShape& shape, const WaveRange& range,
             const std::vector<Signal>& rtl) override;
  void clock(const WaveClock& now) override;
  void end(const WaveRange& range) override;

  /// After end().
  WavePicture take() { return std::move(picture_); }

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
  WavePicture picture_;
};

/// Gives a run to two at once.
class BothSinks final : public WaveSink {
 public:
  BothSinks(WaveSink& one, WaveSink& other) : one_(one), other_(other) {}
  void begin(const WaveShape& shape, const WaveRange& range,
             const std::vector<Signal>& rtl) override {
    one_.begin(shape, range, rtl);
    other_.begin(shape, range, rtl);
  }
  void clock(const WaveClock& now) override {
    one_.clock(now);
    other_.clock(now);
  }
  void end(const WaveRange& range) override {
    one_.end(range);
    other_.end(range);
  }

 private:
  WaveSink &one_, &other_;
};

}  // namespace cosim
