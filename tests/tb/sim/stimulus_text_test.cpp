// A stimulus as a file: it comes back the same, and what is none is refused in one line.
// Needs: linear, circular
#include "tb/sim/stimulus_text.h"

#include <gtest/gtest.h>

#include "tb/sim/bench.h"
#include "tests/designs/circular/records.h"
#include "tests/designs/linear/records.h"
#include "tests/support/error_of.h"

namespace cosim::test {
namespace {

const AnyBench& bench(std::string_view title) {
  for (const auto& b : benches()) {
    if (b->title() == title) return *b;
  }
  throw std::out_of_range(std::string(title));
}

// Words for each clock that reach every bit of every pin.
Stimulus sample(const AnyBench& bench, std::size_t clocks) {
  Stimulus s{bench.title(), "a sample", 4000000000U, {}, {}};
  Random random = Random::for_case(7, 0);
  for (std::size_t c = 0; c < clocks; ++c) {
    std::vector<Word> row;
    for (const Field& f : bench.inputs()) row.push_back(random.corner(f.width));
    s.clocks.push_back(row);
    if (c % 3 == 0) s.clocks.push_back(row);
  }
  return s;
}

std::string refusal(const std::string& text) {
  return test::error_of([&] { parse_stimulus("x.stim", text, benches()); });
}

TEST(StimulusFile, ComesBackAsItWas) {
  for (const auto& b : benches()) {
    Stimulus s = sample(*b, 200);
    for (const bool with_state : {false, true}) {
      if (with_state) {
        s.state = b->reset_state();
        s.state->front() = 1;
      }
      const auto [found, read] = parse_stimulus("x.stim", to_text(s, *b), benches());
      EXPECT_EQ(found, b.get());
      EXPECT_EQ(read.machine, s.machine);
      EXPECT_EQ(read.origin, s.origin);
      EXPECT_EQ(read.power_up, s.power_up);
      EXPECT_EQ(read.state, s.state);
      EXPECT_EQ(read.clocks, s.clocks);
    }
  }
}

TEST(StimulusFile, IsRefusedWhereverItIsCutOff) {
  const AnyBench& b = bench("circular W=4");
  Stimulus s = sample(b, 5);
  s.state = b.reset_state();
  const std::string text = to_text(s, b);
  // Without its last line feed it is still whole.
  for (std::size_t size = 0; size + 1 < text.size(); ++size) {
    const std::string line = refusal(text.substr(0, size));
    ASSERT_TRUE(line.starts_with("x.stim:")) << "cut off at " << size << ": " << line;
    ASSERT_EQ(line.find('\n'), std::string::npos);
  }
  EXPECT_EQ(refusal(text.substr(0, text.size() - 1)), "");
}

// A file of two clocks for the linear machine, its lines to be changed one at a time.
const std::vector<std::string> kLines = {"cosim stimulus 1",
                                         "machine linear M=5 N=2",
                                         "origin by hand",
                                         "power-up 3",
                                         "state trigger31=0 counter4=4",
                                         "clock initial_set_n reset write_bp write_uk start data",
                                         "0     1             0     1        0        0     27",
                                         "1-2   1             0     0        1        0     10",
                                         "end"};

std::string with(std::size_t line, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < kLines.size(); ++i) all += (i == line ? text : kLines[i]) + "\n";
  return all;
}

TEST(StimulusFile, IsReadAsAPersonWritesIt) {
  const auto [found, s] = parse_stimulus("x.stim", with(99, ""), benches());
  EXPECT_EQ(s.clocks, (std::vector<std::vector<Word>>{
                          {1, 0, 1, 0, 0, 27}, {1, 0, 0, 1, 0, 10}, {1, 0, 0, 1, 0, 10}}));
  // Remarks, empty lines, line ends of another system.
  EXPECT_EQ(refusal(with(2, "# a remark\n\r\norigin by hand\r")), "");
}

TEST(StimulusFile, HasItsColumnsInAnyOrder) {
  std::string text = with(5, "clock data initial_set_n reset write_bp write_uk start");
  text.replace(text.find("0     1"), std::string::npos, "0 27 1 0 1 0 0\nend\n");
  const auto [found, s] = parse_stimulus("x.stim", text, benches());
  EXPECT_EQ(s.clocks, (std::vector<std::vector<Word>>{{1, 0, 1, 0, 0, 27}}));
}

TEST(StimulusFile, IsRefusedWithTheLineAndTheReason) {
  const std::vector<std::tuple<std::size_t, std::string, std::string>> cases = {
      {0, "cosim stimulus 2", "x.stim:1: is not 'cosim stimulus 1'"},
      {1, "machine linear M=9 N=2",
       "x.stim:2: no machine 'linear M=9 N=2' is built; see cosim list"},
      {1, "machine spiral", "x.stim:2: no machine 'spiral' is built; see cosim list"},
      {1, "clock", "x.stim:2: is not 'machine DESIGN PARAMETER=VALUE...'"},
      {3, "power-up -1", "x.stim:4: power-up: needs a number of 0 to 4294967295"},
      {3, "power-up 4294967296", "x.stim:4: power-up: needs a number of 0 to 4294967295"},
      {3, "speed 3", "x.stim:4: 'speed' is not origin, power-up, state or clock"},
      {4, "state run=0", "x.stim:5: linear M=5 N=2 has no state 'run'"},
      {4, "state trigger31", "x.stim:5: 'trigger31' is not NAME=NUMBER"},
      {4, "state trigger31=2", "x.stim:5: 'trigger31=2' is out of range or no number"},
      {4, "state counter4=8", "x.stim:5: 'counter4=8' is out of range or no number"},
      {5, "clock reset write_bp write_uk start data",
       "x.stim:6: input initial_set_n has no column"},
      {5, "clock a initial_set_n reset write_bp write_uk start data",
       "x.stim:6: linear M=5 N=2 has no input 'a'"},
      {5, "clock data data initial_set_n reset write_bp write_uk start",
       "x.stim:6: 'data' is given twice"},
      {6, "0 1 0 1 0 0", "x.stim:7: 5 values for 6 inputs"},
      {6, "0 1 0 1 0 0 32", "x.stim:7: data: '32' is no value of 5 bits"},
      {6, "0 1 0 1 0 0 0x20", "x.stim:7: data: '0x20' is no value of 5 bits"},
      {6, "0 1 0 1 0 2 3", "x.stim:7: start: '2' is no value of 1 bit"},
      {6, "0 1 0 1 0 0 0x1", "x.stim:7: data: '0x1' is no value of 5 bits; write 1"},
      {6, "1 1 0 1 0 0 3", "x.stim:7: clock 1 instead of clock 0"},
      {6, "x 1 0 1 0 0 3", "x.stim:7: 'x' is no clock and no range of clocks"},
      {7, "2-1 1 0 1 0 0 3", "x.stim:8: '2-1' is no clock and no range of clocks"},
      {7, "1-99999999999 1 0 1 0 0 3", "x.stim:8: more than 1100000 clocks"},
      {7, "1-99999999999999999999 1 0 1 0 0 3",
       "x.stim:8: '1-99999999999999999999' is no clock and no range of clocks"},
      {8, "end here", "x.stim:9: text after 'end'"},
      {8, "end\n0 1 0 1 0 0 3", "x.stim:10: text after 'end'"},
      {8, "", "x.stim:9: the file ends before 'end': it is not complete"}};
  for (const auto& [line, text, reason] : cases) EXPECT_EQ(refusal(with(line, text)), reason);
}

// Any bytes: refused in one line, or read.
TEST(StimulusFile, TakesAnyBytes) {
  const std::string whole = with(99, "");
  Random random = Random::for_case(11, 0);
  for (int i = 0; i < 20000; ++i) {
    std::string text = whole;
    for (std::uint64_t changes = random.below(4) + 1; changes > 0; --changes) {
      text[random.below(text.size())] = static_cast<char>(random.below(256));
    }
    ASSERT_EQ(refusal(text).find('\n'), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace cosim::test
