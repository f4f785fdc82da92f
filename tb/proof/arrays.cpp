#include "tb/proof/arrays.h"

#include <set>

#include "tb/util/pattern.h"
#include "tb/util/read_file.h"

namespace cosim::proof {

std::map<std::string, Order> declared_arrays(const std::vector<std::filesystem::path>& files) {
  static const std::set<std::string> no_types{"return", "else", "begin", "assign", "case", "if"};
  static const Pattern comment(R"(//[^\n]*|/\*([^*]|\*(?!/))*\*/)");
  static const Pattern declared(
      R"(([A-Za-z_]\w*)(?:\s*\[[^\];]*\])*\s+([A-Za-z_]\w*)\s*\[([^\]:;]*)(:[^\];]*)?\]\s*[;,=])");
  std::map<std::string, Order> all;
  for (const std::filesystem::path& file : files) {
    const std::string text = comment.replaced(read_file(file.string()), " ");
    for (const Pattern::Parts& part : declared.all(text)) {
      if (no_types.contains(part[1])) continue;
      static const Pattern zero(R"(\s*0\s*)");
      const bool is_upward = part[4].empty() || !zero.whole(part[3]).empty();
      const Order order = is_upward ? Order::upward : Order::downward;
      const auto [known, is_new] = all.emplace(part[2], order);
      if (!is_new && known->second != order) known->second = Order::both;
    }
  }
  return all;
}

}  // namespace cosim::proof
