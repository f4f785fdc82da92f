#include "tb/proof/located.h"

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "tb/support/place.h"

namespace cosim::proof {
namespace {

std::string word_net(const std::string& memory, int word) {
  return fmt::format("{}[{}]", memory, word);
}

int bits_in(const Expression& code) {
  return std::stoi(code.sort().substr(code.sort().find_last_of(' ')));
}

}  // namespace

std::vector<RtlCell> located_fields(const WiresOf& rtl, const std::string& design, const char* kind,
                                    const std::vector<Field>& fields) {
  std::vector<RtlCell> all;
  for (const auto& row : rows_of(fields)) {
    if (row.front().synchronizer != nullptr) {  // it is no pin
      all.push_back({"", 0, 0});
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
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto [word, low] = places[i];
      all.push_back({word < 0 ? path : word_net(path, first + word), low, row[i].width});
    }
  }
  return all;
}

std::vector<Piece> pieces_of(const Rtl& rtl, const RtlCell& cell) {
  std::vector<Piece> all;
  int high = rtl.width(cell.wire);
  for (const std::size_t i : rtl.pieces(cell.wire)) {
    // The symbol is bits low .. high-1 of the wire.
    const int low = high - rtl.free()[i].width;
    const int from = std::max(low, cell.low), to = std::min(high, cell.low + cell.width);
    if (from < to) all.push_back({i, from - low, to - from});
    high = low;
  }
  return all;
}

Expression during(const Rtl& rtl, const RtlCell& cell) {
  return cut(rtl.wire(cell.wire), cell.low, cell.width);
}

Expression after(const Rtl& rtl, const RtlCell& cell) {
  std::vector<Expression> codes;
  for (const Piece& p : pieces_of(rtl, cell)) {
    const Rtl::Free& f = rtl.free()[p.free];
    const Expression whole = as_code({f.after, f.is_bool ? boolean : bit_vector(f.width)});
    codes.push_back(cut(whole, p.low, p.width));
  }
  return joined(codes);
}

Expression joined(const std::vector<Expression>& codes) {
  Expression all = codes.at(0);
  for (std::size_t i = 1; i < codes.size(); ++i) {
    const int width = bits_in(all) + bits_in(codes[i]);
    all = {"concat", bit_vector(width), {all, codes[i]}};
  }
  return all;
}

}  // namespace cosim::proof
