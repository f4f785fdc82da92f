// What a target of the fuzzer asks of the code it feeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "model/core/input_error.h"

/// FUZZ_TARGET(name) { ... }: feeds `text` to the code. libFuzzer calls it with each of its inputs,
/// the tests with each file of corpus/name/. In namespace cosim.
#ifdef COSIM_FUZZ
#define FUZZ_TARGET(name)                                                             \
  static void name##_target(const std::string& text);                                 \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
    name##_target({reinterpret_cast<const char*>(data), size});                       \
    return 0;                                                                         \
  }                                                                                   \
  static void name##_target([[maybe_unused]] const std::string& text)
#else
#define FUZZ_TARGET(name)                                                                \
  static void name##_target(const std::string& text);                                    \
  static const bool name##_added = fuzz::targets().emplace(#name, name##_target).second; \
  static void name##_target([[maybe_unused]] const std::string& text)
#endif

namespace cosim::fuzz {

using Target = void (*)(const std::string& text);

/// The targets of this program, by their names.
inline std::map<std::string, Target>& targets() {
  static std::map<std::string, Target> all;
  return all;
}

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

}  // namespace cosim::fuzz
