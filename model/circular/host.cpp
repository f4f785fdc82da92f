#include "model/circular/host.h"

namespace cosim::circular {

bool Host::next(Inputs<Word>& in, const Outputs<Word>& seen) {
  in = Design::rest();
  if (age_ > 0) {
    // The start shows in `running` one clock later.
    const bool first = age_ == 1;
    if (!first) steps_ += seen.step_y | seen.step_x;
    if (first || seen.running) {
      ++age_;
      const auto& count = arcs_[job_].count;
      in.stop = count && steps_ >= *count;
      return true;
    }
    age_ = 0;
    ++job_;
  }
  if (job_ == arcs_.size()) return false;
  const Setup s = setup(arcs_[job_].from, arcs_[job_].radius2);
  in.load = 1;
  in.start = 1;
  in.sector2 = s.sector2;
  in.f = low_bits(s.f, p_.width + 2);
  in.ct7 = low_bits(to_ones_complement(s.ct7, p_.width + 1), p_.width + 1);
  in.ct8 = low_bits(to_ones_complement(s.ct8, p_.width + 1), p_.width + 1);
  age_ = 1;
  steps_ = 0;
  return true;
}

std::vector<Arc> Host::smaller(const Params&, const Arc& arc) {
  std::vector<Arc> arcs;
  // Whole radii from the axis on, by powers of two less.
  const std::int64_t radius = nearest_root(arc.radius2);
  const auto add = [&](std::int64_t r) {
    arcs.push_back({{r, 0}, static_cast<std::uint64_t>(r) * static_cast<std::uint64_t>(r), {}});
  };
  for (int i = 32; i >= 0; --i) {
    if (radius >> i > 1) add(radius - (std::int64_t{1} << i));
  }
  const auto r2 = static_cast<std::uint64_t>(radius) * static_cast<std::uint64_t>(radius);
  if (radius > 0 && (arc.from.y != 0 || arc.radius2 != r2)) add(radius);
  if (!arc.count && steps_to_end(arc.from, arc.radius2) > 0) {
    arcs.push_back(arc);
    arcs.back().count = steps_to_end(arc.from, arc.radius2) / 2;
  } else if (arc.count && *arc.count > 0) {
    for (const std::int64_t count : {*arc.count / 2, *arc.count - 1}) {
      arcs.push_back(arc);
      arcs.back().count = count;
    }
  }
  return arcs;
}

std::string Host::describe(const Params&, const Arc& arc) {
  std::string text = "R^2 = " + std::to_string(arc.radius2) + " from (" +
                     std::to_string(arc.from.x) + ", " + std::to_string(arc.from.y) + ")";
  if (arc.count) text += ", at most " + std::to_string(*arc.count) + " steps";
  return text;
}

}  // namespace cosim::circular
