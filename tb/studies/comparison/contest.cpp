#include "tb/studies/comparison/contest.h"

#include <fmt/core.h>

#include "tb/util/json.h"

namespace cosim::compare {
namespace {

std::string gaps(const Figures& f) {
  if (f.smallest_gap > f.largest_gap) return "-";
  return fmt::format("{:.2f} to {:.2f}", f.smallest_gap, f.largest_gap);
}

}  // namespace

std::string to_text(const std::vector<Entry>& entries) {
  std::string text =
      fmt::format("{:17} {:>9} {:>9}  {:>13}  {:>13}  {:>6}  {:>14}  {:>5}\n", "", "clocks",
                  "steps", "axial max rms", "radial max rms", "end", "gaps", "kinds");
  for (const Entry& e : entries) {
    const Figures& f = e.figures;
    text += fmt::format(
        "{:17} {:>9} {:>9}  {:>7.3f} {:.3f}  {:>8.3f} {:.3f}  {:>6.3f}  {:>14}  {:>5}\n", e.name,
        f.clocks, f.steps, f.axial.largest, f.axial.rms(), f.radial.largest, f.radial.rms(),
        f.end_error, gaps(f), f.combinations_used());
  }
  return text;
}

std::string to_json(const std::vector<Entry>& entries) {
  Json all = Json::array();
  for (const Entry& e : entries) {
    const Figures& f = e.figures;
    Json one;
    one["algorithm"] = e.name;
    if (e.bench != nullptr) one["machine"] = e.bench->title();
    one["paths"] = f.paths;
    one["clocks"] = f.clocks;
    one["steps"] = f.steps;
    one["axial_deviation"] = {{"max", f.axial.largest}, {"rms", f.axial.rms()}};
    one["radial_deviation"] = {{"max", f.radial.largest}, {"rms", f.radial.rms()}};
    one["end_error"] = f.end_error;
    if (f.smallest_gap <= f.largest_gap) one["gaps"] = {f.smallest_gap, f.largest_gap};
    one["combinations"] = f.combinations_used();
    all.push_back(std::move(one));
  }
  return json_text(all);
}

}  // namespace cosim::compare
