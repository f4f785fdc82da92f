#include "tb/cli/shape_options.h"

#include "tb/cli/number.h"

namespace cosim::cli {
namespace {

std::optional<int> small(const std::string& name, const Text& text, std::uint64_t low) {
  if (!text) return {};
  return static_cast<int>(whole(name, *text, low, 32));
}

}  // namespace

void ShapeOptions::add_linear(const Command& command, const std::string& otherwise) {
  command.text("--m", m, "M", "Linear machine: bits of BP and UK; default " + otherwise);
  command.text("--n", n, "N", "Linear machine: bits of its tick count; 2^(M-N) steps a clock");
}

void ShapeOptions::add_circular(const Command& command, const std::string& otherwise) {
  command.text("--width", width, "W",
               "Circular machine: bits of a coordinate; default " + otherwise);
}

void ShapeOptions::add_dda(const Command& command, const std::string& otherwise) {
  command.text("--width", width, "W", "DDA: bits of an accumulator; default " + otherwise);
}

LinearShape ShapeOptions::linear() const { return {small("--m", m, 2), small("--n", n, 1)}; }

CircularShape ShapeOptions::circular() const { return {small("--width", width, 2)}; }

DdaShape ShapeOptions::dda() const { return {small("--width", width, 2)}; }

}  // namespace cosim::cli
