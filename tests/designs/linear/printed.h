// The printed tables of SU 1631518 and its example, as tests that run on any bench of the linear
// machine: the model's and the RTL's.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/designs/linear/records.h"
#include "tests/support/recorder.h"

namespace cosim::linear::printed {

/// ROM 2 by address, position 1 leftmost.
inline constexpr std::array<Word, 8> kTable1 = {0b0000000, 0b0001000, 0b0100010, 0b0101010,
                                                0b1010101, 0b1011101, 0b1110111, 0b1111111};
/// ROM 11 with chip select 0, by remainder; with chip select 1 all ones.
inline constexpr std::array<Word, 8> kTable2 = {0b00000000, 0b10000000, 0b11000000, 0b11100000,
                                                0b11110000, 0b11111000, 0b11111100, 0b11111110};
/// The example, m = 5, n = 2: BP = 27, MP = 9, UK = 01010.
inline constexpr Line kExample = {27, 0b01010};
inline constexpr std::array<Word, 4> kTable3Major = {0b11111111, 0b11111111, 0b11111111,
                                                     0b11100000};
inline constexpr std::array<Word, 4> kTable3Minor = {0b01000101, 0b01000100, 0b01000101,
                                                     0b01000000};

/// A clock's outputs, and what the registers held on it.
struct Clock {
  std::size_t job;
  Shown outputs;
  Held registers;
};
using Clocks = std::vector<Clock>;

inline Clocks draw(const Bench<Design>& bench, const std::vector<Job>& jobs) {
  Clocks clocks;
  for (const auto& c : test::draw(bench, std::span<const Job>(jobs))) {
    clocks.push_back({c.job, named<Shown>(c.outputs), named<Held>(c.registers)});
  }
  return clocks;
}

/// The clocks of one job with a strobe.
inline Clocks strobed(const Clocks& clocks, std::size_t job) {
  Clocks found;
  for (const auto& c : clocks) {
    if (c.job == job && c.outputs.strobe != 0) found.push_back(c);
  }
  return found;
}

/// For shapes with 2^gamma = 8: the word of every address in register 9 and on the minor axis,
/// whose position 8 the low code of zeros leaves 0.
inline void expect_table1(const Bench<Design>& bench) {
  ASSERT_EQ(sizes_of(bench.params()).gamma(), 3);
  std::vector<Job> jobs;
  for (Code address = 0; address < 8; ++address) {
    jobs.push_back({{16, address << sizes_of(bench.params()).n}, {}});
  }
  const Clocks clocks = draw(bench, jobs);
  for (std::size_t address = 0; address < 8; ++address) {
    const Clocks words = strobed(clocks, address);
    ASSERT_EQ(words.size(), 2U);
    for (const auto& w : words) {
      EXPECT_EQ(w.registers.register9, kTable1[address]) << "address " << address;
      EXPECT_EQ(w.outputs.minor, kTable1[address] << 1) << "address " << address;
    }
  }
}

/// For shapes with 2^gamma = 8. Row 000 never comes to the outputs: with no remainder ROM 11 stays
/// selected.
inline void expect_table2(const Bench<Design>& bench) {
  ASSERT_EQ(sizes_of(bench.params()).gamma(), 3);
  std::vector<Job> jobs;
  for (std::int64_t major = 1; major < 24; ++major) jobs.push_back({{major, 0}, {}});
  const Clocks clocks = draw(bench, jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto major = static_cast<std::size_t>(jobs[i].line.major);
    const Clocks words = strobed(clocks, i);
    ASSERT_EQ(words.size(), (major + 7) / 8);
    for (std::size_t w = 0; w < words.size(); ++w) {
      const bool last_in_part = w + 1 == words.size() && major % 8 != 0;
      EXPECT_EQ(words[w].outputs.major, last_in_part ? kTable2[major % 8] : 0b11111111)
          << "BP = " << major << " word " << w;
    }
  }
}

/// For m = 5, n = 2: the words, and on the way to them the counts of the example.
inline void expect_table3(const Bench<Design>& bench) {
  ASSERT_EQ(sizes_of(bench.params()).m, 5);
  ASSERT_EQ(sizes_of(bench.params()).n, 2);
  const std::vector<Job> jobs = {{kExample, {}}};
  const Clocks clocks = draw(bench, jobs);

  // BP, UK, start, the first word formed, four words.
  ASSERT_EQ(clocks.size(), 8U + 1U);
  const auto& bp = clocks[1].registers;
  EXPECT_EQ(bp.counter4, 3);
  EXPECT_EQ(bp.register5, 3);
  const auto& uk = clocks[2].registers;
  EXPECT_EQ(uk.counter4, 4);
  EXPECT_EQ(uk.register5, 3);
  EXPECT_EQ(uk.register3, 0b10);
  EXPECT_EQ(uk.register9, 0b0100010);

  const std::array<Word, 4> multiplier = {1, 0, 1, 0};  // of code 10
  for (std::size_t w = 0; w < 4; ++w) {
    const auto& c = clocks[4 + w];
    EXPECT_EQ(c.outputs.busy, 1) << "word " << w;
    EXPECT_EQ(c.outputs.strobe, 1) << "word " << w;
    EXPECT_EQ(c.outputs.major, kTable3Major[w]) << "word " << w;
    EXPECT_EQ(c.outputs.minor, kTable3Minor[w]) << "word " << w;
    EXPECT_EQ(c.registers.trigger10, multiplier[w]) << "word " << w;
    EXPECT_EQ(c.registers.counter4, 3 - static_cast<Word>(w)) << "word " << w;
  }
  EXPECT_EQ(strobed(clocks, 0).size(), 4U);
  EXPECT_EQ(clocks.back().outputs.busy, 0);
}

}  // namespace cosim::linear::printed
