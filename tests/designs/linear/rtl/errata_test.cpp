// The errata of SU 1631518 that change what the machine draws. For each: what the source as printed
// would draw, on RTL changed to it; that lockstep finds it; and that the RTL as shipped does not.
//
// All at m = 5, n = 2, the shape of the source's example: 8 positions a word. The host writes BP on
// clock 0 and UK on clock 1, starts on clock 2, and the words show from clock 4 on.
#include <gtest/gtest.h>

#include <bit>

#include "model/linear/oracle.h"
#include "tests/designs/linear/records.h"
#include "tests/rtl/straight.h"

namespace cosim::linear {

static void PrintTo(const Words& w, std::ostream* out) { *out << w.major << '/' << w.minor; }

namespace {

using test::expect_found, test::expect_same;
using Script = test::Script<Design>;
using Record = test::Record<Design>;
using Variant = test::Variant<Design>;

constexpr int kM = 5, kGamma = 3;
constexpr std::int64_t kWord = 8;
constexpr Code kCode = 0b01010;  // the example's: B_2 + B_4
constexpr std::uint64_t kLastWord = 8;

const Variant& shipped() { return test::variant<Design>("shipped/m5_n2"); }
const Variant& printed(const std::string& name) { return test::variant<Design>("errata/" + name); }

Pins bp(Word steps) { return {.write_bp = 1, .data = steps}; }
Pins uk(Code code) { return {.write_uk = 1, .data = static_cast<Word>(code)}; }
Pins start() { return {.start = 1}; }

/// Enough clocks to the end of any line.
void finish(Script& script) { script.resize(script.size() + 10, Design::rest()); }

Script line(Word steps, Code code) {
  Script script = {bp(steps), uk(code), start()};
  finish(script);
  return script;
}

std::vector<Words> drawn(const Record& record) {
  std::vector<Words> words;
  for (const auto& clock : record) {
    const auto out = named<Shown>(clock.outputs);
    if (out.strobe == 0) continue;
    words.push_back({static_cast<std::uint64_t>(out.major), static_cast<std::uint64_t>(out.minor)});
  }
  return words;
}
std::vector<Words> drawn(const Variant& variant, const Script& script) {
  return drawn(test::play(variant, script));
}

std::vector<Words> exact(Word steps, Code code) {
  std::vector<Words> words;
  for (std::int64_t tick = 0; tick < ticks(kGamma, steps); ++tick) {
    words.push_back(words_at(kM, kGamma, {steps, code}, tick));
  }
  return words;
}

std::int64_t steps_of(const std::vector<Words>& words, std::uint64_t Words::*axis) {
  std::int64_t steps = 0;
  for (const Words& w : words) steps += std::popcount(w.*axis);
  return steps;
}
std::int64_t major_steps(const std::vector<Words>& w) { return steps_of(w, &Words::major); }
std::int64_t minor_steps(const std::vector<Words>& w) { return steps_of(w, &Words::minor); }

// Row 000 of Table 2 is 00000000, and the carry of counter 4 selects it for the last word.
TEST(LinearM5N2Errata, L1AsPrintedWipesTheLastFullWord) {
  const auto words = drawn(printed("l1"), line(24, kCode));
  EXPECT_EQ(words, (std::vector<Words>{{0xff, 0b01000101}, {0xff, 0b01000100}, {0, 0}}));
  EXPECT_EQ(major_steps(words), 24 - kWord);
  EXPECT_EQ(minor_steps(words), (6 + 2) - 3);  // B_2 + B_4, less the ones of 01000101
}

TEST(LinearM5N2Errata, L1AsPrintedLosesAWordOfOneLengthInEight) {
  for (Word steps = 1; steps < 32; ++steps) {
    auto words = exact(steps, kCode);
    if (steps % kWord == 0) words.back() = {0, 0};
    EXPECT_EQ(drawn(printed("l1"), line(steps, kCode)), words) << "BP = " << steps;
  }
}

TEST(LinearM5N2Errata, L1IsFoundByLockstep) {
  expect_found(printed("l1"), line(24, kCode), {4 + 2, "minor", 0b01000101, 0});
  expect_found(printed("l1"), line(24, 0), {4 + 2, "major", 0xff, 0});
}

TEST(LinearM5N2Errata, L1AsShippedDrawsEveryLength) {
  for (Word steps = 0; steps < 32; ++steps) {
    EXPECT_EQ(drawn(shipped(), line(steps, kCode)), exact(steps, kCode)) << "BP = " << steps;
    expect_same(shipped(), line(steps, kCode));
  }
}

// The example's own line: 27 = 3 * 8 + 3 has 4 words, and 4 is 0 in two bits.
TEST(LinearM5N2Errata, L2AsPrintedDrawsNothingOfTheExample) {
  const Record record = test::play(printed("l2"), line(27, kCode));
  EXPECT_TRUE(drawn(record).empty());
  std::int64_t busy = 0;
  for (const auto& clock : record) busy += named<Shown>(clock.outputs).busy;
  EXPECT_EQ(busy, 1);
}

TEST(LinearM5N2Errata, L2AsPrintedCountsWordsModuloFour) {
  for (Word steps = 0; steps < 32; ++steps) {
    const auto words = exact(steps, kCode);
    EXPECT_EQ(drawn(printed("l2"), line(steps, kCode)),
              words.size() == 4 ? std::vector<Words>{} : words)
        << "BP = " << steps;
  }
}

TEST(LinearM5N2Errata, L2IsFoundByLockstep) {
  expect_found(printed("l2"), line(27, kCode), {2, "counter4", 4, 0});
}

TEST(LinearM5N2Errata, L2AsShippedDrawsTheExample) {
  const auto words = drawn(shipped(), line(27, kCode));
  EXPECT_EQ(words, exact(27, kCode));
  EXPECT_EQ(major_steps(words), 27);
  EXPECT_EQ(minor_steps(words), 9);
}

Script code_twice() {
  Script script = {bp(27), uk(0), uk(kCode), start()};
  finish(script);
  return script;
}

TEST(LinearM5N2Errata, L8AsPrintedCountsTheRemainderWithEachWriteOfTheCode) {
  const auto words = drawn(printed("l8_code_twice"), code_twice());
  EXPECT_EQ(words.size(), 3 + 2u);
  EXPECT_EQ(major_steps(words), 27 + kWord);
}

TEST(LinearM5N2Errata, L8CodeTwiceIsFoundByLockstep) {
  expect_found(printed("l8_code_twice"), code_twice(), {3, "counter4", 4, 5});
}

TEST(LinearM5N2Errata, L8AsShippedCountsTheRemainderOnce) {
  EXPECT_EQ(drawn(shipped(), code_twice()), exact(27, kCode));
  expect_same(shipped(), code_twice());
}

/// The example's line, with a request on the clock that shows its first word.
Script disturbed(const Pins& request) {
  Script script = line(27, kCode);
  script[4] = request;
  return script;
}

// A new BP of one word: it comes after the word that shows and the one that is being formed.
TEST(LinearM5N2Errata, L8AsPrintedTakesBpWhileRunning) {
  const auto words = drawn(printed("l8_write_while_running"), disturbed(bp(8)));
  EXPECT_EQ(words.size(), 1 + 1 + 1u);
  EXPECT_EQ(major_steps(words), 3 * kWord);
}

TEST(LinearM5N2Errata, L8AsPrintedTakesACodeWhileRunning) {
  const auto words = drawn(printed("l8_write_while_running"), disturbed(uk(0)));
  EXPECT_EQ(minor_steps(words), 3);  // the first word's 01000101; 9 - 3 are lost
}

TEST(LinearM5N2Errata, L8WriteWhileRunningIsFoundByLockstep) {
  expect_found(printed("l8_write_while_running"), disturbed(bp(8)), {5, "trigger32", 1, 0});
  expect_found(printed("l8_write_while_running"), disturbed(uk(0)), {5, "register3", 0b10, 0});
}

TEST(LinearM5N2Errata, L8AsShippedLetsNoRequestDisturbALine) {
  Pins all = start();
  all.write_bp = all.write_uk = 1;
  for (const Pins& request : {bp(8), uk(0b10101), start(), all}) {
    Script script = line(27, kCode);
    for (std::size_t busy = 3; busy < kLastWord; ++busy) script[busy] = request;
    EXPECT_EQ(drawn(shipped(), script), exact(27, kCode));
    expect_same(shipped(), script);
  }
}

/// The example's line given up on the clock that shows its second word; then a code without a BP.
Script given_up() {
  Script script = {bp(27), uk(kCode), start(), Design::rest(), Design::rest()};
  script.insert(script.end(), {Pins{.initial_set_n = 0}, uk(kCode), start()});
  finish(script);
  return script;
}

// Counter 4 stands at 2 and goes to 3 for a remainder that is counted already, so that the last
// word has the two before it: 19 positions where 27 - 16 were left.
TEST(LinearM5N2Errata, L8AsPrintedKeepsALineThatWasGivenUp) {
  const auto words = drawn(printed("l8_initial_set"), given_up());
  EXPECT_EQ(words.size(), 2 + 3u);
  EXPECT_EQ(major_steps(words), 2 * kWord + 2 * kWord + 3);
}

TEST(LinearM5N2Errata, L8InitialSetIsFoundByLockstep) {
  expect_found(printed("l8_initial_set"), given_up(), {6, "counter4", 0, 2});
}

TEST(LinearM5N2Errata, L8AsShippedForgetsALineThatWasGivenUp) {
  auto words = exact(27, kCode);
  words.resize(2);
  EXPECT_EQ(drawn(shipped(), given_up()), words);
  expect_same(shipped(), given_up());
}

}  // namespace
}  // namespace cosim::linear
