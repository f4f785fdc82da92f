// The steps of a machine that draws a path, whose model is a struct.
#pragma once

#include "model/clocked/design.h"

namespace cosim::clocked {

/// Calls take(dx, dy) for each step of a clock, in order, as the model's own for_each_step(out,
/// take) does.
template <class P, class O, class Take>
requires IsShape<P>
void for_each_step(const P& p, const ModelRecord<Word, O>& out, const Take& take) {
  P::Design::shaped(p, [&](auto of) {
    using M = typename decltype(of)::type;
    M::for_each_step(object_of<typename M::Out>(out), take);
  });
}

}  // namespace cosim::clocked
