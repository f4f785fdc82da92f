// What yosys says of RTL that it does not read, in a line that a person can act on: what is wrong
// and where in the source.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tb/util/pattern.h"

namespace cosim::equiv {

/// Files by the names that yosys was given, and as a person calls them.
using FileNames = std::vector<std::pair<std::string, std::string>>;

/// "FILE:LINE: what is wrong", as far as it is known: without a name or a line of yosys's own.
/// `text` is what yosys printed until it ended; its log (yosys -l FILE) has more, as which register
/// it was at. `status` is how it ended: 128 and more by a signal.
std::string yosys_message(const std::string& text, int status, const FileNames& files);

struct Rule {
  Pattern pattern;   ///< of a message, with names as a person writes them
  std::string text;  ///< in its place: $1 as in Pattern, {signal} and its {reset}
};

/// The first that fits holds.
const std::vector<Rule>& yosys_rules();

}  // namespace cosim::equiv
