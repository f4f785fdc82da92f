#include "tb/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace cosim::cli {

ProgressLine::ProgressLine(std::string title)
    : title_(std::move(title)), terminal_(isatty(STDOUT_FILENO) == 1) {}

Progress ProgressLine::callback() {
  if (!terminal_) return {};
  return [this](std::uint64_t done, std::uint64_t cases) { draw(done, cases); };
}

void ProgressLine::draw(std::uint64_t done, std::uint64_t cases) const {
  constexpr std::size_t width = 30;
  const double part = cases == 0 ? 1 : static_cast<double>(done) / static_cast<double>(cases);
  const auto filled = std::min(width, static_cast<std::size_t>(part * width));
  fmt::print("\r{:3.0f} % [{:<{}}] {}\x1b[K", part * 100, std::string(filled, '#'), width, title_);
  std::fflush(stdout);
}

void ProgressLine::finish() {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
  fmt::print("{}{} ({:.1f} s)\n", terminal_ ? "\r\x1b[K" : "", title_, taken.count());
  std::fflush(stdout);
}

}  // namespace cosim::cli
