#include "tb/proof/located.h"

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "tb/util/place.h"

namespace cosim::proof {
namespace {

std::string word_net(const std::string& memory, int word) {
  return fmt::format("{}[{}]", memory, word);
}

}  // namespace

std::vector<RtlCell> located_fields(const RtlNets& rtl, const std::string& design, const char* kind,
                                    const std::vector<Field>& fields) {
  std::vector<RtlCell> all;
  for (const auto& row : rows_of(fields)) {
    if (row.front().synchronizer != nullptr) {  // it is no pin
      all.push_back({});
      continue;
    }
    const std::string path = net_path(row.front().net).path;
    RtlNet net{rtl.width(path)};
    const int first = rtl.first_word(path);
    if (net.width == 0) {
      net.width = rtl.width(word_net(path, first));
      while (rtl.width(word_net(path, first + net.words)) != 0) ++net.words;
    }
    if (net.width == 0) {
      throw InputError(fmt::format("{}: {} {}: the RTL has no such net", design, kind, path));
    }
    const auto places =
        places_in(net, row, fmt::format("{}: {} {}", design, kind, row.front().net));
    const bool is_array =
        row.size() > 1 && !row.front().is_word && static_cast<int>(row.size()) != net.words;
    const bool is_upward = is_array && rtl.is_upward(path) && net.words == 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      auto [word, low] = places[i];
      if (is_upward) low = net.width - low - row[i].width;
      const std::string wire = word < 0 ? path : word_net(path, first + word);
      all.push_back({wire, low, rtl.bits(wire, low, row[i].width)});
    }
  }
  return all;
}

std::vector<RtlCell> located(const RtlNets& rtl, const std::string& design, const char* kind,
                             const std::vector<nets::Wire>& table) {
  std::vector<Field> fields;
  for (const nets::Wire& w : table) fields.push_back(w.field);
  return located_fields(rtl, design, kind, fields);
}

}  // namespace cosim::proof
