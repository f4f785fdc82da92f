// RTL with a fault in lanes: what hostile clocks, or whole jobs, find of it there is what one case
// at a time finds.
#pragma once

#include <algorithm>

#include "tests/rtl/prove.h"
#include "tests/support/lane_sweeps.h"

namespace cosim::test {

template <class Design>
proof::Source source_of(const Variant<Design>& v) {
  return source_of(Design::name, v.name, *v.bench);
}

template <class Design>
std::unique_ptr<lanes::Built> in_lanes(const Variant<Design>& v, int lanes) {
  return lanes::built(v.bench->title(), nets::played_of<Design>(v.bench->params()), source_of(v),
                      lanes, COSIM_LANES_FOLDER);
}

/// Jobs find the fault in lanes as one at a time.
template <class Design>
void expect_jobs_find(const Variant<Design>& v, const Sweep& sweep) {
  SCOPED_TRACE(v.name + ": " + v.what);
  nets::Played played = nets::played_of<Design>(v.bench->params());
  played.draw = nets::draw_of_jobs<Design>(v.bench->params());
  const auto built = lanes::built(v.bench->title(), played, source_of(v), 512, COSIM_LANES_FOLDER);
  expect_same_failure(*v.bench, sweep, *built);
}

}  // namespace cosim::test
