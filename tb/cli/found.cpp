#include "tb/cli/found.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "model/core/input_error.h"
#include "tb/cli/found_at.h"

namespace cosim::cli {
namespace {

// A width or depth that is one more where the parameter is one more follows it.
void follow(FoundSize& size, const FoundSize& wider, const FoundParameter& p) {
  if (wider.number != size.number + 1) return;
  size.parameter = p.name;
  size.more = size.number - p.value;
}
void follow(std::vector<FoundNet>& nets, const std::vector<FoundNet>& wider,
            const FoundParameter& p) {
  for (FoundNet& net : nets) {
    const auto same = std::find_if(wider.begin(), wider.end(),
                                   [&](const FoundNet& w) { return w.name == net.name; });
    if (same == wider.end()) continue;
    follow(net.width, same->width, p);
    follow(net.words, same->words, p);
  }
}

}  // namespace

Found found_in(const std::vector<std::string>& files, bool registers) {
  Found found = found_at(files, "", "", registers);
  for (const FoundParameter& p : found.parameters) {
    Found wider;
    try {
      wider = found_at(files, found.top, fmt::format(" -chparam {} {}", p.name, p.value + 1),
                       registers);
    } catch (const InputError&) {
      continue;  // the RTL does not take that one: its widths stand as numbers
    }
    follow(found.inputs, wider.inputs, p);
    follow(found.outputs, wider.outputs, p);
    follow(found.registers, wider.registers, p);
  }
  const std::set<std::string> high{"rst", "reset", "clear", "clr"};
  const std::set<std::string> low{"rst_n", "reset_n", "rstn", "resetn", "nrst", "aresetn"};
  for (const FoundNet& in : found.inputs) {
    if (found.asynchronous) break;
    std::string name = in.name;
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (in.width.number != 1 || !(high.contains(name) || low.contains(name))) continue;
    found.reset = in.name;
    found.active_low = low.contains(name);
  }
  return found;
}

}  // namespace cosim::cli
