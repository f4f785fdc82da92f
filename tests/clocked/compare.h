// A model as it is compiled beside the file that the exporter wrote of it, on drawn states and
// inputs.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "model/clocked/model.h"
#include "tests/clocked/netlist.h"

namespace cosim::clocked::test {

using Random = std::mt19937_64;

/// A number of so many bits; 0, ones and small ones more often than others.
inline Wide drawn(Random& random, int width) {
  Wide value;
  const std::uint64_t kind = random() % 8;
  for (int i = 0; i < (width + 63) / 64; ++i)
    value[i] = kind == 0 ? 0 : kind == 1 ? ~0ull : random();
  if (kind == 2) value = Wide(random() % 4);
  if (kind == 3) value = ~Wide(random() % 4);
  return value & ~(~Wide(0) << width);
}
template <int W>
UInt<W> from_wide(const Wide& value) {
  return UInt<W>(UInt<most_bits>(Inside{}, value));
}
template <Value T>
Wide to_wide(const T& code) {
  return resized<Wide, false>(Inside::rep(Inside::base(code)));
}

/// Draws each cell of an object, and adds the codes to `codes`.
template <class T>
void draw(Random& random, T& object, std::vector<Wide>& codes) {
  for_each_cell(object, [&]<class Cell>(const Label&, Cell& cell) {
    codes.push_back(drawn(random, Cell::width));
    set_code(cell, from_wide<Cell::width>(codes.back()));
  });
}

template <class T>
void expect_codes(const T& object, const Netlist& netlist, const std::vector<Netlist::Cell>& cells,
                  Id Netlist::Cell::*node) {
  std::size_t i = 0;
  for_each_cell(object, [&](const Label& label, const auto& cell) {
    ASSERT_LT(i, cells.size());
    ASSERT_EQ(label.name, cells[i].name);
    ASSERT_TRUE(to_wide(code_of(cell)) == netlist.value(cells[i].*node)) << label.name;
    ++i;
  });
  ASSERT_EQ(i, cells.size());
}

inline Netlist exported(const std::string& name) {
  std::ifstream file(COSIM_EXPORTED "/" + name + ".btor2");
  return Netlist(file);
}

template <class Model>
void compare(const std::string& name, int clocks) {
  SCOPED_TRACE(name);
  Netlist netlist = exported(name);
  ASSERT_FALSE(netlist.outputs.empty());
  Random random(1);
  const Model initial{};
  std::size_t i = 0;
  netlist.run(std::vector<Wide>(netlist.inputs.size() + netlist.states.size()));
  for_each_cell(initial, [&](const Label& label, const auto& cell) {
    const Netlist::Cell& state = netlist.states.at(i++);
    ASSERT_EQ(state.init == 0, label.is_unreset) << label.name;
    if (state.init != 0)
      ASSERT_TRUE(to_wide(code_of(cell)) == netlist.value(state.init)) << label.name;
  });
  for (int n = 0; n < clocks && !testing::Test::HasFatalFailure(); ++n) {
    SCOPED_TRACE("clock " + std::to_string(n));
    std::vector<Wide> from;
    auto in = zero<typename Model::In>();
    Model model = initial;
    draw(random, in, from);
    draw(random, model, from);
    netlist.run(from);
    const typename Model::Out out = model.clock(in);
    expect_codes(out, netlist, netlist.outputs, &Netlist::Cell::node);
    expect_codes(model, netlist, netlist.states, &Netlist::Cell::next);
  }
}

}  // namespace cosim::clocked::test
