#include "model/toolpath/gcode.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/studies/toolpath/model/helpers.h"

namespace cosim::toolpath {
namespace {

using std::numbers::pi;

void expect_near(PointMm p, double x, double y) {
  EXPECT_NEAR(p.x, x, 2e-9);
  EXPECT_NEAR(p.y, y, 2e-9);
}

using Ends = std::vector<PointMm>;
Ends ends_of(const Program& p) {
  Ends ends;
  for (const Motion& m : p.motions) ends.push_back(m.end);
  return ends;
}

Motion last_of(std::string_view text) { return read(text).motions.back(); }

TEST(Gcode, MotionModesAreModal) {
  const Program p = read("G0X1\nY2\nG1X3\nY4 F100\nG00 Y5 X6");
  ASSERT_EQ(p.motions.size(), 5u);
  const MotionKind kinds[] = {MotionKind::rapid, MotionKind::rapid, MotionKind::feed,
                              MotionKind::feed, MotionKind::rapid};
  const PointMm ends[] = {{1, 0}, {1, 2}, {3, 2}, {3, 4}, {6, 5}};
  PointMm at;
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(p.motions[i].kind, kinds[i]) << i;
    EXPECT_EQ(p.motions[i].start, at) << i;
    EXPECT_EQ(p.motions[i].end, ends[i]) << i;
    at = ends[i];
  }
  EXPECT_EQ(p.motions[4].place, (Place{5, 5}));
}

TEST(Gcode, UnitsAndDistanceModesHoldFromTheirBlock) {
  const Program p = read("G20 G0 X1 Y-.5\nG91 X1\nG21 Y1 X-.8\nG90 X2");
  EXPECT_EQ(ends_of(p), (Ends{{25.4, -12.7}, {50.8, -12.7}, {50.0, -11.7}, {2, -11.7}}));
}

TEST(Gcode, IncrementsAddUpExactly) {
  std::string text = "G91 G1\n";
  for (int i = 0; i < 1000; ++i) text += "X.1 Y-.7\n";
  const Program p = read(text);
  EXPECT_EQ(p.motions.back().end, (PointMm{100, -700}));
  // 0.1 + 0.2 - 0.3 is not 0 in doubles.
  EXPECT_EQ(read("G91 G1 X.1\nX.2\nX-.3\nG90 X0\n").motions.size(), 3u);
}

TEST(Gcode, BlocksThatStayAreNoMotions) {
  const Program p = read("G0 X0 Y0\nX1\nX1 Y0\nG1 X1 Z-5\nG91 X0 Y0\nX1\n");
  ASSERT_EQ(p.motions.size(), 2u);
  EXPECT_EQ(p.motions[1].place.line, 6u);
  EXPECT_EQ(p.blocks, 6u);
  EXPECT_EQ(p.lines, 6u);
  EXPECT_EQ(p.other_axis_moves, 1u);
}

TEST(Gcode, OtherAxesAreCountedWhereTheyMove) {
  EXPECT_EQ(read("G0 X1 Z0\nZ5\nZ5\nA90 B1 C1\nU1 V1\nW1 X2\nG91 Z0 A0\nZ1\n").other_axis_moves,
            5u);
  // Inches scale a length, so 25.4 mm are no move from 1 inch; an angle stays.
  EXPECT_EQ(read("G20 G0 X1 Z1 A1\nG21 Z25.4 A1").other_axis_moves, 1u);
}

TEST(Gcode, WordsThatLeaveThePathAlone) {
  const Program p = read(
      "%\n(flange)\nN10 G17 G21 G90 G94 G54 G40 G49 G80 G64 P.01\nT1 M6\nS1000 M3 M8\nG43 H1\n"
      "G61\nG61.1\nG91.1\nG4 P1.5\nG96 D2000 S100\nG97\nG98\nG93\nG95\nG9 G0 X1\n"
      "M5 M9\nM30\nG28 garbage (\n");
  ASSERT_EQ(p.motions.size(), 1u);
  EXPECT_EQ(p.lines, 18u);
}

// Where no motion mode holds X is no move.
TEST(Gcode, XBesideG4IsATimeBeforeAnyMotion) {
  const Program p = read("G4 X8\nG04 U2 G20\nG1 X1\n");
  ASSERT_EQ(p.motions.size(), 1u);
  EXPECT_EQ(p.motions[0].start, (PointMm{0, 0}));
  EXPECT_EQ(p.motions[0].end, (PointMm{25.4, 0}));
  EXPECT_EQ(p.other_axis_moves, 0u);
}

// The line with which many programs begin, and a mode that it leaves.
TEST(Gcode, G80EndsNoMotion) {
  const Program p = read("G0 G17 G40 G49 G80 G90 X5\nG1 X6\nG80\nY7\n");
  ASSERT_EQ(p.motions.size(), 3u);
  EXPECT_EQ(p.motions[0].kind, MotionKind::rapid);
  EXPECT_EQ(p.motions[2].kind, MotionKind::feed);
  EXPECT_EQ(p.motions[2].end, (PointMm{6, 7}));
}

TEST(Gcode, TheProgramEndsAtM2M30AndPercent) {
  EXPECT_EQ(read("G0 X1 M2\nX2").motions.size(), 1u);
  EXPECT_EQ(read("G0 X1\nM30\n#").motions.size(), 1u);
  EXPECT_EQ(read("%\nG0 X1\n%\n#").motions.size(), 1u);
  EXPECT_EQ(read("G0 X1\nM3\nX2").motions.size(), 2u);
}

TEST(Gcode, TellsHowManyLinesItDidNotRead) {
  EXPECT_EQ(read("G0 X1\nM30\n%\n").lines_unread, 0u);
  EXPECT_EQ(read("G0 X1\nM30\nG0 X2\n\nM30\n").lines_unread, 2u);
  EXPECT_EQ(read("%\nG0 X1\n%\nO2\nG0 X2").lines_unread, 2u);
}

// G28, G53 and offsets of Z: X and Y stay, G91 holds on, G53 does not.
TEST(Gcode, MovesOfOtherAxesToTheMachinesPlacesLeaveXAndY) {
  const Program p = read("G0 X5\nG28 G91 Z0.\nX5\nG90 G53 G0 Z0.\nX4\nG2 G28 Z0\nG1 Z0\nX3");
  EXPECT_EQ(ends_of(p), (Ends{{5, 0}, {10, 0}, {4, 0}, {3, 0}}));
  EXPECT_EQ(p.other_axis_moves, 4u);  // where G28 left Z is not known: a move to 0
  EXPECT_EQ(read("G92 Z5\nG0 X2 Z5").other_axis_moves, 0u);
}

TEST(Gcode, OffsetsThatShiftNothing) {
  for (const char* text :
       {"G92 X0 Y0 Z0", "G92 S5000", "G92.1", "G92.2", "G52 X0 Y0 Z5", "G10 L20 P1 X0 Y0 Z0",
        "G10 L2 P1 Z-5", "G10 P0 L20 X0", "G53", "G28 Z0", "G90 G30 Z0 A0"}) {
    EXPECT_EQ(read(text + std::string("\nG0 X1 Y2")).motions.back().end, (PointMm{1, 2})) << text;
  }
  EXPECT_EQ(read("G20 G0 X1\nG21 G92 X25.4\nX2").motions.back().end, (PointMm{2, 0}));
}

TEST(Gcode, ArcsByTheirCentre) {
  Motion m = last_of("G0 X10\nG3 X0 Y10 I-10");
  EXPECT_EQ(m.kind, MotionKind::arc_ccw);
  EXPECT_EQ(m.centre, (PointMm{0, 0}));
  EXPECT_NEAR(m.sweep, pi / 2, 1e-12);
  EXPECT_FALSE(m.full_circle);
  m = last_of("G0 X10\nG2 X0 Y10 I-10 J0");
  EXPECT_EQ(m.kind, MotionKind::arc_cw);
  EXPECT_NEAR(m.sweep, 3 * pi / 2, 1e-12);
  m = last_of("G0 X3 Y4\nG91 G02 X0 Y-8 J-4 Z-1");
  EXPECT_EQ(m.centre, (PointMm{3, 0}));
  EXPECT_EQ(m.end, (PointMm{3, -4}));
  EXPECT_NEAR(m.sweep, pi, 1e-12);
  m = last_of("G20 G0 X1\nG3 X0 Y1 I-1");
  EXPECT_EQ(m.centre, (PointMm{0, 0}));
  EXPECT_EQ(m.end, (PointMm{0, 25.4}));
}

TEST(Gcode, ArcModeIsModal) {
  const Program p = read("G2\nX0 Y10 J5\nX10 R5 F1\n");
  ASSERT_EQ(p.motions.size(), 2u);
  EXPECT_EQ(p.motions[0].place, (Place{2, 1}));
  EXPECT_NEAR(p.motions[1].sweep, pi, 1e-7);
}

TEST(Gcode, FullCircles) {
  for (const char* text : {"G2 I5", "G2 X0 Y0 I5 J0", "G2 Y0 I5", "G91 G2 X0 I5", "G2 I5 Z1"}) {
    const Motion m = last_of(text);
    EXPECT_TRUE(m.full_circle) << text;
    EXPECT_EQ(m.sweep, 2 * pi) << text;
    EXPECT_EQ(m.centre, (PointMm{5, 0})) << text;
    EXPECT_EQ(m.end, (PointMm{0, 0})) << text;
  }
}

TEST(Gcode, AlmostFullCirclesAreTakenByTheirWords) {
  EXPECT_NEAR(last_of("G3 X0 Y-.001 I5").sweep, 0.001 / 5, 1e-9);
  EXPECT_NEAR(last_of("G2 X0 Y-.001 I5").sweep, 2 * pi - 0.001 / 5, 1e-9);
}

// From (10, 0) to (0, 10) with radius 10: the centres are (0, 0) and (10, 10). Anticlockwise about
// (0, 0) is a quarter, about (10, 10) three quarters; clockwise the other way round.
TEST(Gcode, ArcsByTheirRadius) {
  struct Case {
    const char* text;
    double centre;
    double quarters;
  };
  for (const Case& c : {Case{"G0 X10\nG3 X0 Y10 R10", 0, 1},
                        {"G0 X10\nG3 X0 Y10 R-10", 10, 3},
                        {"G0 X10\nG2 X0 Y10 R10", 10, 1},
                        {"G0 X10\nG2 X0 Y10 R-10", 0, 3}}) {
    const Motion m = last_of(c.text);
    expect_near(m.centre, c.centre, c.centre);
    EXPECT_NEAR(m.sweep, c.quarters * pi / 2, 1e-9) << c.text;
  }
}

TEST(Gcode, RadiusRoundedBelowHalfTheChordIsHalfACircle) {
  const Motion m = last_of("G2 X10 R4.998");  // the chord is 0.004 longer than 2 R
  expect_near(m.centre, 5, 0);
  EXPECT_NEAR(m.sweep, pi, 1e-12);
}

TEST(Gcode, ArcEndsMayBeOffByTheTolerance) {
  const auto accepts = [](const std::string& text) {
    return error_of([&] { read(text); }).empty();
  };
  EXPECT_TRUE(accepts("G2 X2.0049 I1"));  // 0.005 mm
  EXPECT_FALSE(accepts("G2 X2.0051 I1"));
  EXPECT_TRUE(accepts("G2 X200.099 I100"));  // a thousandth of 100 mm
  EXPECT_FALSE(accepts("G2 X200.101 I100"));
  EXPECT_TRUE(accepts("G2 X2000.49 I1000"));  // 0.5 mm
  EXPECT_FALSE(accepts("G2 X2000.51 I1000"));
  EXPECT_TRUE(accepts("G20 G2 X.2004 I.1"));  // 0.0005 inch
  EXPECT_FALSE(accepts("G20 G2 X.2006 I.1"));
  EXPECT_TRUE(accepts("G2 X2.0049 R1"));
  EXPECT_FALSE(accepts("G2 X2.0051 R1"));
}

}  // namespace
}  // namespace cosim::toolpath
