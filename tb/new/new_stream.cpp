// The stream model that `cosim new --stream` begins for RTL: which of its ports make up a stream is
// read out of their names.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "model/core/input_error.h"
#include "tb/new/new.h"

namespace cosim::cli {
namespace {

// A field of what passes.
struct StreamField {
  std::string name;  // in the model
  FoundNet net;
  bool elsewhere = false;  // where the RTL has it does not follow from that name
};

struct FoundStream {
  bool goes_in = true;
  std::string prefix;  // of its ports
  std::string valid;   // the ports themselves; empty where there are none
  std::string ready = {}, credit = {}, done = {};
  std::vector<StreamField> fields = {};

  bool starts() const { return valid == "start" || valid == "done"; }
  std::string name() const {
    std::string name = prefix;
    if (name.ends_with("_t")) name.pop_back();
    while (name.ends_with('_')) name.pop_back();
    return name.empty() ? (goes_in ? "in" : "out") : name;
  }
  std::string record() const { return in_one_word(name()) + "Data"; }
};

std::string text_of(const FoundStream& s) {
  std::string text = fmt::format("  struct {} {{\n", s.record());
  for (const StreamField& f : s.fields) {
    const std::string type = type_of(f.net);
    text += f.elsewhere ? fmt::format("    At<\"{}\", {}> {};\n", f.net.name, type, f.name)
                        : fmt::format("    {} {};\n", type, f.name);
  }
  return text + "  };\n";
}

// A port's name without the direction that some put behind it.
std::string stem_of(const std::string& port) {
  const bool directed = port.ends_with("_i") || port.ends_with("_o");
  return directed ? port.substr(0, port.size() - 2) : port;
}

// The port of one bit with one of those endings behind the prefix; empty where there is none.
std::string port_of(const std::vector<FoundNet>& ports, const std::string& prefix,
                    std::initializer_list<const char*> endings) {
  for (const FoundNet& port : ports) {
    for (const char* ending : endings) {
      if (port.width.number == 1 && stem_of(port.name) == prefix + ending) return port.name;
    }
  }
  return "";
}

// The streams of one direction, by the ports that say that a transaction is there.
void add_streams(std::vector<FoundStream>& streams, const std::vector<FoundNet>& ports,
                 const std::vector<FoundNet>& back, bool goes_in) {
  for (const FoundNet& port : ports) {
    const std::string stem = stem_of(port.name);
    for (const std::string ending : {"valid", "vld"}) {
      if (port.width.number != 1 || !stem.ends_with(ending)) continue;
      const std::string prefix = stem.substr(0, stem.size() - ending.size());
      streams.push_back({goes_in, prefix, port.name, port_of(back, prefix, {"ready", "rdy"}),
                         port_of(back, prefix, {"credit"})});
    }
  }
}

std::vector<FoundStream> streams_of(const Found& f) {
  std::vector<FoundStream> streams;
  add_streams(streams, f.inputs, f.outputs, true);
  add_streams(streams, f.outputs, f.inputs, false);
  const std::string start = port_of(f.inputs, "", {"start"});
  const std::string done = port_of(f.outputs, "", {"done"});
  if (streams.empty() && !start.empty() && !done.empty()) {
    streams = {{true, "", start, "", "", done}, {false, "", done}};
  }
  for (const bool goes_in : {true, false}) {
    if (std::ranges::none_of(streams, [&](const FoundStream& s) { return s.goes_in == goes_in; })) {
      throw InputError(
          fmt::format("new: {}: no stream {}: it has no {} whose name ends in valid or vld, and "
                      "not both start and done",
                      f.top, goes_in ? "goes in" : "comes out", goes_in ? "input" : "output"));
    }
  }
  return streams;
}

bool is_reset(const Found& f, const std::string& port) {
  return std::ranges::any_of(f.resets, [&](const FoundReset& r) { return r.name == port; });
}

// Gives each port to the stream of its direction with the longest prefix; those left are returned.
std::vector<FoundNet> share_out(std::vector<FoundStream>& streams, const Found& f, bool goes_in,
                                const TakenNames& taken) {
  std::vector<FoundNet> left;
  for (const FoundNet& port : goes_in ? f.inputs : f.outputs) {
    const std::string stem = stem_of(port.name);
    FoundStream* owner = nullptr;
    bool is_handshake = is_reset(f, port.name) || port.edge != Edge::none;
    for (FoundStream& s : streams) {
      for (const std::string* other : {&s.valid, &s.ready, &s.credit, &s.done}) {
        is_handshake |= port.name == *other;
      }
      const bool fits =
          s.goes_in == goes_in && stem.starts_with(s.prefix) && stem.size() > s.prefix.size();
      if (fits && (owner == nullptr || s.prefix.size() > owner->prefix.size())) owner = &s;
    }
    if (is_handshake) continue;
    if (owner == nullptr) {
      left.push_back(port);
      continue;
    }
    std::string field = stem.substr(owner->prefix.size());
    if (std::isdigit(static_cast<unsigned char>(field.front())) != 0) field = stem;
    field = taken.other_than(field);
    owner->fields.push_back({field, port, port.name != owner->prefix + field});
  }
  return left;
}

// Of several clocks the one whose name begins most like that of the stream; empty where none does,
// or two do alike.
std::string clock_like(const FoundStream& s, const Found& f) {
  std::string best;
  std::size_t most = 0;
  for (const FoundClock& c : f.clocks) {
    const std::string name = s.name();
    const auto end = std::mismatch(name.begin(), name.end(), c.name.begin(), c.name.end());
    const auto same = static_cast<std::size_t>(end.first - name.begin());
    if (same >= most) best = same > most ? c.name : "";
    most = std::max(most, same);
  }
  return best;
}

// stream<XData>("x") and what is to be said of it besides.
std::string text_of(const FoundStream& s, const std::string& clock) {
  std::string text = fmt::format("stream<{}>(\"{}\")", s.record(), s.name());
  if (!clock.empty()) text += fmt::format(".clock(\"{}\")", clock);
  if (s.prefix != s.name() + "_") text += fmt::format(".prefix(\"{}\")", s.prefix);
  if (s.valid != s.prefix + "valid") text += fmt::format(".valid(\"{}\")", s.valid);
  if (!s.done.empty()) return text + fmt::format(".until(\"{}\")", s.done);
  if (s.starts()) return text + ".rising()";
  if (!s.credit.empty()) {
    const bool other = s.credit != s.prefix + "credit";
    return text + fmt::format(".credit(/* how many at the start */{})",
                              other ? fmt::format(", \"{}\"", s.credit) : "");
  }
  if (s.ready.empty()) return text + ".always_ready()";
  if (s.ready != s.prefix + "ready") text += fmt::format(".ready(\"{}\")", s.ready);
  return text;
}

std::string pins_of(const Found& f, const std::vector<FoundNet>& tied,
                    const std::vector<FoundNet>& unread) {
  std::vector<std::string> pins;
  for (const FoundReset& r : f.resets) {
    pins.push_back(fmt::format("pin::reset{}(\"{}\")", r.active_low ? "_low" : "", r.name));
  }
  const auto width = [](const FoundNet& n) {
    const bool is_bit = n.width.number == 1 && n.width.text.empty();
    return is_bit ? "" : ", " + text_of(n.width);
  };
  for (const FoundNet& n : tied)
    pins.push_back(fmt::format("pin::tied(\"{}\", 0{})", n.name, width(n)));
  for (const FoundNet& n : unread)
    pins.push_back(fmt::format("pin::unread(\"{}\"{})", n.name, width(n)));
  if (pins.empty()) return "";
  return fmt::format(
      "  static constexpr auto pins() {{\n"
      "    return std::array{{{}}};\n"
      "  }}\n",
      fmt::join(pins, ",\n                      "));
}

// One thing, or a tuple of several.
std::string tuple_of(const std::vector<std::string>& all, const char* tuple, const char* open,
                     const char* close) {
  if (all.size() == 1) return all.front();
  return fmt::format("{}{}{}{}", tuple, open, fmt::join(all, ", "), close);
}

}  // namespace

BegunModel stream_model(const std::string& name, const Found& f) {
  const std::string title = struct_of(name, f);
  std::vector<FoundStream> streams = streams_of(f);
  TakenNames taken(taken_in(title, f));
  const std::vector<FoundNet> tied = share_out(streams, f, true, taken);
  const std::vector<FoundNet> unread = share_out(streams, f, false, taken);

  BegunModel model;
  model.left.push_back("run() is to be written");
  if (f.resets.empty()) model.left.push_back("pins() is to name the reset");
  for (const FoundNet& n : tied) {
    model.left.push_back(n.name + " is tied to 0; what belongs to a transaction is a field of it");
  }
  std::string records;
  std::vector<std::string> in, out, given, results;
  for (const FoundStream& s : streams) {
    if (s.fields.empty()) {
      throw InputError(
          fmt::format("new: {}: the stream {} has no port for what passes", f.top, s.name()));
    }
    if (!s.credit.empty())
      model.left.push_back("how many credits " + s.name() + " has is to be said");
    records += text_of(s);
    std::string clock = f.clocks.size() > 1 ? clock_like(s, f) : "";
    if (f.clocks.size() > 1 && clock.empty()) {
      clock = f.clocks.front().name;
      model.left.push_back("the clock of " + s.name() + " is to be looked at; it is taken to be " +
                           clock);
    }
    (s.goes_in ? in : out).push_back(text_of(s, clock));
    const std::string all = fmt::format("std::vector<{}>", s.record());
    if (s.goes_in) {
      given.push_back(
          fmt::format("[[maybe_unused]] const {}& {}", all, taken.other_than(s.name())));
    } else {
      results.push_back(all);
    }
  }
  model.text = fmt::format(
      "// What comes out of {} for what goes in.\n"
      "#pragma once\n\n"
      "#include <cosim/stream.h>\n\n"
      "{}struct {} {{\n"
      "{}"
      "  static constexpr auto in() {{\n"
      "    return {};\n"
      "  }}\n"
      "  static constexpr auto out() {{\n"
      "    return {};\n"
      "  }}\n"
      "{}\n"
      "  static {} run(\n"
      "      {}) {{\n"
      "    // To be written: all that must come out, in its order.\n"
      "    return {{}};\n"
      "  }}\n"
      "}};\n",
      f.top, template_of(f), title, records, tuple_of(in, "std::tuple", "{", "}"),
      tuple_of(out, "std::tuple", "{", "}"), pins_of(f, tied, unread),
      tuple_of(results, "std::tuple", "<", ">"), fmt::join(given, ",\n      "));
  return model;
}

}  // namespace cosim::cli
