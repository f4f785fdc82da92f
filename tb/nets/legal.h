// Inputs that a design's neighbour may give: the rules that the design states with legal(p, s, in).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "model/core/design.h"
#include "model/core/input_error.h"

namespace cosim {

/// The first rule that the inputs break in state s, a sentence; null where they break none.
template <class Design>
constexpr const char* broken_rule(const typename Design::Params& p,
                                  const typename Design::template State<Word>& s,
                                  const typename Design::template Inputs<Word>& in) {
  for (const auto& rule : legal_of<Word>(p, s, in)) {
    if (!rule.holds) return rule.sentence;
  }
  return nullptr;
}

/// The inputs of the next clock from `source`; false at its end. Where the design states rules, a
/// source sees the state of the model if it has next_legal(p, s, in), as a stimulus has that is
/// made up here. InputError where any other one, a host, breaks a rule.
template <class Design, class Source>
constexpr bool next_inputs(Source& source, const typename Design::Params& p,
                           const typename Design::template State<Word>& s,
                           typename Design::template Inputs<Word>& in,
                           const typename Design::template Outputs<Word>& out) {
  if constexpr (!has_legal<Design>) {
    return source.next(in, out);
  } else if constexpr (requires { source.next_legal(p, s, in); }) {
    return source.next_legal(p, s, in);
  } else {
    if (!source.next(in, out)) return false;
    if (const char* rule = broken_rule<Design>(p, s, in)) {
      throw InputError(std::string(Design::name) + ": its driver breaks an assumption: " + rule);
    }
    return true;
  }
}

/// Any source, for what is compiled once a design: sets the inputs of the next clock in the model's
/// state s, the outputs of the clock before being `last`; false at its end.
template <class Design>
using InputSource = std::function<bool(const typename Design::template State<Word>& s,
                                       typename Design::template Inputs<Word>& in,
                                       const typename Design::template Outputs<Word>& last)>;

/// A copy of `source` as one.
template <class Design, class Source>
InputSource<Design> source_of(const typename Design::Params& p, Source source) {
  return [p, source = std::move(source)](const auto& s, auto& in, const auto& last) mutable {
    return next_inputs<Design>(source, p, s, in, last);
  };
}

/// Where a stimulus ended because its next clock breaks a rule.
struct IllegalClock {
  std::uint64_t clock = 0;
  const char* rule = nullptr;  ///< null where none was broken

  /// InputError where one was.
  void refuse(const std::string& machine) const {
    if (rule == nullptr) return;
    throw InputError(machine + ": clock " + std::to_string(clock) +
                     ": inputs that break an assumption: " + rule);
  }
};

}  // namespace cosim
