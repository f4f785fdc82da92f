#include "tb/sim/progress.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace cosim::cli {
namespace {

// A line as wide as the terminal would wrap, and \r would return only to its last part.
std::size_t columns(int terminal) {
  winsize size{};
  const bool known = ioctl(terminal, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
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
  fmt::print("\r{}\x1b[K", line.substr(0, columns(STDOUT_FILENO)));
  std::fflush(stdout);
}

double ProgressLine::finish(const std::string& text) {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
  fmt::print("{}{} ({:.1f} s)\n", terminal_ ? "\r\x1b[K" : "", text, taken.count());
  std::fflush(stdout);
  return taken.count();
}

StateLine::StateLine(Seconds often)
    : terminal_(isatty(STDERR_FILENO) == 1), redraws_([this, often] {
        std::unique_lock lock(guard_);
        while (!ended_.wait_for(lock, terminal_ ? Seconds(1) : often, [&] { return ends_; }))
          draw();
      }) {}

StateLine::~StateLine() {
  {
    const std::scoped_lock lock(guard_);
    ends_ = true;
  }
  ended_.notify_one();
  redraws_.join();
  clear();
}

void StateLine::show(std::function<std::string()> text) {
  const std::scoped_lock lock(guard_);
  text_ = std::move(text);
  if (terminal_) draw();
}

void StateLine::print(const std::string& text) {
  const std::scoped_lock lock(guard_);
  clear();
  fmt::print("{}", text);
  std::fflush(stdout);
  if (terminal_) draw();
}

void StateLine::draw() {
  if (!text_) return;
  const auto gone = std::chrono::duration_cast<Seconds>(std::chrono::steady_clock::now() - began_);
  const std::string line = fmt::format("{} s: {}", gone.count(), text_());
  if (!terminal_) return fmt::print(stderr, "{}\n", line);
  fmt::print(stderr, "\r{}\x1b[K", line.substr(0, columns(STDERR_FILENO)));
}

void StateLine::clear() const {
  if (terminal_) fmt::print(stderr, "\r\x1b[K");
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
