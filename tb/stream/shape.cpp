#include "tb/stream/shape.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

// Of a field behind the prefix: "head_tag" of "head.tag", "lanes_3_on" of "lanes[3].on".
std::string port_of(std::string_view field) {
  std::string port;
  for (const char c : field) {
    if (c != ']') port += c == '.' || c == '[' ? '_' : c;
  }
  return port;
}

}  // namespace

void StreamShape::set_clocks(const char* one, std::string_view several) {
  clocks.clear();
  if (*one != '\0') clocks.push_back({one});
  for (const std::string& line : lines_in(several)) {
    const std::string mark = "falling ";
    const bool falls = line.starts_with(mark);
    clocks.push_back({falls ? line.substr(mark.size()) : line, falls});
  }
}

void StreamShape::add(const StreamPorts& ports, bool goes_in, std::span<const Field> cells,
                      OwnDriver own) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("{}: stream {}: {}", title, ports.name, why));
  };
  Interface i;
  i.name = ports.name;
  i.goes_in = goes_in;
  const std::string prefix = ports.prefix != nullptr ? ports.prefix : i.name + '_';
  const auto port = [&](const char* given, const char* usual) {
    return given != nullptr ? std::string(given) : prefix + usual;
  };
  i.own = std::move(own);
  const bool usual = !i.own.is_there();
  if (usual) i.valid = port(ports.valid, "valid");
  if (usual && ports.has_ready) i.ready = port(ports.ready, "ready");
  if (ports.credits > 0) i.credit = port(ports.credit, "credit");
  if (ports.done != nullptr) i.done = ports.done;
  i.credits = ports.credits;
  i.latency = ports.latency;
  i.pulse = ports.pulse;
  i.steady = ports.steady;
  if (goes_in && (i.latency >= 0 || i.pulse || i.steady)) {
    refuse("latency(), rising() and steady() are for outputs only");
  }
  if (!usual && (i.credits > 0 || !i.done.empty() || i.pulse)) {
    refuse("a stream with a driver of its own cannot have credit(), until() or rising()");
  }
  if (!goes_in && !i.done.empty()) refuse("until() is for inputs only");
  const auto clock = std::ranges::find_if(clocks, [&](const StreamClock& c) {
    return ports.clock != nullptr && c.port == ports.clock;
  });
  if (clock != clocks.end()) {
    i.clock = static_cast<std::size_t>(clock - clocks.begin());
  } else if (ports.clock != nullptr) {
    refuse(fmt::format("clock(\"{}\"): the design has no such clock", ports.clock));
  } else if (clocks.size() > 1) {
    refuse("the design has several clocks; name that of the stream with clock(\"PORT\")");
  }

  if (goes_in) column({kept(i.name + "_give"), 1, Format::flag, "", "there is a transaction"});
  if (i.can_stall() || goes_in) {
    column({kept(i.name + "_stall"), stall_width, Format::number, "", "clocks before it"});
  }
  if (i.can_wait()) column({kept(i.name + "_waits"), 1, Format::flag, "", "ready waits for valid"});
  for (Field cell : cells) {
    if (!cell.is_placed) cell.net = kept(prefix + port_of(cell.name));
    cell.name = kept(i.name + '_' + cell.name);
    i.cells.push_back(cell);
    if (goes_in) column(cell);
  }
  i.draws.resize(i.cells.size());
  (goes_in ? in : out).push_back(std::move(i));
}

void StreamShape::draw(Interface& i, std::size_t cell,
                       std::span<const clocked::Share> shares) const {
  const Field& field = i.cells[cell];
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("{}: draws() of {}: {}", title, label_of(field), why));
  };
  if (field.is_word) refuse("it has more than 64 bits, and no rule says how it is drawn");
  CellDraw& draw = i.draws[cell];
  if (!draw.shares.empty()) refuse("it has two rules");
  for (const clocked::Share& share : shares) {
    const auto holds = [&](std::int64_t value) {
      const Word code = low_bits(static_cast<Word>(value), field.width);
      return units_of(field, code) == static_cast<Word>(value) &&
             (field.named == 0 || static_cast<std::size_t>(code) < field.named);
    };
    for (const std::int64_t value : {share.low, share.high}) {
      if (!share.is_any && !holds(value)) refuse(fmt::format("{} is no value of it", value));
    }
    if (share.low > share.high) refuse(fmt::format("{} is above {}", share.low, share.high));
    draw.shares.push_back({share.low, share.high, share.weight, share.is_any});
    draw.total += share.weight;
  }
  if (draw.total == 0 || draw.total > 1000000000)
    refuse("weights are from 0 to 1000000000 together, and one is above 0");
}

bool StreamShape::has_reset() const {
  return std::ranges::any_of(pins, [](const Pin& p) { return p.kind == Pin::Kind::reset; });
}

void StreamShape::column(const Field& field) {
  const std::string name = label_of(field);
  if (std::ranges::any_of(columns_, [&](const Field& f) { return label_of(f) == name; })) {
    throw InputError(fmt::format("{}: its cases would have two columns {}", title, name));
  }
  columns_.push_back(field);
}

StreamCase::StreamCase(const StreamShape& shape) : in(shape.in.size()), out(shape.out.size()) {
  for (const Interface& i : shape.in) given.emplace_back(i.cells.size());
}

void StreamCase::clear() {
  for (Sequence& all : given) all.clear();
  for (auto* sides : {&in, &out}) {
    for (Side& side : *sides) {
      side.stalls.clear();
      side.waits.clear();
    }
  }
}

void StreamCase::add(const StreamShape& shape, std::span<const Word> row) {
  std::size_t at = 0;
  for (std::size_t s = 0; s < in.size(); ++s) {
    const std::size_t cells = given[s].cells();
    if (row[at] != 0) {
      in[s].stalls.push_back(row[at + 1]);
      given[s].push(row.subspan(at + 2, cells));
    }
    at += 2 + cells;
  }
  for (std::size_t s = 0; s < out.size(); ++s) {
    if (shape.out[s].can_stall()) out[s].stalls.push_back(row[at++]);
    if (shape.out[s].can_wait()) out[s].waits.push_back(row[at++]);
  }
}

}  // namespace cosim
