#include "tb/util/place.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "model/core/input_error.h"

namespace cosim {
namespace {

std::optional<int> index_in(std::string_view text) {
  int value = 0;
  const char* end = text.data() + text.size();
  if (text.empty() || text.front() == '-') return {};
  if (const auto [stop, error] = std::from_chars(text.data(), end, value);
      error != std::errc() || stop != end) {
    return {};
  }
  return value;
}

// What the last pair of brackets of `text` holds, if it ends with one.
std::optional<std::string_view> bracket(std::string_view text) {
  const std::size_t open = text.rfind('[');
  if (!text.ends_with(']') || open == std::string_view::npos) return {};
  return text.substr(open + 1, text.size() - open - 2);
}

int bits_of(std::span<const Field> cells) {
  int bits = 0;
  for (const Field& f : cells) bits += f.width;
  return bits;
}

// In a memory: whole words, or parts of equal width that make up a word.
std::vector<Place> in_memory(const RtlNet& net, std::span<const Field> cells,
                             const std::string& what) {
  const Field& first = cells.front();
  if (first.index < 0) {
    throw InputError(fmt::format("{}: in the RTL it is a memory of {} words", what, net.words));
  }
  if (net.width % first.width != 0 || cells.back().width != first.width) {
    throw InputError(fmt::format("{}: elements of {} bits in the model, words of {} in the RTL",
                                 what, first.width, net.width));
  }
  const int parts = net.width / first.width;
  if (cells.size() != static_cast<std::size_t>(net.words) * static_cast<std::size_t>(parts)) {
    throw InputError(fmt::format("{}: {} elements in the model, {} in the RTL", what, cells.size(),
                                 net.words * parts));
  }
  std::vector<Place> places;
  for (const Field& f : cells) places.push_back({f.index / parts, f.index % parts * f.width});
  return places;
}

}  // namespace

NetPath net_path(const std::string& net) {
  NetPath found{net};
  const auto drop = [&] { found.path.resize(found.path.rfind('[')); };
  if (const auto inside = bracket(found.path)) {
    const std::size_t colon = std::min(inside->find(':'), inside->size());
    const auto high = index_in(inside->substr(0, colon));
    const auto low = index_in(inside->substr(std::min(colon + 1, inside->size())));
    if (high && low) {
      found.high = *high;
      found.low = *low;
      drop();
    }
  }
  if (const auto inside = bracket(found.path)) {
    if (const auto word = index_in(*inside)) {
      found.word = *word;
      drop();
    }
  }
  return found;
}

std::vector<Place> places_in(const RtlNet& net, std::span<const Field> cells,
                             const std::string& what) {
  NetPath path = net_path(cells.front().net);
  if (net.words > 0 && path.word < 0) {
    if (path.high >= 0)
      throw InputError(what + ": in the RTL it is a memory; write NAME[WORD][HIGH:LOW]");
    return in_memory(net, cells, what);
  }
  Place base;
  if (net.words > 0) {
    if (path.word >= net.words) {
      throw InputError(fmt::format("{}: the RTL's memory has {} words", what, net.words));
    }
    base.word = path.word;
  } else if (path.word >= 0) {
    if (path.high >= 0) throw InputError(what + ": in the RTL it is not a memory");
    path.high = path.low = path.word;
  }
  int width = net.width;
  if (path.high >= 0) {
    if (path.low > path.high || path.high >= net.width) {
      throw InputError(fmt::format("{}: the RTL has bits {} to 0", what, net.width - 1));
    }
    base.low = path.low;
    width = path.high - path.low + 1;
  }
  if (bits_of(cells) != width) {
    throw InputError(
        fmt::format("{}: {} bits in the model, {} in the RTL", what, bits_of(cells), width));
  }
  std::vector<Place> places;
  for (const Field& f : cells) places.push_back({base.word, base.low + f.low});
  return places;
}

std::vector<std::span<const Field>> rows_of(std::span<const Field> cells) {
  std::vector<std::span<const Field>> rows;
  for (std::size_t i = 0, end = 0; i < cells.size(); i = end) {
    end = i + 1;
    while (end < cells.size() && cells[end].index > 0) ++end;
    // What the shape does not have stands last.
    std::size_t present = end - i;
    while (present > 1 && cells[i + present - 1].width == 0) --present;
    if (cells[i].width != 0) rows.push_back(cells.subspan(i, present));
  }
  return rows;
}

}  // namespace cosim
