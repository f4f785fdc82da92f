// What a target of the fuzzer asks of the code it feeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "model/core/input_error.h"

/// The function that libFuzzer calls with each of its inputs. Returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace cosim::fuzz {

/// Ends the program where it does not hold: to libFuzzer a finding.
inline void expect(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", what.c_str());
  std::abort();
}

/// How often a text was taken.
inline int taken = 0;

/// Whether `read` took the text. It may refuse it by an InputError of one line that begins with
/// `name`, as what a person sees, and in no other way.
template <class Read>
bool accepted(const std::string& name, Read read) {
  try {
    read();
    ++taken;
    return true;
  } catch (const InputError& error) {
    const std::string line = error.what();
    expect(line.starts_with(name), "the error names the place: " + line);
    expect(line.find('\n') == std::string::npos, "the error is one line: " + line);
    return false;
  }
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace cosim::fuzz
