// How sizes follow parameters: other values are tried, and what explains all of them is taken
// (inference of an invariant from examples, among a few forms).
#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <map>
#include <mutex>
#include <set>

#include "tb/new/found_shape.h"
#include "tb/rtl/read.h"
#include "tb/util/parallel.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

using Points = std::vector<std::pair<long, long>>;  // of a parameter, and what a size is with it

bool all_are(const Points& points, const std::function<long(long)>& of) {
  return std::ranges::all_of(points, [&](const auto& p) { return of(p.first) == p.second; });
}
std::string sum(const std::string& text, long more) {
  if (more == 0) return text;
  return fmt::format("{} {} {}", text, more < 0 ? '-' : '+', std::abs(more));
}
long bits_for(long values) {
  return values < 1 ? 0 : static_cast<long>(std::bit_width(static_cast<unsigned long>(values) - 1));
}

// As of FoundSize, or empty where none of these forms explains the points.
std::string form_of(const std::string& p, const Points& points) {
  const auto [at, size] = points.front();
  if (all_are(points, [s = size](long) { return s; })) return "";
  const long more = size - at;
  if (all_are(points, [&](long v) { return v + more; })) return sum(p, more);
  const long factor = at == 0 ? 0 : size / at;
  if (factor > 1 && all_are(points, [&](long v) { return v * factor; })) {
    return fmt::format("{} * {}", p, factor);
  }
  for (const long by : {2L, 4L, 8L, 16L}) {
    if (all_are(points, [&](long v) { return v / by; })) return fmt::format("{} / {}", p, by);
    if (all_are(points, [&](long v) { return (v + by - 1) / by; })) {
      return fmt::format("({} + {}) / {}", p, by - 1, by);
    }
  }
  // Verilog's 1 << 33 is no size.
  const auto is_small = [](const auto& v) { return v.first >= 0 && v.first < 31; };
  if (std::ranges::count_if(points, is_small) > 1 &&
      std::ranges::all_of(
          points, [&](const auto& v) { return !is_small(v) || v.second == 1L << v.first; })) {
    return "1 << " + p;
  }
  const long above = size - bits_for(at);
  if (all_are(points, [&](long v) { return bits_for(v) + above; })) {
    return sum(fmt::format("clog2({})", p), above);
  }
  return "";
}

struct Tried {
  long value;
  rtl::Shape shape;
};

// Two parameters that a size is a multiple of are its factors; else it is not known.
void put(FoundSize& size, const std::string& p, long value, const Points& points) {
  const bool changes = !all_are(points, [s = points.front().second](long) { return s; });
  if (!changes || size.text == "?") return;
  const std::string form = points.size() < 3 ? "" : form_of(p, points);
  if (size.text.empty()) {
    size.text = form.empty() ? "?" : form;
    return;
  }
  // "{A} * n" where n is the value of this one.
  const std::string by = fmt::format(" * {}", value);
  const bool fits =
      size.text.ends_with(by) && form == fmt::format("{} * {}", p, size.number / value);
  size.text = fits ? size.text.substr(0, size.text.size() - by.size()) + " * " + p : "?";
}

}  // namespace

void follow_parameters(Found& found, const rtl::Shape& shape, const RtlQuestion& question,
                       const std::filesystem::path& work, StateLine& line) {
  std::vector<std::string> verilator = rtl::tree_options(verilator_program(), run_for_rtl);
  verilator.insert(verilator.begin(), verilator_program());
  constexpr long most = 1L << 24;
  std::map<std::string, std::vector<Tried>> tried;
  std::vector<std::pair<std::string, long>> all;
  for (const auto& [name, value] : shape.parameters) {
    if (value >= 0 && value < most) {
      all.emplace_back(name, value);
      tried[name] = {{value, shape}};
    }
  }
  std::mutex one;
  std::uint64_t done = 0;
  in_parallel(all.size(), cores(), [&](std::uint64_t i) {
    const auto& [name, value] = all[i];
    // A width in bytes needs a step of more than 8 to show.
    for (const long other : {value < 2 ? value + 2 : 2 * value, value + 1, 8 * value + 9}) {
      auto found_so =
          shape_with(question, name, other, verilator, work / fmt::format("{}_{}", name, other));
      if (!found_so) continue;
      const bool same =
          found_so->nets == shape.nets && found_so->ports.size() == shape.ports.size();
      tried.at(name).push_back({other, std::move(*found_so)});
      if (same && tried.at(name).size() == 2) {
        // A parameter may have the next value by another one alone.
        const auto others = [&, &n = name](const rtl::Shape& s) {
          auto list = s.parameters;
          std::erase_if(list, [&](const auto& p) { return p.first == n; });
          return list;
        };
        if (others(tried.at(name).back().shape) == others(shape)) break;
      }
    }
    const std::lock_guard lock(one);
    line.show(
        fmt::format("{}: tried {} of {}", question.top, ++done, count(all.size(), "parameter")));
    return true;
  });
  // What follows another parameter is none of the shape's own.
  std::set<std::string> derived;
  const auto value_in = [](const rtl::Shape& s, const std::string& name) {
    const auto p =
        std::ranges::find_if(s.parameters, [&](const auto& q) { return q.first == name; });
    return p == s.parameters.end() ? -1 : p->second;
  };
  for (const auto& [name, value] : shape.parameters) {
    for (const auto& [other, tries] : tried) {
      for (const Tried& t : tries) {
        if (other != name && value_in(t.shape, name) != value) derived.insert(name);
      }
    }
  }
  std::erase_if(found.parameters,
                [&](const FoundParameter& p) { return derived.contains(p.name); });
  for (auto* nets : {&found.inputs, &found.outputs, &found.registers}) {
    for (FoundNet& net : *nets) {
      for (const auto& [name, tries] : tried) {
        if (derived.contains(name)) continue;
        Points bits, words;
        for (const Tried& t : tries) {
          const auto same = t.shape.nets.find(net.name);
          if (same == t.shape.nets.end()) continue;
          bits.emplace_back(t.value, same->second.width);
          words.emplace_back(t.value, same->second.words);
        }
        if (bits.empty() || bits.front().first != tries.front().value) continue;
        put(net.width, '{' + name + '}', tries.front().value, bits);
        put(net.words, '{' + name + '}', tries.front().value, words);
      }
      for (FoundSize* size : {&net.width, &net.words}) {
        if (size->text == "?") size->text.clear();
      }
    }
  }
}

}  // namespace cosim::cli
