#include "tb/show/rows.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

namespace cosim {
namespace {

std::string with_source(const Bus& b) {
  return *b.field.source == '\0' ? b.name : fmt::format("{} ({})", b.name, b.field.source);
}

// " (WHAT)" where a name is followed by that of a printed source.
std::string group_title(const char* name, const char* what, const std::vector<Bus>& buses) {
  const bool named =
      std::ranges::any_of(buses, [](const Bus& b) { return *b.field.source != '\0'; });
  return named ? fmt::format("{} ({})", name, what) : name;
}

class Groups {
 public:
  Groups(const WaveShape& shape, const std::string& differs)
      : shape_(shape), inputs_(buses_of(shape.inputs)), compared_(buses_of(shape.compared)) {
    add_difference(differs);
    add_probes();
    if (shape.parts.empty()) {
      add_pins();
    } else {
      add_parts();
    }
    if (shape.registers > 0) {
      open(group_title("Registers", "block of the source",
                       {compared_.begin(), std::ranges::find_if(compared_, [&](const Bus& b) {
                          return b.first >= shape_.registers;
                        })}));
      for (std::size_t i = 0; i < compared_.size() && is_register(i); ++i) add_compared(i);
    }
    all_.push_back({pairs_title(), false, {}});
    for (std::size_t i = 0; i < compared_.size(); ++i) add_pair(i);
  }
  std::vector<WaveGroup> take() { return std::move(all_); }

 private:
  // "Expected, actual, mismatch"
  std::string pairs_title() const {
    std::string title = fmt::format("{}, {}, mismatch", shape_.sides.expected, shape_.sides.actual);
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
  }
  bool is_register(std::size_t i) const { return compared_[i].first < shape_.registers; }
  void open(const std::string& title) { all_.push_back({title, true, {}}); }
  void add(WaveRow::Kind kind, std::size_t at, std::string shown) {
    all_.back().rows.push_back({kind, at, std::move(shown)});
  }
  void add_input(std::size_t i) { add(WaveRow::Kind::input, i, with_source(inputs_[i])); }
  void add_compared(std::size_t i) {
    add(is_register(i) ? WaveRow::Kind::reg : WaveRow::Kind::output, i, with_source(compared_[i]));
  }
  void add_pair(std::size_t i) {
    if (shape_.is_finding(compared_[i])) return add_compared(i);
    add(WaveRow::Kind::pair, i, compared_[i].name);
  }

  void add_difference(const std::string& differs) {
    for (std::size_t i = 0; i < compared_.size(); ++i) {
      const auto cell = shape_.compared.begin() + static_cast<std::ptrdiff_t>(compared_[i].first);
      if (std::none_of(cell, cell + static_cast<std::ptrdiff_t>(compared_[i].count),
                       [&](const Field& f) { return label_of(f) == differs; })) {
        continue;
      }
      open("First difference: " + differs);
      add_pair(i);
    }
  }
  // Those of a group together, where they stand side by side.
  void add_probes() {
    std::string group;
    for (std::size_t i = 0; i < shape_.probes.size(); ++i) {
      const Probe& probe = shape_.probes[i];
      if (i == 0 || group != probe.group) open(probe.group);
      group = probe.group;
      add(WaveRow::Kind::probe, i, probe.name);
    }
  }
  void add_pins() {
    open(group_title("Pins", "of the source", inputs_));
    for (std::size_t i = 0; i < inputs_.size(); ++i) add_input(i);
    for (std::size_t i = 0; i < compared_.size(); ++i) {
      if (!is_register(i)) add_compared(i);
    }
  }
  // What comes out is seen beside what is expected.
  void add_parts() {
    std::size_t input = 0, compared = 0;
    for (const WavePart& part : shape_.parts) {
      open(part.title);
      for (; input < inputs_.size() && inputs_[input].first < part.inputs; ++input) {
        add_input(input);
      }
      for (; compared < compared_.size() && compared_[compared].first < part.compared; ++compared) {
        add_pair(compared);
      }
    }
  }

  const WaveShape& shape_;
  const std::vector<Bus> inputs_, compared_;
  std::vector<WaveGroup> all_;
};

}  // namespace

std::vector<WaveGroup> wave_groups(const WaveShape& shape, const std::string& differs) {
  return Groups(shape, differs).take();
}

std::uint64_t seen_first(const WaveRange& range, std::uint64_t clocks) {
  if (!range.mismatch) return range.first;
  const std::uint64_t all = std::min(range.last - range.first + 1, clocks);
  const std::uint64_t before = std::min(*range.mismatch - range.first, all * 2 / 3);
  return std::min(*range.mismatch - before,
                  range.last + 1 - all);  // none less than there is room for
}

}  // namespace cosim
