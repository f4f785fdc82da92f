// All of a design that runs in lanes beside its RTL, as nets: its golden model, its hostile
// stimulus, and where a case begins.
#pragma once

#include <vector>

#include "model/core/design.h"
#include "tb/nets/draw.h"
#include "tb/nets/model.h"

namespace cosim::nets {

struct Played {
  Model model;
  Draw draw;
  /// The codes of the state after a reset, one for each of model.machine.state, and of the inputs
  /// that reset the design or, where none do, of those at rest.
  std::vector<Word> reset_state, reset_inputs;
};

template <class Design>
Played played_of(const typename Design::Params& p) {
  using State = typename Design::template State<Word>;
  using Inputs = typename Design::template Inputs<Word>;
  Played played{model_of<Design>(p), draw_of<Design>(p), {}, {}};
  const auto codes = [](const auto& record, const auto& fields) {
    std::vector<Word> all;
    const auto words = to_words(record);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].width != 0) all.push_back(cosim::low_bits(words[i], fields[i].width));
    }
    return all;
  };
  played.reset_state = codes(reset_state_of<Design, Word>(p), State::fields(p));
  Inputs reset = rest_of<Design>();
  if constexpr (has_reset<Design>) reset = reset_inputs_of<Design>();
  played.reset_inputs = codes(reset, Inputs::fields(p));
  return played;
}

}  // namespace cosim::nets
