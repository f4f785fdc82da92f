// Names that a project can have: of its files, and in the RTL that it is made of.
#include <fmt/core.h>

#include <map>
#include <set>

#include "model/core/input_error.h"
#include "tb/new/new.h"
#include "tb/util/pattern.h"
#include "tb/util/words.h"

namespace cosim::cli {

void require_files(const std::string& name, const Sources& sources) {
  static const Pattern plain("[A-Za-z0-9_][A-Za-z0-9_.+-]*"),
      path(R"((\.{1,2}/)*([A-Za-z0-9_][A-Za-z0-9_.+-]*/?)+)");
  const std::set<std::string> own{name + ".h", "CMakeLists.txt", "README.md", "include"};
  std::map<std::string, std::string> seen;
  const auto quoted = [](const SourceFile& file) { return in_quotes(file.from.string()); };
  for (const SourceFile& file : sources.files) {
    if (plain.whole(file.name).empty()) {
      throw InputError(fmt::format(
          "new: {}: the name of a file in a project has letters, digits and _ . + - alone",
          quoted(file)));
    }
    if (own.contains(file.name)) {
      throw InputError(fmt::format("new: {}: the project has its own {}", quoted(file), file.name));
    }
    const auto [other, is_new] = seen.try_emplace(file.name, file.from.string());
    if (!is_new) {
      throw InputError(fmt::format("new: {} and {}: two files of one name",
                                   in_quotes(other->second), quoted(file)));
    }
    if (file.text.starts_with("\xEF\xBB\xBF")) {
      throw InputError(
          fmt::format("new: {}: begins with a byte-order mark, which is no Verilog", quoted(file)));
    }
  }
  for (const SourceFile& file : sources.headers) {
    if (path.whole(file.name).empty()) {
      throw InputError(fmt::format(
          "new: {}: the name of a header in a project has letters, digits and _ . + - / alone",
          in_quotes(file.name)));
    }
  }
}

void require_names(const Found& found) {
  static const Pattern plain(
      R"([A-Za-z_][A-Za-z0-9_$]*(\[\d+\])*(\.[A-Za-z_][A-Za-z0-9_$]*(\[\d+\])*)*)");
  const auto require = [](const std::string& of) {
    if (plain.whole(of).empty()) {
      throw InputError(fmt::format("new: {}: an escaped name is not supported", in_quotes(of)));
    }
  };
  require(found.top);
  for (const FoundClock& clock : found.clocks) require(clock.name);
  for (const auto* nets : {&found.inputs, &found.outputs, &found.registers}) {
    for (const FoundNet& net : *nets) require(net.name);
  }
  const TakenNames taken("");
  std::set<std::string> fields;
  for (const FoundParameter& p : found.parameters) {
    require(p.name);
    if (!fields.insert(taken.other_than(p.name)).second) {
      throw InputError(fmt::format("new: {}: another parameter would get the same name", p.name));
    }
  }
}

}  // namespace cosim::cli
