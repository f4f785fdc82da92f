// The line of the source that an address of this program's code comes from. Exporter alone.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <string>

extern "C" const char __executable_start;  // by the linker

namespace cosim::clocked {

/// "uart.h:31" of the address a call returns to, where the program was compiled with -g1 or more
/// and there is an addr2line; else "address 0x...".
inline std::string source_line(const void* address) {
  std::uintptr_t at = reinterpret_cast<std::uintptr_t>(address) - 1;
  const auto start = reinterpret_cast<std::uintptr_t>(&__executable_start);
  if (start > 0xffffffffu) at -= start;  // a position-independent program
  char text[4096];
  std::snprintf(text, sizeof text, "addr2line -s -e /proc/%ld/exe 0x%llx 2> /dev/null",
                static_cast<long>(getpid()), static_cast<unsigned long long>(at));
  std::string line;
  if (std::FILE* pipe = popen(text, "r")) {
    if (std::fgets(text, sizeof text, pipe) != nullptr) line = text;
    pclose(pipe);
  }
  line = line.substr(0, line.find_first_of(" \n"));
  if (!line.empty() && line[0] != '?' && line.back() != '?') return line;
  std::snprintf(text, sizeof text, "address 0x%llx", static_cast<unsigned long long>(at));
  return text;
}

}  // namespace cosim::clocked
