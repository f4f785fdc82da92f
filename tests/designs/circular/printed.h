// The printed tables of SU 1665343, R = 12 from (12, 0), as tests that run on any bench of the
// circular machine: the model's and the RTL's.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tests/designs/circular/records.h"
#include "tests/support/recorder.h"

namespace cosim::circular::printed {

/// What stands after a step. Table 1 has the steps and F; Table 2 the counters too, and beside some
/// of them the code, lowest digit first.
struct Row {
  char step;  ///< '|' in Y, '/' in both, '-' in X, '=' the correction
  Word ct7, ct8;
  double f;
  const char* code7 = "";
  const char* code8 = "";
};

inline constexpr std::array<Row, 18> kRows = {{
    {'|', 1, 10, 7.75, "1000", ""},
    {'|', 2, 9, 2.75, "0100", ""},
    {'|', 3, 8, -4.25, "1100", ""},
    {'/', 4, 6, 8.75, "", "0110"},
    {'|', 5, 5, -2.25, "1010", ""},
    {'/', 6, 3, 4.75, "", "1100"},
    {'|', 7, 2, -10.25, "1110", ""},
    {'/', 8, 0, -9.25, "", "0000"},
    {'/', 9, -2, -12.25, "", ""},
    {'=', 7, -1, 4.75, "", "0111"},
    {'/', 6, -3, -2.25, "", "0011"},
    {'-', 5, -4, 8.75, "1010", ""},
    {'/', 4, -6, -4.25, "", "1001"},
    {'-', 3, -7, 2.75, "1100", ""},
    {'/', 2, -9, -16.25, "", "0110"},
    {'-', 1, -10, -13.25, "1000", ""},
    {'-', 0, -11, -12.25, "0000", ""},
    {'-', -1, -12, -13.25, "", ""},
}};

/// The four lowest digits of a code, the lowest first, as the source prints them.
inline std::string low_digits(Word code) {
  std::string digits;
  for (int i = 0; i < 4; ++i) digits += bit(code, i) ? '1' : '0';
  return digits;
}

inline char sign_of(const Outputs<Word>& outputs) {
  const auto o = named<Shown>(outputs);
  return o.step_x != 0 ? (o.step_y != 0 ? '/' : '-') : o.step_y != 0 ? '|' : '=';
}

/// For every shape with 12 < 2^width.
inline void expect_tables(const Bench<Design>& bench) {
  const int width = width_of(bench.params());
  ASSERT_GE(width, 4);
  const std::vector<Arc> arcs = {{{12, 0}, 144, {}}};
  const auto clocks = test::draw(bench, std::span<const Arc>(arcs));

  // The load with the start, the rows, the reset at the end, the clock that shows it.
  ASSERT_EQ(clocks.size(), kRows.size() + 3);
  const auto expect_registers = [&](const Registers<Word>& registers, const Row& row, Word t16) {
    const auto r = named<Held>(registers);
    EXPECT_EQ(static_cast<double>(from_ones_complement(r.f, width + 4)) / 4, row.f);
    EXPECT_EQ(from_ones_complement(r.ct7, width + 1), row.ct7);
    EXPECT_EQ(from_ones_complement(r.ct8, width + 1), row.ct8);
    EXPECT_EQ(bit(r.ct8, width), row.ct8 < 0);  // above the digits printed stands the sign
    if (*row.code7 != '\0') EXPECT_EQ(low_digits(r.ct7), row.code7);
    if (*row.code8 != '\0') EXPECT_EQ(low_digits(r.ct8), row.code8);
    EXPECT_EQ(r.t16, t16);
    EXPECT_EQ(r.t4, 1);
  };
  expect_registers(clocks[1].registers, {' ', 0, 11, 10.75}, 0);
  Word t16 = 0;
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    SCOPED_TRACE("row " + std::to_string(i + 1));
    EXPECT_EQ(sign_of(clocks[1 + i].outputs), kRows[i].step);
    EXPECT_EQ(named<Shown>(clocks[1 + i].outputs).running, 1);
    if (kRows[i].step == '=') t16 = 1;
    expect_registers(clocks[2 + i].registers, kRows[i], t16);
  }
  const auto& end = clocks[1 + kRows.size()];  // cleared on its edge
  EXPECT_EQ(sign_of(end.outputs), '=');
  EXPECT_EQ(named<Shown>(end.outputs).running, 1);
  const auto& rest = clocks[2 + kRows.size()];
  EXPECT_EQ(named<Shown>(rest.outputs).running, 0);
  const auto at_rest = named<Held>(rest.registers);
  EXPECT_EQ(at_rest.t16, 0);
  EXPECT_EQ(at_rest.f, 3);
  EXPECT_EQ(at_rest.ct7, 0);
  EXPECT_EQ(at_rest.ct8, 0);
}

}  // namespace cosim::circular::printed
