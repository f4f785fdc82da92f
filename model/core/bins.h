// Functional coverage: what must have happened under the stimuli of a design, each a condition over
// one clock. A design declares its bins once; where a build measures coverage, lockstep counts
// them.
#pragma once

#include "model/core/value.h"

namespace cosim {

/// All that the model knows of one clock: the state and the inputs it began with, and the outputs
/// and the state it led to.
template <class Design>
struct Moment {
  const typename Design::Params& p;
  const typename Design::template State<Word>& before;
  const typename Design::template Inputs<Word>& in;
  const typename Design::template Outputs<Word>& out;
  const typename Design::template State<Word>& after;
};

template <class Design>
struct Bin {
  const char* name;                    ///< what must happen, in a few words
  bool (*hit)(const Moment<Design>&);  ///< whether it happens on this clock
};

/// A design that has bins overloads it: declared_bins(const Design*) gives them.
inline void declared_bins() {}

}  // namespace cosim
