#include "tb/dut/registers.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "model/core/input_error.h"

namespace cosim {
namespace {

std::vector<std::vector<std::string>> lines_of(std::string_view text) {
  std::vector<std::vector<std::string>> all;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    all.emplace_back();
    for (std::string word; words >> word;) all.back().push_back(word);
  }
  return all;
}

bool matches(std::string_view pattern, std::string_view name) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return pattern == name;
  if (!name.starts_with(pattern.substr(0, star))) return false;
  for (std::size_t skipped = star; skipped <= name.size(); ++skipped) {
    if (matches(pattern.substr(star + 1), name.substr(skipped))) return true;
  }
  return false;
}

// Whether a field is the net or a part of it: an element of an array, some of its bits.
bool names(const Field& field, std::string_view net) {
  const std::string_view at = field.net;
  return at == net || (at.starts_with(net) && at.substr(net.size()).starts_with('['));
}

}  // namespace

std::vector<std::string> unobserved_registers(const RtlText& text, const std::vector<Field>& fields,
                                              const std::vector<std::string>& patterns) {
  std::vector<std::string> unobserved;
  std::vector<bool> used(patterns.size());
  for (const auto& nets : lines_of(text.registers)) {
    const bool in_table = std::any_of(fields.begin(), fields.end(), [&](const Field& f) {
      return std::any_of(nets.begin(), nets.end(),
                         [&](const std::string& net) { return names(f, net); });
    });
    if (in_table) continue;
    // Verilator does not show it, and no table can have it.
    const std::string& front = nets.front();
    const bool deep = front.ends_with("[][]");
    const std::string register_name = front.substr(0, front.size() - (deep ? 4 : 0));
    bool allowed = false;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
      if (!matches(patterns[i], register_name)) continue;
      allowed = used[i] = true;
    }
    if (!allowed && deep) {
      throw InputError(fmt::format(
          "{}: register {}: a memory of more dimensions than one can only be in unobserved",
          text.title, register_name));
    }
    if (!allowed) {
      throw InputError(fmt::format(
          "{}: the RTL has a register {} that no table names and that is not in unobserved",
          text.title, register_name));
    }
    unobserved.push_back(register_name);
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end() && !text.registers.empty()) {
    throw InputError(
        fmt::format("{}: unobserved has {}, and the RTL has no such register beside the tables",
                    text.title, patterns[static_cast<std::size_t>(unused - used.begin())]));
  }
  return unobserved;
}

void require_resets(const RtlText& text, Resets design, const std::vector<ResetPin>& pins) {
  const auto resets = lines_of(text.resets);
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("{}: {}", text.title, why));
  };
  if (resets.empty()) {
    if (design != Resets::at_edge && !text.registers.empty()) {
      refuse(fmt::format("{}, and no register of the RTL has an asynchronous reset",
                         design == Resets::at_once ? "asynchronous_reset" : "reset()"));
    }
    return;
  }
  const std::string& name = resets.front().back();
  if (design != Resets::each_at_once && resets.size() > 1) {
    refuse(fmt::format(
        "{} and {} reset asynchronously: the model is to say what each clears, with reset()", name,
        resets[1].back()));
  }
  if (design == Resets::at_edge) {
    refuse(fmt::format(
        "{} resets asynchronously: struct Design is to say asynchronous_reset = true", name));
  }
  for (const auto& reset : resets) {
    const bool level = reset.size() == 1;
    const bool is_given = std::any_of(pins.begin(), pins.end(), [&](const ResetPin& pin) {
      return pin.net == reset.back() && pin.in_clear == level;
    });
    if (is_given && (design == Resets::each_at_once || pins.size() == 1)) continue;
    refuse(fmt::format(
        "{} resets asynchronously where it is {}, and clear() is to {}", reset.back(),
        level ? 1 : 0,
        design == Resets::each_at_once ? "give it" : "differ from rest() in that alone"));
  }
}

}  // namespace cosim
