#include "tb/cli/progress.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace cosim::cli {
namespace {

// A line that fills the terminal would wrap, and \r go back to a part of it alone.
std::size_t columns() {
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return known ? size.ws_col - 1U : 79U;
}

}  // namespace

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
  const std::string line = fmt::format("{:3} % [{:<{}}] {}", static_cast<int>(part * 100),
                                       std::string(filled, '#'), width, title_);
  fmt::print("\r{}\x1b[K", line.substr(0, columns()));
  std::fflush(stdout);
}

void ProgressLine::finish(const std::string& text) {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
  fmt::print("{}{} ({:.1f} s)\n", terminal_ ? "\r\x1b[K" : "", text, taken.count());
  std::fflush(stdout);
}

}  // namespace cosim::cli
