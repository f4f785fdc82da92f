// Where the cells of a field lie in what the RTL has by its name.
#include "tb/util/place.h"

#include <gtest/gtest.h>

#include "model/clocked/records.h"
#include "model/core/input_error.h"

namespace cosim::test {
namespace {

template <int DEPTH>
struct Placed {
  clocked::UInt<5> plain;
  clocked::At<"unit.status[6:4]", clocked::UInt<3>> slice;
  clocked::Array<clocked::UInt<8>, DEPTH> memory;
  clocked::UInt<100> wide;
  clocked::At<"memory[2][7:4]", clocked::UInt<4>> word;
  clocked::At<"status[7]", clocked::Bit> one;
};
// Another shape has eight elements.
const auto fields = clocked::RecordTable<Placed<6>, Placed<8>>::fields({0});
// The cells of row i that a shape has.
std::span<const Field> row(std::size_t i) { return rows_of(fields)[i]; }

std::string told(const std::vector<Place>& places) {
  std::string text;
  for (const auto& [word, low] : places) {
    text += (text.empty() ? "" : " ") + std::to_string(word) + ':' + std::to_string(low);
  }
  return text;
}
std::string places(const RtlNet& net, std::size_t i) {
  try {
    return told(places_in(net, row(i), "here"));
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(NetPath, ReadsSlicesAndWords) {
  const auto is = [](const char* net, const char* path, int word, int high, int low) {
    const NetPath p = net_path(net);
    EXPECT_EQ(std::tuple(p.path, p.word, p.high, p.low), std::tuple(path, word, high, low)) << net;
  };
  is("a.b", "a.b", -1, -1, -1);
  is("a.b[7:4]", "a.b", -1, 7, 4);
  is("a[1].b[3]", "a[1].b", 3, -1, -1);
  is("m[3][7:4]", "m", 3, 7, 4);
  is("m[x]", "m[x]", -1, -1, -1);
  is("m[-1:0]", "m[-1:0]", -1, -1, -1);
}

TEST(Rows, AreTheCellsOfAFieldThatTheShapeHas) {
  const auto rows = rows_of(fields);
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[0].size(), 1U);
  EXPECT_EQ(rows[2].size(), 6U);
  EXPECT_EQ(rows[3].size(), 2U);
  EXPECT_EQ(rows[3][1].width, 36);
}

TEST(Places, AreBitsOfANetOrWordsOfAMemory) {
  EXPECT_EQ(places({5}, 0), "-1:0");
  EXPECT_EQ(places({10}, 1), "-1:4");
  EXPECT_EQ(places({8, 6}, 2), "0:0 1:0 2:0 3:0 4:0 5:0");
  EXPECT_EQ(places({48}, 2), "-1:0 -1:8 -1:16 -1:24 -1:32 -1:40") << "a net, from bit 0 up";
  EXPECT_EQ(places({16, 3}, 2), "0:0 0:8 1:0 1:8 2:0 2:8") << "two elements a word";
  EXPECT_EQ(places({100}, 3), "-1:0 -1:64");
  EXPECT_EQ(places({8, 4}, 4), "2:4");
  EXPECT_EQ(places({8}, 5), "-1:7");
}

TEST(Places, ThatDoNotFitAreRefusedWithBothNumbers) {
  EXPECT_EQ(places({6}, 0), "here: 5 bits in the model, 6 in the RTL");
  EXPECT_EQ(places({5, 4}, 0), "here: in the RTL it is a memory of 4 words");
  EXPECT_EQ(places({6}, 1), "here: the RTL has bits 5 to 0");
  EXPECT_EQ(places({8, 4}, 1), "here: in the RTL it is a memory; write NAME[WORD][HIGH:LOW]");
  EXPECT_EQ(places({8, 7}, 2), "here: 6 elements in the model, 7 in the RTL");
  EXPECT_EQ(places({9, 6}, 2), "here: elements of 8 bits in the model, words of 9 in the RTL");
  EXPECT_EQ(places({47}, 2), "here: 48 bits in the model, 47 in the RTL");
  EXPECT_EQ(places({100, 2}, 3), "here: elements of 64 bits in the model, words of 100 in the RTL");
  EXPECT_EQ(places({8, 2}, 4), "here: the RTL's memory has 2 words");
  EXPECT_EQ(places({8}, 4), "here: in the RTL it is not a memory");
}

}  // namespace
}  // namespace cosim::test
