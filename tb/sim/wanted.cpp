#include "tb/sim/wanted.h"

#include <fmt/core.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "model/core/input_error.h"
#include "tb/show/picture.h"

namespace cosim {

void draw_if_wanted(const AnyBench& bench, const std::function<Stimulus()>& stimulus) {
  static const char* const path = std::getenv("COSIM_WAVE");
  if (path == nullptr || *path == '\0') return;
  static std::atomic<bool> drawn{false};
  if (drawn.exchange(true)) return;
  try {
    Stimulus s = stimulus();
    s.machine = bench.title();
    if (!s.clocks.empty()) bench.draw_wave(path, s, wave_window);
  } catch (const InputError& error) {
    fmt::print(stderr, "COSIM_WAVE: {}\n", error.what());
  }
}

}  // namespace cosim
