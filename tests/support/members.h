// What an object of JSON is to have, as its text.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace cosim::test {

/// These members; it may have more.
inline void expect_members(const nlohmann::json& object, const char* expected) {
  const auto all = nlohmann::json::parse(expected);
  for (auto at = all.begin(); at != all.end(); ++at) {
    const auto found = object.find(at.key());
    EXPECT_TRUE(found != object.end() && *found == *at) << at.key() << " in " << object;
  }
}

}  // namespace cosim::test
