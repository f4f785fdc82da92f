#include "tb/sweep/progress.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace cosim::cli {
namespace {

// A line as wide as the terminal would wrap, and \r would return only to its last part.
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

StateLine::StateLine() : terminal_(isatty(STDOUT_FILENO) == 1) {}

StateLine::~StateLine() {
  if (terminal_) fmt::print("\r\x1b[K");
}

void StateLine::show(const std::string& text) const {
  if (!terminal_) return;
  fmt::print("\r{}\x1b[K", text.substr(0, columns()));
  std::fflush(stdout);
}

RunProgress::RunProgress(std::string title, std::uint64_t total, bool wanted)
    : line_(std::move(title)),
      total_(total),
      draw_(wanted && total != 0 ? line_.callback() : Progress{}),
      due_(std::chrono::steady_clock::now() + std::chrono::seconds(1)) {}

void RunProgress::draw(std::uint64_t done) {
  const auto now = std::chrono::steady_clock::now();
  if (now < due_) return;
  due_ = now + std::chrono::milliseconds(200);
  draw_(std::min(done, total_), total_);
  drawn_ = true;
}

void RunProgress::clear() {
  if (std::exchange(drawn_, false)) fmt::print("\r\x1b[K");
}

}  // namespace cosim::cli
