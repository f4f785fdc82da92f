// A struct at its shapes as the design that the harness sees.
#include "model/clocked/design.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/core/reset.h"

namespace cosim::clocked::test {

template <int W>
struct Kept {
  struct In {
    Bit rst;
    Rises tick;
    UInt<W> d;
  };
  struct Out {
    Int<4> down;
  };
  static constexpr auto reset = active_high<&In::rst>;

  UInt<W> wide = W;
  Array<UInt<3>, W / 20> few = {1, 2};
  OnesComplement<5, true> turned = 0;
  Auxiliary<Bit> own = 1;
  At<"part.down", Int<4>> down = -2;

  Out clock(const In& in) {
    const Out out{.down = down};
    wide = in.d;
    few[W / 20 - 1] = 7;
    turned = turned - 3;
    --down;
    return out;
  }

  struct Job {
    Range<-3, 3> number;
  };
  struct Driver {
    UInt<2> left = 3;

    In drive(const Job& job, In in) const {
      in.d = left + (job.number < 0);
      return in;
    }
    Bit driven(const Job&, const Out&) {
      --left;
      return left == 0;
    }
  };
};

struct KeptSays {
  static constexpr const char* name = "kept";
  static constexpr std::array<std::array<Parameter, 1>, 2> parameters{
      {{Parameter{"W", 40}}, {Parameter{"W", 100}}}};
  static constexpr std::array files{"", ""};
};

namespace {

using Design = DesignOf<KeptSays, Kept<40>, Kept<100>>;
constexpr Design::Params narrow{{0}}, broad{{1}};
using cosim::Word;

template <class Record>
std::string texts(const std::array<Field, Record::size>& fields, const Record& record) {
  std::string all;
  const auto words = to_words(record);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].width == 0) continue;
    all += label_of(fields[i]) + ':' + std::to_string(fields[i].width) + '=' +
           std::to_string(words[i]) + ' ';
  }
  return all;
}
std::string state(const Design::Params& p, const Design::State<Word>& s) {
  return texts(Design::State<Word>::fields(p), s);
}

TEST(StructDesign, HasTheCellsOfEachShape) {
  EXPECT_EQ(state(narrow, reset_state_of<Design, Word>(narrow)),
            "wide[39:0]:40=40 few[0]:3=1 few[1]:3=2 turned:5=0 own:1=1 down:4=-2 ");
  EXPECT_EQ(state(broad, reset_state_of<Design, Word>(broad)),
            "wide[63:0]:64=100 wide[99:64]:36=0 few[0]:3=1 few[1]:3=2 few[2]:3=0 few[3]:3=0 "
            "few[4]:3=0 turned:5=0 own:1=1 down:4=-2 ");
}

TEST(StructDesign, ItsRegistersAreCodesWithoutWhatIsTheModelsOwn) {
  const auto registers = Design::registers(narrow, reset_state_of<Design, Word>(narrow));
  const auto fields = Design::Registers<Word>::fields(narrow);
  EXPECT_EQ(texts(fields, registers),
            "wide[39:0]:40=40 few[0]:3=1 few[1]:3=2 turned:5=31 down:4=14 ");
  EXPECT_STREQ(fields.back().net, "part.down");
  EXPECT_EQ(to_words(registers)[fields.size() - 2], 0);
}

TEST(StructDesign, ClocksTheStruct) {
  auto in = reset_inputs_of<Design>();
  EXPECT_EQ(texts(Design::Inputs<Word>::fields(broad), in),
            "rst:1=1 tick:1=1 d[63:0]:64=0 d[99:64]:36=0 ");
  auto words = to_words(in);
  words[2] = -1;
  words[3] = 5;
  in = from_words<Design::Inputs<Word>>(words);
  const auto step = Design::next(broad, reset_state_of<Design, Word>(broad), in);
  EXPECT_EQ(state(broad, step.state),
            "wide[63:0]:64=-1 wide[99:64]:36=5 few[0]:3=1 few[1]:3=2 few[2]:3=0 few[3]:3=0 "
            "few[4]:3=7 turned:5=-3 own:1=1 down:4=-3 ");
  EXPECT_EQ(texts(Design::Outputs<Word>::fields(broad), step.outputs), "down:4=14 ");
}

// Of each job, though a driver goes on until it is 0.
TEST(StructDesign, ADriverBeginsAsItIsInitialized) {
  const auto fields = JobOf<Design>::job_fields(narrow);
  EXPECT_EQ(fields[0].low, -3);
  EXPECT_EQ(fields[0].high, 3);
  std::vector<JobOf<Design>> jobs(2);
  cosim::for_each_cell<JobOf<Design>>([&](auto cell, std::size_t) { cell(jobs[1]) = -1; });
  JobHost<Design> host(narrow, jobs);
  std::vector<Word> driven;
  Design::Inputs<Word> in;
  while (host.next(in, {})) driven.push_back(to_words(in)[2]);
  EXPECT_EQ(driven, (std::vector<Word>{3, 2, 1, 4, 3, 2}));
}

}  // namespace
}  // namespace cosim::clocked::test
