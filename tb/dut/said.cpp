#include "tb/dut/said.h"

#include <cstdarg>
#include <cstdio>
#include <utility>
#include <vector>

#include "tb/dut/said_print.h"

namespace cosim {
namespace {

thread_local RtlSaid first;
thread_local std::string error;  // the last that was printed

void say(const char* file, int line, const char* what) {
  std::string text = std::exchange(error, "");
  if (std::exchange(rtl_said, true)) return;
  // "[TIME] %Error: NAME:LINE: TEXT", the file without its folders.
  const std::string place = ':' + std::to_string(line) + ": ";
  const std::size_t at = text.find(place);
  text = at == std::string::npos ? what : text.substr(at + place.size());
  while (!text.empty() && text.back() == '\n') text.pop_back();
  first = {file, line, text};
}

}  // namespace

RtlSaid take_said() {
  rtl_said = false;
  return std::exchange(first, {});
}

}  // namespace cosim

// An error is kept until it is known where it was, everything else is printed.
int cosim_rtl_print(const char* format, ...) {
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int size = std::vsnprintf(nullptr, 0, format, arguments);
  va_end(arguments);
  std::vector<char> text(static_cast<std::size_t>(size < 0 ? 0 : size) + 1);
  std::vsnprintf(text.data(), text.size(), format, again);
  va_end(again);
  const std::string line(text.data());
  if (line.find("%Error") != std::string::npos || line.find("%Fatal") != std::string::npos) {
    cosim::error = line;
  } else {
    std::fputs(line.c_str(), stdout);
  }
  return size;
}

// What Verilated code calls.
void vl_stop(const char* file, int line, const char*) { cosim::say(file, line, "$stop"); }
void vl_finish(const char* file, int line, const char*) { cosim::say(file, line, "$finish"); }
