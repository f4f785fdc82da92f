#include "tb/mutation/stream_lanes.h"

#include <algorithm>
#include <string_view>

namespace cosim::mutation {

StreamLanes::StreamLanes(const PlantedNets& rtl, const StreamShape& shape,
                         const std::vector<unsigned>& numbers)
    : ports_(ports_of(shape)),
      lanes_(rtl, numbers),
      inputs_(ports_.inputs.size()),
      driven_(inputs_.size()),
      outputs_(ports_.outputs.size()) {
  look_at(shape);
}

// What tb/stream/sides.h samples.
void StreamLanes::look_at(const StreamShape& shape) {
  const auto find = [&](std::string_view name, std::optional<std::size_t> where = {}) {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      if (ports_.outputs[i].name != name) continue;
      looked_.push_back({i, where});
      if (!first) first = i;
    }
    return first;
  };
  for (const auto* side : {&shape.in, &shape.out}) {
    for (const Interface& i : *side) {
      const auto valid = find(i.valid);
      for (const std::string* port : {&i.ready, &i.credit, &i.done}) find(*port);
      for (const Field& f : i.own.reads) find(f.name);
      for (const Field& f : i.cells) {
        if (!i.goes_in) find(f.name, valid);
      }
    }
  }
}

std::vector<Net> StreamLanes::nets(const Ports& ports) {
  std::vector<Net> all;
  const auto add = [&](Word& value, int width) { all.push_back({&value, sizeof value, 0, width}); };
  for (std::size_t i = 0; i < inputs_.size(); ++i) add(inputs_[i], ports.inputs[i].width);
  for (std::size_t i = 0; i < outputs_.size(); ++i) add(outputs_[i], ports.outputs[i].width);
  add(clock_, 1);
  return all;
}

bool StreamLanes::restart(std::uint32_t power_up, bool /*is_reset*/) {
  lanes_.begin(power_up);
  std::fill(inputs_.begin(), inputs_.end(), 0);
  has_begun_ = false;
  return true;
}

// One clock is a net, of which Lanes knows; each of several is an input that is 1 where it takes
// its edge.
void StreamLanes::eval() {
  if (clock_ != 0) return lanes_.rise();
  bool any_edge = false;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const Edge edge = ports_.inputs[i].edge;
    const bool is_clock = edge != Edge::none;
    const Word value = is_clock ? inputs_[i] ^ (edge == Edge::falling ? 1 : 0) : inputs_[i];
    if (value != driven_[i]) lanes_.drive(i, driven_[i] = value);
    any_edge |= is_clock && value != 0;
  }
  lanes_.settle();
  any_edge ? lanes_.rise() : show();
}

void StreamLanes::show() {
  for (const Looked& l : looked_) {
    if (l.where && outputs_[*l.where] == 0) continue;
    const Word value = outputs_[l.output] = lanes_.value(l.output, lane_);
    if (has_begun_) parted_ = parted_ | lanes_.differing(l.output, value);
  }
}

}  // namespace cosim::mutation
