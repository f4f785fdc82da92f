#include "tb/stream/dut.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

namespace cosim {
namespace {

// Of a cell of a driver; of one bit the port's name alone, for one() may have it.
std::string key_of(const Field& f) {
  return f.width == 1 && f.index < 0 ? f.net : fmt::format("{} {} {}", f.net, f.index, f.width);
}

// Collects the ports, each once: the done of one stream may be the valid of another.
class Collector {
 public:
  explicit Collector(const StreamShape& shape) {
    ports.title = shape.title;
    if (!shape.clocks.empty() && !shape.clocks_are_inputs()) {
      ports.clock = shape.clocks.front().port.c_str();
    }
    for (const StreamClock& c : shape.clocks) {
      if (shape.clocks_are_inputs()) clock(c);
    }
    for (const auto* side : {&shape.in, &shape.out}) {
      for (const Interface& i : *side) interface(i);
    }
    for (const Pin& p : shape.pins) one(p.port, p.kind != Pin::Kind::unread, p.width);
  }

  // The nets in the order in which they were asked for.
  Ports ports;
  std::vector<Net> driven, read;
  std::map<std::string, std::vector<Net>> named;  // words of 64 bits

  BitNet one(const std::string& name) {
    return name.empty() ? BitNet() : BitNet(named[name].front());
  }

  void take(const std::vector<Net>& nets) {
    std::size_t at = 0;
    for (const auto* side : {&driven_names_, &read_names_}) {
      auto& found = side == &driven_names_ ? driven : read;
      for (const std::string& name : *side) {
        if (name.empty()) {
          found.push_back(nets[at++]);
        } else {
          named[name].push_back(nets[at++]);
        }
      }
    }
  }

 private:
  /// `name` lives as long as the shape.
  void one(const char* name, bool drives, int width = 1) {
    if (*name == '\0' || !seen_.insert(name).second) return;
    Field field{name, width, Format::bits, "", "", 0, name};
    constexpr int word_width = 64;
    if (width <= word_width) return add(drives, field, name);
    field.is_word = true;
    for (field.index = 0; field.low < width; ++field.index, field.low += word_width) {
      field.width = std::min(word_width, width - field.low);
      add(drives, field, name);
    }
  }
  void clock(const StreamClock& c) {
    Field field{c.port.c_str(), 1, Format::flag, "", "", 0, c.port.c_str()};
    field.edge = c.falls ? Edge::falling : Edge::rising;
    add(true, field, c.port);
    ports.clocks += (c.falls ? "falling " : "") + c.port + '\n';
  }
  void interface(const Interface& i) {
    one(i.valid.c_str(), i.goes_in);
    one(i.ready.c_str(), !i.goes_in);
    one(i.credit.c_str(), !i.goes_in);
    one(i.done.c_str(), false);
    if (!i.own.is_there()) {
      for (const Field& f : i.cells) add(i.goes_in, f, "");
    }
    for (const Field& f : i.own.drives) shared(f, true);
    for (const Field& f : i.own.reads) shared(f, false);
  }
  /// A cell of a driver, which another may have too.
  void shared(const Field& field, bool drives) {
    const std::string name = key_of(field);
    if (seen_.insert(name).second) add(drives, field, name);
  }
  void add(bool drives, const Field& field, const std::string& name) {
    (drives ? ports.inputs : ports.outputs).push_back(field);
    (drives ? driven_names_ : read_names_).push_back(name);
  }
  std::set<std::string> seen_;
  std::vector<std::string> driven_names_, read_names_;
};

}  // namespace

Ports ports_of(const StreamShape& shape) { return Collector(shape).ports; }

StreamNets::StreamNets(const StreamShape& shape, StreamDut& dut) {
  Collector all(shape);
  const std::vector<Net> nets = dut.nets(all.ports);
  all.take(nets);
  for (const StreamClock& c : shape.clocks) {
    clocks.push_back(shape.clocks_are_inputs() ? all.one(c.port) : BitNet(nets.back()));
  }
  std::size_t driven = 0, read = 0;
  const auto found = [&](const Interface& i) {
    InterfaceNets n{all.one(i.valid), all.one(i.ready), all.one(i.credit), all.one(i.done), {}};
    const auto add = [&](std::vector<Net>& words, const std::vector<Field>& cells) {
      for (const Field& f : cells) words.push_back(all.named[key_of(f)].front());
    };
    add(n.drives, i.own.drives);
    add(n.reads, i.own.reads);
    for (std::size_t c = 0; c < i.cells.size() && !i.own.is_there(); ++c) {
      n.cells.push_back(i.goes_in ? all.driven[driven++] : all.read[read++]);
    }
    return n;
  };
  for (const Interface& i : shape.in) in.push_back(found(i));
  for (const Interface& i : shape.out) out.push_back(found(i));
  for (const Pin& p : shape.pins) pins.push_back(all.named[p.port]);
}

}  // namespace cosim
