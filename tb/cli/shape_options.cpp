#include "tb/cli/shape_options.h"

#include "tb/cli/number.h"

namespace cosim::cli {
namespace {

std::optional<int> small(const std::string& name, const std::string& text, std::uint64_t low) {
  if (text.empty()) return {};
  return static_cast<int>(whole(name, text, low, 32));
}

}  // namespace

void ShapeOptions::add_linear(CLI::App& command) {
  command.add_option("--m", m, "Bits of BP and UK; default: the smallest built that holds the work")
      ->type_name("M");
  command.add_option("--n", n, "Low bits of UK for the serial multiplier; 2^(M-N) steps a clock")
      ->type_name("N");
}

void ShapeOptions::add_circular(CLI::App& command) {
  command.add_option("--width", width, "Bits of a coordinate; default: the smallest built that holds the work")
      ->type_name("W");
}

LinearShape ShapeOptions::linear() const { return {small("--m", m, 2), small("--n", n, 1)}; }

CircularShape ShapeOptions::circular() const { return {small("--width", width, 2)}; }

}  // namespace cosim::cli
