#include "tb/stream/dut.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string_view>

namespace cosim {
namespace {

// Collects the ports, each once: the done of one stream may be the valid of another.
class Collector {
 public:
  /// `name` lives as long as the shape.
  void one(const char* name, bool drives, int width = 1) {
    if (*name == '\0' || !seen_.insert(name).second) return;
    Field field{name, width, Format::bits, "", "", 0, name};
    if (width <= row::word_width) return add(drives, field, name);
    field.is_word = true;
    for (field.index = 0; field.low < width; ++field.index, field.low += row::word_width) {
      field.width = std::min(row::word_width, width - field.low);
      add(drives, field, name);
    }
  }
  /// One of several.
  void clock(const StreamClock& c) {
    Field field{c.port.c_str(), 1, Format::flag, "", "", 0, c.port.c_str()};
    field.edge = c.falls ? Edge::falling : Edge::rising;
    add(true, field, c.port);
    clocks_ += (c.falls ? "falling " : "") + c.port + '\n';
    ports.clocks = clocks_;
  }
  void cells(std::span<const Field> cells, bool drives) {
    for (const Field& f : cells) add(drives, f, "");
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
  void add(bool drives, const Field& field, const std::string& name) {
    (drives ? ports.inputs : ports.outputs).push_back(field);
    (drives ? driven_names_ : read_names_).push_back(name);
  }
  std::set<std::string> seen_;
  std::string clocks_;  // as Ports has them
  std::vector<std::string> driven_names_, read_names_;
};

}  // namespace

StreamNets::StreamNets(const StreamShape& shape, StreamDut& dut) {
  Collector all;
  all.ports.title = shape.title;
  all.ports.clock = shape.clocks.size() == 1 ? shape.clocks.front().port.c_str() : "";
  for (const StreamClock& c : shape.clocks) {
    if (shape.clocks.size() > 1) all.clock(c);
  }
  const auto handshake = [&](const Interface& i) {
    all.one(i.valid.c_str(), i.goes_in);
    all.one(i.ready.c_str(), !i.goes_in);
    all.one(i.credit.c_str(), !i.goes_in);
    all.one(i.done.c_str(), false);
    if (!i.own.is_there()) all.cells(i.cells, i.goes_in);
    for (const Pin& p : i.own.drives) all.one(p.port, true, p.width);
    for (const Pin& p : i.own.reads) all.one(p.port, false, p.width);
  };
  for (const Interface& i : shape.in) handshake(i);
  for (const Interface& i : shape.out) handshake(i);
  for (const Pin& p : shape.pins) all.one(p.port, p.kind != Pin::Kind::unread, p.width);

  const std::vector<Net> nets = dut.nets(all.ports);
  all.take(nets);
  if (shape.clocks.size() == 1) clocks.emplace_back(nets.back());
  for (const StreamClock& c : shape.clocks) {
    if (shape.clocks.size() > 1) clocks.push_back(all.one(c.port));
  }
  std::size_t driven = 0, read = 0;
  const auto found = [&](const Interface& i) {
    InterfaceNets n{all.one(i.valid), all.one(i.ready), all.one(i.credit), all.one(i.done), {}};
    const auto add = [&](std::vector<Net>& words, const std::vector<Pin>& wires) {
      for (const Pin& p : wires) {
        words.insert(words.end(), all.named[p.port].begin(), all.named[p.port].end());
      }
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
