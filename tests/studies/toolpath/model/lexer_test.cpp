#include "model/toolpath/lexer.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/studies/toolpath/model/helpers.h"

namespace cosim::toolpath {
namespace {

// The words of a text as "X10@1:3", the ends of lines as "|".
std::string words(std::string_view text) {
  Lexer lexer(text, "p.ngc");
  std::ostringstream out;
  for (;;) {
    const Token token = lexer.next();
    if (token.kind == Token::Kind::end_of_program) return out.str();
    if (token.kind == Token::Kind::end_of_block) {
      out << "| ";
    } else {
      out << token.letter << token.value << '@' << token.place.line << ':' << token.place.column
          << ' ';
    }
  }
}

struct LexerCase {
  const char* text;
  const char* expected;
};

void PrintTo(const LexerCase& c, std::ostream* out) { *out << testing::PrintToString(c.text); }

class Words : public testing::TestWithParam<LexerCase> {};

TEST_P(Words, AreRead) { EXPECT_EQ(words(GetParam().text), GetParam().expected); }

INSTANTIATE_TEST_SUITE_P(
    , Words,
    testing::Values(
        LexerCase{"", ""}, LexerCase{"G1X10Y5", "G1@1:1 X10@1:3 Y5@1:6 "},
        LexerCase{"g01 x+1 y-2", "G1@1:1 X1@1:5 Y-2@1:9 "},
        LexerCase{"X.5Y5.Z-.25", "X0.5@1:1 Y5@1:4 Z-0.25@1:7 "},
        LexerCase{"X 10\tY\t20", "X10@1:1 Y20@1:6 "},
        // The example of the RS274/NGC definition: blanks mean nothing.
        LexerCase{"g0x +0. 12 34y 7", "G0@1:1 X0.1234@1:3 Y7@1:14 "},
        LexerCase{"X1\nY2\r\nZ3\rA4", "X1@1:1 | Y2@2:1 | Z3@3:1 | A4@4:1 "},
        LexerCase{"X1\n", "X1@1:1 | "}, LexerCase{"\n\n X1", "| | X1@3:2 "},
        LexerCase{"(a ; b) X1 (c) Y2 ; d ( e\nX3", "X1@1:9 Y2@1:16 | X3@2:1 "},
        LexerCase{"( ( ) X1", "X1@1:7 "}, LexerCase{"( \xc3\xa9 ) X1 ; \xff\x01", "X1@1:8 "},
        LexerCase{"\xef\xbb\xbfX1", "X1@1:1 "}, LexerCase{"%\nX1\n%\nX2", "| X1@2:1 | "},
        LexerCase{" % (flange) ; 1\nX1\n", "| X1@2:1 | "}, LexerCase{"X1\n%\nX2", "X1@1:1 | "},
        LexerCase{"; head\n%\nX1", "| | X1@3:1 "}, LexerCase{"%\n%\nX1", "| "},
        LexerCase{"X00012.50", "X12.5@1:1 "}, LexerCase{"%00001\nX1\n%", "| X1@2:1 | "},
        LexerCase{"%\nO1000 (name)\nX1", "| | X1@3:1 "}, LexerCase{":1001\nX1", "| X1@2:1 "},
        LexerCase{"O1\n%\nX1", "| "}, LexerCase{"/X1", "/0@1:1 X1@1:2 "},
        LexerCase{"/2 M8", "/0@1:1 M8@1:4 "}, LexerCase{"( ( ) X1 (b)", "X1@1:7 "},
        LexerCase{"M117 Hello; X5\nX1", "M117@1:1 | X1@2:1 "},
        LexerCase{"M0 \xc3\x9c (x", "M0@1:1 "}, LexerCase{"M117", "M117@1:1 "},
        LexerCase{"M117 X 5", "M117@1:1 X5@1:6 "}));

TEST(Lexer, CountsTheLinesLeft) {
  const auto left = [](std::string_view text) {
    Lexer lexer(text, "p.ngc");
    Token token;
    do {
      token = lexer.next();
    } while (token.kind == Token::Kind::word);
    return lexer.lines_left();
  };
  EXPECT_EQ(left("M30"), 0u);
  EXPECT_EQ(left("M30\n%\n"), 0u);
  EXPECT_EQ(left("M30\r\n\r\n \t\r\n(end) \r\n; end\r\n % "), 0u);
  EXPECT_EQ(left("M30\n%\nO2\r\nG0 X1\r(a) X2\n(a)(b) M30\n%"), 4u);
}

TEST(Lexer, RefusesWithThePlace) {
  // Behind "p.ngc:".
  const auto error = [](std::string_view text) {
    const std::string said = error_of([&] { words(text); });
    return said.starts_with("p.ngc:") ? said.substr(6) : "no place: " + said;
  };
  EXPECT_EQ(error("X1\n (open\nX2)"), "2:2: the comment is not closed on its line: ')' missing");
  EXPECT_EQ(error("X1 )"), "1:4: ')' without '('");
  EXPECT_EQ(error("% G0 X1\nX2"), "1:3: the '%' that opens the program stands alone on its line");
  EXPECT_EQ(error("X"), "1:1: X needs a number");
  EXPECT_EQ(error("X Y1"), "1:1: X needs a number");
  EXPECT_EQ(error("X+-1"), "1:1: X needs a number");
  EXPECT_EQ(error("X1-1"), "1:3: unexpected '-'");
  EXPECT_EQ(error("X1.2.3"), "1:5: unexpected '.'");
  EXPECT_EQ(error("X."), "1:1: X needs a number");
  EXPECT_EQ(error("12"), "1:1: unexpected '1'");
  EXPECT_EQ(error("Xnan"), "1:1: X needs a number");
  EXPECT_EQ(error("G1 x" + std::string(400, '9')), "1:4: the number of X is out of range");
  EXPECT_EQ(error("X#5"), "1:2: parameters ('#') are not supported");
  EXPECT_EQ(error("#5=1"), "1:1: parameters ('#') are not supported");
  EXPECT_EQ(error("X[1+2]"), "1:2: expressions ('[') are not supported");
  EXPECT_EQ(error("O100 sub"), "1:1: O-words (subprograms and flow control) are not supported");
  EXPECT_EQ(error("o<a> call"), "1:1: O-words (subprograms and flow control) are not supported");
  EXPECT_EQ(error("N1 G0*57"), "1:6: checksums and expressions ('*') are not supported");
  EXPECT_EQ(error("\n:X1"), "2:1: a program number needs digits");
  EXPECT_EQ(error(":1 X1"), "1:4: the program number stands alone on its line");
  EXPECT_EQ(error("O1\nO2"), "2:1: a program number stands before the first word");
  EXPECT_EQ(error("X1\n:2"), "2:1: a program number stands before the first word");
  EXPECT_EQ(error("%12 X1"), "1:5: the '%' that opens the program stands alone on its line");
  EXPECT_EQ(error("X1 (a (b) c)"),
            "1:7: a comment within a comment: controls disagree on where it ends");
  EXPECT_EQ(error("((b) G1 X5) Y1"),
            "1:2: a comment within a comment: controls disagree on where it ends");
  EXPECT_EQ(error("M0 CR=5 X1"), "1:4: C needs a number");
  EXPECT_EQ(error("M117 X[5]"), "1:7: expressions ('[') are not supported");
  EXPECT_EQ(error("X1 \xc3\xa9"), "1:4: unexpected byte 0xc3");
  EXPECT_EQ(error(std::string_view("X1\nX\0002", 6)), "2:1: X needs a number");
  EXPECT_EQ(error(std::string_view("\0X1", 3)), "1:1: NUL byte: this is not a text file");
  EXPECT_EQ(error(std::string_view("(\0)", 3)), "1:2: NUL byte: this is not a text file");
  EXPECT_EQ(error(std::string_view(";a\0", 3)), "1:3: NUL byte: this is not a text file");
  EXPECT_EQ(error("X1 %"), "1:4: unexpected '%'");
}

TEST(Lexer, TheNameStaysOnOneLine) {
  EXPECT_EQ(error_of([] { Lexer("X", "a\nb\x7f").next(); }), "a?b?:1:1: X needs a number");
}

}  // namespace
}  // namespace cosim::toolpath
