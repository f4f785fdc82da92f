#include "tb/dut/registers.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "model/core/input_error.h"
#include "tb/util/place.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

std::vector<std::vector<std::string>> lines_of(std::string_view text) {
  std::vector<std::vector<std::string>> all;
  for (const std::string& line : lines_in(text)) all.push_back(words_in(line));
  return all;
}

// A net that has a register's value from its bit `low` up.
struct Carrier {
  std::string name;
  RtlNet net;
  int low = 0;
};
struct Register {
  std::string name;
  RtlNet net;  // words < 0: no table can have it
  // By bit, the words of a memory one behind the other: holds a state, and is in no field so far.
  std::vector<bool> open;
  std::vector<Carrier> carriers;  // itself, then others
};

Register register_of(const std::vector<std::string>& words) {
  Register r{words.at(0), {std::stoi(words.at(1)), std::stoi(words.at(2))}, {}, {}};
  r.carriers.push_back({r.name, r.net, 0});
  r.open.resize(static_cast<std::size_t>(r.net.width) *
                static_cast<std::size_t>(std::max(r.net.words, 1)));
  for (const std::string& range : parts_in(words.at(3), ',')) {
    const auto high = std::stoul(range), low = std::stoul(range.substr(range.find(':') + 1));
    for (auto bit = low; bit <= high; ++bit) r.open.at(bit) = true;
  }
  for (std::size_t i = 4; i + 3 < words.size(); i += 4) {
    r.carriers.push_back(
        {words[i], {std::stoi(words[i + 1]), std::stoi(words[i + 2])}, std::stoi(words[i + 3])});
  }
  return r;
}

// What a row of a table has of a register is no longer open.
void close(Register& r, std::span<const Field> row, const std::string& title) {
  const std::string path = net_path(row.front().net).path;
  for (const Carrier& c : r.carriers) {
    if (c.name != path || c.net.words != r.net.words) continue;
    const std::string what = fmt::format("{}: register {}", title, row.front().net);
    if (r.net.words < 0) {
      throw InputError(what + ": a queue or an associative array can only be in unobserved");
    }
    const auto places = places_in(c.net, row, what);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const int from = std::max(places[i].word, 0) * c.net.width + places[i].low - c.low;
      const int end = std::min(from + row[i].width, static_cast<int>(r.open.size()));
      for (int bit = std::max(from, 0); bit < end; ++bit) {
        r.open[static_cast<std::size_t>(bit)] = false;
      }
    }
  }
}

// What is open of a register: its name, or parts of it as "a[7:4]", words as "store[3:1]", bits of
// a word as "store[2][1:0]", the lowest first.
std::vector<std::string> left_of(const Register& r) {
  const auto width = static_cast<std::size_t>(r.net.width), size = r.open.size();
  if (std::ranges::find(r.open, false) == r.open.end()) return {r.name};
  const auto range = [](std::size_t low, std::size_t end) {
    return end - low == 1 ? fmt::format("[{}]", low) : fmt::format("[{}:{}]", end - 1, low);
  };
  // The first from `at` on that is open or is not.
  const auto next = [&](std::size_t at, bool open, std::size_t end) {
    while (at < end && r.open[at] != open) ++at;
    return at;
  };
  std::vector<std::string> parts;
  for (std::size_t at = next(0, true, size); at < size; at = next(at, true, size)) {
    const std::size_t end = next(at, false, size);
    if (r.net.words <= 0) {
      parts.push_back(r.name + range(at, end));
      at = end;
    } else if (at % width == 0 && end - at >= width) {
      parts.push_back(r.name + range(at / width, end / width));
      at = end / width * width;
    } else {
      const std::size_t word = at / width, stop = std::min(end, (word + 1) * width);
      parts.push_back(r.name + range(word, word + 1) + range(at % width, stop - word * width));
      at = stop;
    }
  }
  return parts;
}

}  // namespace

bool matches_any(const std::vector<std::string>& patterns, std::string_view name) {
  return std::ranges::any_of(patterns,
                             [&](const std::string& pattern) { return is_like(name, pattern); });
}

std::vector<std::string> unobserved_signals(const RtlText& text, const std::vector<Field>& fields,
                                            const std::vector<std::string>& patterns,
                                            const std::vector<Field>& outputs) {
  const auto rows = rows_of(fields);
  std::vector<std::string> unobserved, missing;
  std::vector<bool> used(patterns.size());
  const auto is_allowed = [&](std::string_view name) {
    bool allowed = false;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
      if (is_like(name, patterns[i])) allowed = used[i] = true;
    }
    return allowed;
  };
  for (const auto& words : lines_of(text.registers)) {
    Register r = register_of(words);
    for (const auto& row : rows) close(r, row, text.title);
    if (std::ranges::find(r.open, true) == r.open.end()) continue;
    for (const std::string& part : left_of(r)) {
      const bool whole = is_allowed(r.name), allowed = is_allowed(part) || whole;
      if (!allowed && r.net.words < 0) {
        throw InputError(fmt::format(
            "{}: register {}: a queue or an associative array can only be in unobserved",
            text.title, r.name));
      }
      (allowed ? unobserved : missing).push_back(part);
    }
  }
  // Of one that is neither in a row nor allowed, find_ports() says so.
  for (const auto& words : lines_of(text.outputs)) {
    const std::string& name = words.front();
    const bool has_row =
        std::ranges::any_of(outputs, [&](const Field& f) { return net_path(f.net).path == name; });
    if (has_row || !is_allowed(name)) continue;
    const bool is_there =  // as a register
        std::ranges::find(unobserved, name) != unobserved.end();
    if (!is_there) unobserved.push_back(name);
  }
  if (missing.size() == 1) {
    throw InputError(
        fmt::format("{}: the RTL has a register {} that is neither in the model nor in unobserved",
                    text.title, missing.front()));
  }
  if (!missing.empty()) {
    throw InputError(
        fmt::format("{}: the RTL has registers that are neither in the model nor in unobserved: {}",
                    text.title, fmt::join(missing, ", ")));
  }
  const auto unused = std::ranges::find(used, false);
  if (unused != used.end()) {
    throw InputError(fmt::format(
        "{}: unobserved has {}, and the RTL has no such register or output outside the model",
        text.title, patterns[static_cast<std::size_t>(unused - used.begin())]));
  }
  return unobserved;
}

void require_resets(const RtlText& text, Resets design, const std::vector<ResetPin>& pins) {
  auto resets = lines_of(text.resets);
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("{}: {}", text.title, why));
  };
  for (const auto& reset : resets) {
    if (reset.front() == "inner" && design != Resets::each_at_once) {
      refuse(
          fmt::format("register {} resets others asynchronously: write what it clears in "
                      "reset_at_once()",
                      reset.back()));
    }
  }
  const bool any_inner =
      std::erase_if(resets, [](const auto& reset) { return reset.front() == "inner"; }) != 0;
  if (any_inner && resets.empty()) return;
  if (resets.empty()) {
    if (design != Resets::at_edge && !text.registers.empty()) {
      refuse(fmt::format("{}, and no register of the RTL has an asynchronous reset",
                         design == Resets::at_once ? "asynchronous_reset" : "reset_at_once()"));
    }
    return;
  }
  const std::string& name = resets.front().back();
  if (design != Resets::each_at_once && resets.size() > 1) {
    refuse(fmt::format("{} and {} reset asynchronously: write what each clears in reset_at_once()",
                       name, resets[1].back()));
  }
  if (design == Resets::at_edge) {
    refuse(fmt::format("{} resets asynchronously: the model must have asynchronous_reset = true",
                       name));
  }
  for (const auto& reset : resets) {
    const bool level = reset.size() == 1;
    const bool is_given = std::ranges::any_of(pins, [&](const ResetPin& pin) {
      return pin.net == reset.back() && pin.in_reset == level;
    });
    if (is_given && (design == Resets::each_at_once || pins.size() == 1)) continue;
    refuse(fmt::format(
        "{} resets asynchronously while it is {}: the model's reset must name this pin{}",
        reset.back(), level ? 1 : 0, design == Resets::each_at_once ? "" : " alone"));
  }
}

void require_taken_over(const RtlText& text, const std::vector<Field>& registers,
                        const std::vector<Field>& state) {
  for (const Field& r : registers) {
    if (!r.unreset || r.width == 0) continue;
    const bool is_there = std::ranges::any_of(state, [&](const Field& f) {
      return std::string_view(f.name) == r.name && f.index == r.index;
    });
    if (is_there) continue;
    throw InputError(
        fmt::format("{}: {} has no reset value, and the model has no member of that name to take "
                    "its value over",
                    text.title, label_of(r)));
  }
}

}  // namespace cosim
