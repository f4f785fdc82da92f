#include "tb/designs/dda/cli/settings.h"

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

// Whether it is the second of two names; the first where none is given.
bool is_second(const char* name, const Text& text, const char* first, const char* second) {
  const std::string value = text.value_or(first);
  if (value != first && value != second) {
    throw InputError(fmt::format("{}: {} is not {} or {}", name, in_quotes(value), first, second));
  }
  return value == second;
}

}  // namespace

void DdaSettings::add(const Command& command) {
  command.text("--update", update, "HOW",
               "parallel (default), as the source's hardware, or sequential, its flow chart");
  command.text("--preload", preload, "S", "Accumulators at the start: zero (default) or half");
  command.flag("--as-it-is", as_it_is, "Do not shift the rates of a line up first");
}

dda::Settings DdaSettings::parse() const {
  return {is_second("--update", update, "parallel", "sequential") ? dda::Update::sequential
                                                                  : dda::Update::parallel,
          is_second("--preload", preload, "zero", "half") ? dda::Preload::half : dda::Preload::zero,
          !as_it_is};
}

}  // namespace cosim::cli
