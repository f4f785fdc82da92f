#include "tb/stream/record.h"

#include <algorithm>

#include "tb/stream/dut.h"

namespace cosim {
namespace {

constexpr int number_width = 32;

const StreamFinding* at(const std::optional<StreamFinding>& finding, std::uint64_t clock) {
  return finding && finding->clock == clock ? &*finding : nullptr;
}

}  // namespace

TraceRecorder::TraceRecorder(const StreamShape& shape, const StreamFinding& finding, Window window)
    : shape_(shape), finding_(finding), window_(window) {
  Mismatch& m = mismatch_;
  m.clock = finding.clock;
  m.first = finding.clock > window.before ? finding.clock - window.before : 0;
  for (const StreamClock& c : shape.clocks) {
    if (shape.clocks.size() == 1) break;
    const Field edge{c.port.c_str(), 1, Format::flag, "", ""};
    m.traces.push_back({edge, Trace::Kind::input, {}, {}});
  }
  for (const Interface& i : shape.in) add(i);
  for (const Interface& i : shape.out) add(i);
}

void TraceRecorder::add(const Interface& i) {
  const auto kind = i.goes_in ? Trace::Kind::input : Trace::Kind::output;
  const auto back = i.goes_in ? Trace::Kind::output : Trace::Kind::input;
  const auto flag = [](const std::string& name) {
    return Field{name.c_str(), 1, Format::flag, "", ""};
  };
  if (!i.valid.empty()) mismatch_.traces.push_back({flag(i.valid), kind, {}, {}});
  if (!i.ready.empty()) mismatch_.traces.push_back({flag(i.ready), back, {}, {}});
  for (const Field& f : i.cells) mismatch_.traces.push_back({f, kind, {}, {}});
}

void TraceRecorder::keep(std::size_t& at, const Interface& i, const InterfaceSeen& seen) {
  const auto one = [&](Word expected, Word actual, bool left_out = false) {
    Trace& t = mismatch_.traces[at++];
    t.expected.push_back(expected);
    t.actual.push_back(actual);
    t.left_out.push_back(left_out);
  };
  if (!i.valid.empty()) one(seen.valid ? 1 : 0, seen.valid ? 1 : 0);
  if (!i.ready.empty()) one(seen.ready ? 1 : 0, seen.ready ? 1 : 0);
  for (std::size_t c = 0; c < seen.actual.size(); ++c) {
    one(seen.expected[c], seen.actual[c], !i.goes_in && !seen.compared[c]);
  }
}

bool TraceRecorder::clock(std::uint64_t clock, const std::vector<Word>& edges,
                          const std::vector<InterfaceSeen>& in,
                          const std::vector<InterfaceSeen>& out) {
  Mismatch& m = mismatch_;
  if (clock < m.first) return true;
  std::size_t at = 0;
  for (const Word edge : edges) {
    Trace& t = m.traces[at++];
    t.expected.push_back(edge);
    t.actual.push_back(edge);
    t.left_out.push_back(false);
  }
  for (std::size_t s = 0; s < in.size(); ++s) keep(at, shape_.in[s], in[s]);
  for (std::size_t s = 0; s < out.size(); ++s) keep(at, shape_.out[s], out[s]);
  if (clock == m.clock) {
    m.signal = signal_of(shape_, finding_);
    for (const InterfaceSeen& seen : in) {
      taken_.push_back(seen.number + (seen.valid && seen.ready ? 1 : 0));
    }
    if (finding_.kind == StreamFinding::Kind::value) {
      const InterfaceSeen& seen = out[finding_.stream];
      m.field = shape_.out[finding_.stream].cells[finding_.cell];
      m.expected = seen.expected[finding_.cell];
      m.actual = seen.actual[finding_.cell];
    }
  }
  return clock < m.clock + window_.after;
}

WaveRecorder::WaveRecorder(const StreamShape& shape, const std::string& title, const StreamDut& dut,
                           const StreamResult& known, Window around, WaveSink& sink)
    : streams_(shape),
      finding_(known.finding),
      rtl_(dut.signals()),
      edges_(shape.clocks.size()),
      sink_(sink) {
  for (Signal& s : rtl_) {
    for (std::size_t c = 0; c < shape.clocks.size(); ++c) {
      if (s.scope.size() != 1 || s.name != shape.clocks[c].port) continue;
      s.is_clock = true;
      if (shape.clocks.size() > 1) s.takes_edge = &edges_[c];
      s.falls = shape.clocks[c].falls;
    }
  }
  shape_.title = title;
  const auto add = [&](const Interface& i) {
    const auto seen = [&](const char* what, int width, Format format) {
      const char* name = kept(i.name + what);
      shape_.inputs.push_back({name, width, format, "", ""});
    };
    seen("_valid", 1, Format::flag);
    seen("_ready", 1, Format::flag);
    seen("_number", number_width, Format::number);
    if (i.goes_in) {
      shape_.inputs.insert(shape_.inputs.end(), i.cells.begin(), i.cells.end());
    } else {
      shape_.compared.insert(shape_.compared.end(), i.cells.begin(), i.cells.end());
    }
    shape_.compared.push_back({kept(i.name + "_fails"), 1, Format::flag, "", ""});
    if (i.text) shape_.texts.push_back(i.name);
    if (i.text && !i.goes_in) shape_.texts.push_back("expected_" + i.name);
    shape_.parts.push_back({i.name, shape_.inputs.size(), shape_.compared.size()});
  };
  if (shape.clocks.size() > 1) {
    for (const StreamClock& c : shape.clocks) {
      shape_.inputs.push_back({kept(c.port), 1, Format::flag, "", ""});
    }
    shape_.parts.push_back({"clocks", shape_.inputs.size(), 0});
  }
  for (const Interface& i : shape.in) add(i);
  for (const Interface& i : shape.out) add(i);

  range_.clocks = known.clocks;
  range_.last = known.clocks - 1;
  if (finding_) {
    range_.mismatch = finding_->clock;
    range_.first = finding_->clock > around.before ? finding_->clock - around.before : 0;
    range_.last = finding_->clock + around.after;
    range_.clocks = std::max(range_.clocks, range_.last + 1);
    range_.signal = signal_of(shape, *finding_);
    if (finding_->kind != StreamFinding::Kind::value) range_.signal += "_fails";
  }
  sink_.begin(shape_, range_, rtl_);
}

bool WaveRecorder::clock(std::uint64_t clock, const std::vector<Word>& edges,
                         const std::vector<InterfaceSeen>& in,
                         const std::vector<InterfaceSeen>& out) {
  std::copy(edges.begin(), edges.end(), edges_.begin());
  if (clock < range_.first) return true;
  const StreamFinding* found = at(finding_, clock);
  WaveClock now;
  now.clock = clock;
  now.inputs = edges;
  const auto add = [&](bool goes_in, std::size_t s, const InterfaceSeen& seen) {
    now.inputs.insert(now.inputs.end(),
                      {seen.valid ? 1 : 0, seen.ready ? 1 : 0, static_cast<Word>(seen.number)});
    if (goes_in) {
      now.inputs.insert(now.inputs.end(), seen.actual.begin(), seen.actual.end());
    } else {
      now.expected.insert(now.expected.end(), seen.expected.begin(), seen.expected.end());
      now.actual.insert(now.actual.end(), seen.actual.begin(), seen.actual.end());
      now.compared.insert(now.compared.end(), seen.compared.begin(), seen.compared.end());
    }
    const Interface& i = (goes_in ? streams_.in : streams_.out)[s];
    if (i.text) now.texts.push_back(seen.valid ? i.text(seen.actual) : "-");
    if (i.text && !goes_in) now.texts.push_back(seen.valid ? i.text(seen.expected) : "-");
    now.compared.push_back(true);
    now.expected.push_back(0);
    now.actual.push_back(found != nullptr && found->goes_in == goes_in && found->stream == s ? 1
                                                                                             : 0);
  };
  for (std::size_t s = 0; s < in.size(); ++s) add(true, s, in[s]);
  for (std::size_t s = 0; s < out.size(); ++s) add(false, s, out[s]);
  for (std::size_t i = 0; i < now.expected.size(); ++i) {
    now.differs.push_back(now.compared[i] && now.expected[i] != now.actual[i]);
  }
  sink_.clock(now);
  return clock < range_.last;
}

}  // namespace cosim
