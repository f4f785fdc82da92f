// Names that a project can have: of its files, and in the RTL that it is made of.
#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <set>

#include "model/core/input_error.h"
#include "tb/cli/new.h"
#include "tb/support/pattern.h"
#include "tb/support/words.h"

namespace cosim::cli {

void require_files(const std::string& name, const std::vector<std::string>& files,
                   const std::vector<std::string>& texts) {
  static const Pattern plain("[A-Za-z0-9_][A-Za-z0-9_.+-]*");
  const std::set<std::string> own{name + ".h", "CMakeLists.txt", "README.md"};
  std::map<std::string, std::string> seen;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string& file = files[i];
    const std::string base = std::filesystem::path(file).filename().string();
    if (plain.whole(base).empty()) {
      throw InputError(fmt::format(
          "new: {}: the name of a file in a project has letters, digits and _ . + - alone",
          in_quotes(file)));
    }
    if (own.contains(base)) {
      throw InputError(fmt::format("new: {}: the project has its own {}", in_quotes(file), base));
    }
    const auto [other, is_new] = seen.try_emplace(base, file);
    if (!is_new) {
      throw InputError(fmt::format("new: {} and {}: two files of one name",
                                   in_quotes(other->second), in_quotes(file)));
    }
    if (texts[i].starts_with("\xEF\xBB\xBF")) {
      throw InputError(fmt::format("new: {}: begins with a byte-order mark, which is no Verilog",
                                   in_quotes(file)));
    }
  }
}

void require_names(const Found& found) {
  static const Pattern plain(
      R"([A-Za-z_][A-Za-z0-9_$]*(\[\d+\])?(\.[A-Za-z_][A-Za-z0-9_$]*(\[\d+\])?)*)");
  const auto require = [](const std::string& of) {
    if (plain.whole(of).empty()) {
      throw InputError(fmt::format("new: {}: an escaped name is not supported", in_quotes(of)));
    }
  };
  require(found.top);
  require(found.clock);
  for (const auto* nets : {&found.inputs, &found.outputs, &found.registers}) {
    std::map<std::string, std::string> fields;
    for (const FoundNet& net : *nets) {
      require(net.name);
      const auto [other, is_new] = fields.try_emplace(field_of(net.name), net.name);
      if (!is_new) {
        throw InputError(fmt::format("new: {} and {}: both would be the field {}", other->second,
                                     net.name, other->first));
      }
    }
  }
  std::set<std::string> fields;
  for (const FoundParameter& p : found.parameters) {
    require(p.name);
    if (!fields.insert(field_of(p.name)).second) {
      throw InputError(fmt::format("new: {}: another parameter would have its name", p.name));
    }
  }
}

}  // namespace cosim::cli
