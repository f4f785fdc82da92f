// Whether a text has another one in it; a test that fails shows it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cosim::test {

inline testing::AssertionResult has(const std::string& text, const std::string& what) {
  const bool is = text.find(what) != std::string::npos;
  return testing::AssertionResult(is) << (is ? "has '" : "has no '") << what << "':\n" << text;
}

/// Each of them is in it.
inline void expect_has(const std::string& text, const std::vector<std::string>& all) {
  for (const std::string& what : all) EXPECT_TRUE(has(text, what));
}

}  // namespace cosim::test
