// Every kind of program that is refused, with the whole line that says so.
#include <gtest/gtest.h>

#include "tests/studies/toolpath/model/helpers.h"

namespace cosim::toolpath {
namespace {

struct WrongCase {
  const char* text;
  const char* error;
};

void PrintTo(const WrongCase& c, std::ostream* out) { *out << testing::PrintToString(c.text); }

class Refused : public testing::TestWithParam<WrongCase> {};

TEST_P(Refused, WithThePlaceAndTheReason) {
  EXPECT_EQ(error_of([] { read(GetParam().text); }), std::string("p.ngc:") + GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    Words, Refused,
    testing::ValuesIn<WrongCase>(
        {{"G1 X1\nG1 E5", "2:4: unknown word E"},
         {"G1 X1e999", "1:6: unknown word E"},
         {"G1 Xinf", "1:4: X needs a number"},
         {"L1", "1:1: unknown word L"},
         {"G1 X1 Y2 X3", "1:10: X is given twice in the block"},
         {"G2 X1 I1 K1", "1:10: K is not supported: it belongs to arcs in other planes than G17"},
         {"G0 X3000000000", "1:4: X is out of reach: more than 1e9 mm"},
         {"G91 G0 X9e8", "1:10: unknown word E"},
         {"G91 G0 X900000000\nX900000000", "2:1: X goes out of reach: more than 1e9 mm"}}));

INSTANTIATE_TEST_SUITE_P(
    Codes, Refused,
    testing::ValuesIn<WrongCase>(
        {{"G18", "1:1: G18 is not supported: only the XY plane, G17, is drawn"},
         {"G21\nN2 G19", "2:4: G19 is not supported: only the XY plane, G17, is drawn"},
         {"G28",
          "1:1: G28 without axis words is not supported: moves to stored positions are not "
          "drawn"},
         {"G30.1", "1:1: G30.1 is not supported: moves to stored positions are not drawn"},
         {"G41 D1", "1:1: G41 is not supported: cutter compensation would change the path"},
         {"G42", "1:1: G42 is not supported: cutter compensation would change the path"},
         {"G43.1", "1:1: G43.1 is not supported: its axis words would be offsets, not moves"},
         {"G53 G0 Z0 Y5",
          "1:11: Y beside G53 is not supported: moves in machine coordinates are not drawn"},
         {"G91 G28 X0",
          "1:9: X beside G28 is not supported: moves to stored positions are not drawn"},
         {"G55", "1:1: G55 is not supported: only the coordinate system G54 is drawn"},
         {"G59.3", "1:1: G59.3 is not supported: only the coordinate system G54 is drawn"},
         {"G92", "1:1: G92 is not supported here: it sets offsets that would change the path"},
         {"G0 X5\nG92 X0",
          "2:5: G92 is not supported here: it sets offsets that would change the path"},
         {"G52 X0 Y1",
          "1:8: G52 is not supported here: it sets offsets that would change the path"},
         {"G92.3", "1:1: G92.3 is not supported: coordinate offsets would change the path"},
         {"G92.1 X0", "1:7: X beside G92.1 is either a move or its argument"},
         {"G50 X0 Z5", "1:5: X beside G50 is either a move or its argument"},
         {"G10 L2", "1:1: G10 is not supported here: it sets offsets that would change the path"},
         {"G10 L2 P1 X0",
          "1:11: G10 is not supported here: it sets offsets that would change the path"},
         {"G10 L2 P1 Z0 R45",
          "1:14: G10 is not supported here: it sets offsets that would change the path"},
         {"G10 L50 Z1",
          "1:1: G10 is not supported here: it sets offsets that would change the path"},
         {"G54 P5", "1:5: P beside G54 names another coordinate system"},
         {"G54 G64 P1", "1:9: P beside G54 names another coordinate system"},
         {"G15 H2", "1:5: H beside G15 names another coordinate system"},
         {"G154 P1", "1:1: G154 is not supported: only the coordinate system G54 is drawn"},
         {"G71 P10 Q20", "1:1: G71 with P is not supported: canned cycles are not drawn"},
         {"G81", "1:1: G81 is not supported: canned cycles are not drawn"},
         {"G76", "1:1: G76 is not supported: canned cycles are not drawn"},
         {"G5 X1 Y1 I1 J1 P0 Q1",
          "1:1: G5 is not supported: it is no look-ahead mode (G5 P0 or P10000), and splines are "
          "not drawn"},
         {"G5.1 Q2",
          "1:1: G5.1 is not supported: it is no look-ahead mode (G5.1 Q0 or Q1), and splines "
          "are not drawn"},
         {"G38.2", "1:1: G38.2 is not supported: probing moves are not drawn"},
         {"G90.1", "1:1: G90.1 is not supported: arc centres are incremental, G91.1"},
         {"G223", "1:1: G223 is not a known code"},
         {"G1.5", "1:1: G1.5 is not a known code"},
         {"G-1", "1:1: this is not a known G code"},
         {"G1.23", "1:1: this is not a known G code"},
         {"G99999999999", "1:1: this is not a known G code"},
         {"M1.5", "1:1: this is not a known M code"},
         {"M98 P1", "1:1: M98 is not supported: repeats and subprograms are not run"},
         {"M198 P1", "1:1: M198 is not supported: repeats and subprograms are not run"},
         {"M96 P1", "1:1: M96 is not supported: repeats and subprograms are not run"},
         {"G0 M206 X5", "1:9: X beside an M code that takes arguments may be one"},
         {"G1 M117 X5", "1:9: X beside an M code that takes arguments may be one"},
         {"/G0 X5", "1:2: block delete '/' is not supported here: a switch would set the path"},
         {"/M30", "1:2: block delete '/' is not supported here: a switch would set the path"},
         {"G0 X1 /M8", "1:7: block delete '/' stands at the start of a line"},
         {"M72", "1:1: M72 is not supported: saved modes are not restored"},
         {"G0 G1 X1", "1:4: a second G code of one modal group in the block"},
         {"G20 G21", "1:5: a second G code of one modal group in the block"},
         {"G90 G91 X1", "1:5: a second G code of one modal group in the block"}}));

INSTANTIATE_TEST_SUITE_P(Motions, Refused,
                         testing::ValuesIn<WrongCase>(
                             {{"", "1:1: the program ends without a motion in X or Y"},
                              {"G1 Z5\nM2", "2:1: the program ends without a motion in X or Y"},
                              {"G1 X0 Y0\n", "2:1: the program ends without a motion in X or Y"},
                              {"G21\nX5", "2:1: X without a motion mode: G0, G1, G2 or G3"},
                              {"Z5", "1:1: Z without a motion mode: G0, G1, G2 or G3"},
                              {"G80 Y5", "1:5: Y without a motion mode: G0, G1, G2 or G3"},
                              {"G1 X1\nG4 X2", "2:4: X beside G4 is either a move or a time"},
                              {"G1 G4 X2", "1:7: X beside G4 is either a move or a time"},
                              {"G4 Y2", "1:4: Y beside G4 is either a move or a time"},
                              {"G4 X2 I1", "1:4: X without a motion mode: G0, G1, G2 or G3"},
                              {"G1 X1 I5", "1:7: I outside of an arc: it needs G2 or G3"},
                              {"G1 K0", "1:4: K outside of an arc: it needs G2 or G3"},
                              {"G1 L1", "1:4: unknown word L"},
                              {"R5", "1:1: R outside of an arc: it needs G2 or G3"}}));

INSTANTIATE_TEST_SUITE_P(
    Arcs, Refused,
    testing::ValuesIn<WrongCase>(
        {{"G2\nX1 Y2", "2:1: G2 needs a radius: I, J or R"},
         {"G3 Z5", "1:1: G3 needs a radius: I, J or R"},
         {"G3 Y5 R5 I5", "1:7: R beside I or J in an arc"},
         {"G3 Y5 I5 P2", "1:10: P other than 1 (turns) in an arc is not supported"},
         {"G3 Y5 I0 J0", "1:4: the arc's radius is 0"},
         {"G3 Y5 R0", "1:4: the arc's radius is 0"},
         {"G3 X0 R5", "1:4: an arc by R needs an end other than its start"},
         {"G3 X10.1 I5", "1:4: the arc's end is 0.1 mm off its circle; the tolerance is 0.005 mm"},
         {"G3 X.004 I.004", "1:4: the arc's end is its centre"},
         {"N5 G3 X11 R5",
          "1:7: the arc's chord is 1 mm longer than 2 R; the tolerance is 0.005 mm"}}));

TEST(Refused, MoreMotionsThanTheLimit) {
  std::string text = "G91 G0\n";
  for (std::size_t i = 0; i <= max_motions; ++i) text += "X1\n";
  EXPECT_EQ(error_of([&] { read(text); }),
            "p.ngc:1000002:1: the program is too long: more than 1000000 motions");
}

}  // namespace
}  // namespace cosim::toolpath
