// What the RTL's own text says of its registers and resets, by cosim_rtl, against what a design
// says.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/core/design.h"
#include "model/core/reset.h"

namespace cosim {

/// The registers, asynchronous resets and outputs as cosim_rtl prints them, without the first word.
struct RtlText {
  std::string title;              ///< of the shape, for errors
  std::string_view registers;     ///< lines "PATH WIDTH WORDS BITS [NET WIDTH WORDS LOW]..."
  std::string_view resets;        ///< lines "NAME" or "low NAME", "inner NAME" of a register
  std::string_view outputs = "";  ///< lines "NAME"
};

/// An input that reset_inputs() sets otherwise than rest(), and how.
struct ResetPin {
  std::string net;
  bool in_reset = false;
};

/// The registers of which some bit holds a state, is in no field and is allowed by a pattern, by
/// their paths, with those bits where fields have others: "count[7:4]", "store[3:1]" of a memory. A
/// pattern is such a path, with bits or without; a * in it stands for anything. InputError where
/// there is a bit that neither a field nor a pattern names, and where a pattern names none. Then
/// the outputs that a pattern names and no row of `outputs`.
std::vector<std::string> unobserved_signals(const RtlText& text, const std::vector<Field>& fields,
                                            const std::vector<std::string>& patterns,
                                            const std::vector<Field>& outputs = {});

bool matches_any(const std::vector<std::string>& patterns, std::string_view name);

/// When the resets of a design act, and on what.
enum class Resets {
  at_edge,
  at_once,      ///< one, on all: Design::asynchronous_reset
  each_at_once  ///< several, as the model's reset(p, s, in) says
};

/// InputError where the RTL has an asynchronous reset and the design has not, or the other way
/// round, and where reset_inputs() does not give all of them.
void require_resets(const RtlText& text, Resets resets, const std::vector<ResetPin>& pins);

/// InputError where a register that no reset reaches is no field of the state: the model could not
/// take it over.
void require_taken_over(const RtlText& text, const std::vector<Field>& registers,
                        const std::vector<Field>& state);

/// All three for a design; its unobserved registers and outputs.
template <class Design>
std::vector<std::string> require_registers(const RtlText& text, const typename Design::Params& p) {
  const auto held = Design::template Registers<Word>::fields(p);
  const auto patterns = Design::unobserved;
  std::vector<ResetPin> pins;
  if constexpr (has_reset<Design>) {
    const auto fields = Design::template Inputs<Word>::fields(p);
    const auto reset = to_words(reset_inputs_of<Design>()), rest = to_words(rest_of<Design>());
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (reset[i] == rest[i]) continue;
      pins.push_back({fields[i].net, reset[i] != 0});
    }
  }
  require_resets(text,
                 has_reset_function<Design>        ? Resets::each_at_once
                 : is_reset_asynchronous<Design>() ? Resets::at_once
                                                   : Resets::at_edge,
                 pins);
  const auto state = Design::template State<Word>::fields(p);
  require_taken_over(text, {held.begin(), held.end()}, {state.begin(), state.end()});
  const auto seen = Design::template Outputs<Word>::fields(p);
  return unobserved_signals(text, {held.begin(), held.end()}, {patterns.begin(), patterns.end()},
                            {seen.begin(), seen.end()});
}

}  // namespace cosim
