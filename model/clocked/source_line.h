// The line of the source that an address of this program's code comes from. Exporter alone.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

extern "C" const char __executable_start;  // by the linker

namespace cosim::clocked {

struct SourceLine {
  std::string path;  ///< "/home/a/uart.h"; empty where it is not known
  int line = 0;
  std::string file() const { return path.substr(path.rfind('/') + 1); }
};

/// The lines of the addresses that calls return to, where the program was compiled with -g1 or more
/// and there is an addr2line. A function that is inlined stands for its caller if it is one of this
/// library or of the standard library.
inline std::map<const void*, SourceLine> source_lines(const std::vector<const void*>& addresses) {
  const auto start = reinterpret_cast<std::uintptr_t>(&__executable_start);
  std::string command = "addr2line -a -i -e /proc/" + std::to_string(getpid()) + "/exe";
  for (const void* address : addresses) {
    std::uintptr_t at = reinterpret_cast<std::uintptr_t>(address) - 1;
    if (start > 0xffffffffu) at -= start;  // a position-independent program
    char text[32];
    std::snprintf(text, sizeof text, " 0x%llx", static_cast<unsigned long long>(at));
    command += text;
  }
  std::map<const void*, SourceLine> all;
  std::FILE* pipe = popen((command + " 2> /dev/null").c_str(), "r");
  if (pipe == nullptr) return all;
  char* text = nullptr;
  std::size_t size = 0;
  auto next = addresses.begin();
  bool is_library = true;
  // "0x1234" of each address, then a line "/home/a/uart.h:31 (discriminator 2)" of each function
  // that it is in, the innermost one first.
  while (getline(&text, &size, pipe) > 0) {
    std::string line = text;
    line.resize(std::min(line.size(), line.find_first_of(" \n")));
    const std::size_t colon = line.rfind(':');
    if (line.starts_with("0x") && colon == std::string::npos) {
      is_library = true;
      ++next;
    } else if (next != addresses.begin() && is_library && colon != std::string::npos) {
      const int number = std::atoi(line.c_str() + colon + 1);
      if (number == 0) continue;
      const std::filesystem::path path = line.substr(0, colon);
      all[next[-1]] = {path.lexically_normal().string(), number};
      is_library = line.find("/model/clocked/") != std::string::npos ||
                   line.find("/include/c++/") != std::string::npos;
    }
  }
  std::free(text);
  pclose(pipe);
  return all;
}

/// "uart.h:31", or "address 0x..." where the line is not known.
inline std::string source_line(const void* address) {
  const SourceLine line = source_lines({address})[address];
  if (line.line != 0) return line.file() + ':' + std::to_string(line.line);
  char text[32];
  std::snprintf(text, sizeof text, "address %p", address);
  return text;
}

}  // namespace cosim::clocked
