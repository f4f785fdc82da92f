// The hash of what stands on standard input, as a checkpoint keeps it.
#include <fmt/core.h>

#include <iostream>
#include <iterator>
#include <string>

#include "tb/util/hash.h"

int main() {
  const std::string text(std::istreambuf_iterator<char>(std::cin), {});
  fmt::print("{}\n", cosim::hash_of(text));
}
