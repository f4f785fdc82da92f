// RTL without what it prints.
#include "tb/equiv/prints.h"

#include <gtest/gtest.h>

namespace cosim::equiv {
namespace {

// What is left of the text, without blanks; it keeps its length and its lines.
std::string left_of(const std::string& text) {
  std::string left = without_prints(text);
  EXPECT_EQ(left.size(), text.size());
  for (std::size_t i = 0; i < text.size(); ++i) EXPECT_EQ(left[i] == '\n', text[i] == '\n') << i;
  std::erase(left, ' ');
  return left;
}

TEST(Prints, GoAndAllElseStays) {
  EXPECT_EQ(left_of("a;$display(\"x\");b"), "a;;b");
  EXPECT_EQ(left_of("if(a)$write (\"(\\\" ;\", f(b), // )\n c);e"), "if(a)\n;e");
  EXPECT_EQ(left_of("$display;$displayed(1)+$signed(a)"), ";$displayed(1)+$signed(a)");
  EXPECT_EQ(left_of("$fatal(1, \"no end"), "");
  for (const char* kept :
       {"//$display(1)\n", "/*$write(1)*/", "\"$error(1)\"", "a$display(1)", "$"}) {
    EXPECT_EQ(left_of(kept), kept);
  }
}

}  // namespace
}  // namespace cosim::equiv
