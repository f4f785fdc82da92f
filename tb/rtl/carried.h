// Nets that carry the value of another one, as it is or inverted.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cosim::rtl {

class Carried {
 public:
  /// `to` has the value of `from` in its bits from `low` on.
  void carry(const std::string& from, const std::string& to, long low) {
    carries_[from].emplace_back(to, low);
  }
  /// `to` has its inverse.
  void invert(const std::string& from, const std::string& to) { inverts_[from].push_back(to); }

  /// All nets that carry the value of one, itself among them: from which of its bits on.
  std::map<std::string, long> carriers(const std::string& net) const;

  /// The nets that are the net itself, and those that are its inverse.
  struct Reach {
    std::set<std::string> same, inverse;
  };
  Reach reach(const std::string& net) const;

 private:
  std::map<std::string, std::vector<std::pair<std::string, long>>> carries_;
  std::map<std::string, std::vector<std::string>> inverts_;
};

}  // namespace cosim::rtl
