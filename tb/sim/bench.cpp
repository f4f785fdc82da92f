#include "tb/sim/bench.h"

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "tb/show/picture.h"

namespace cosim {

std::string AnyBench::built_as() const {
  std::string text = design();
  for (const Parameter& p : parameters()) text += fmt::format(" {}={}", p.name, to_text(p));
  return text;
}

std::string AnyBench::title() const {
  return view().empty() ? built_as() : built_as() + ' ' + view();
}

std::string AnyBench::text_of(const HostileCase& c) const {
  return fmt::format("{} {}, seed {}", c.clocks, tables_.hostile_rows, c.seed);
}

Stimulus AnyBench::hostile(const HostileCase& /*c*/) const {
  throw InputError(design() + ": only a stimulus of it can be drawn");
}

WavePicture AnyBench::draw_wave(const std::string& path, const Stimulus& stimulus,
                                Window around) const {
  PictureSink picture;
  if (path.empty()) {
    show(stimulus, around, picture);
  } else {
    Wave wave(path);
    BothSinks both(wave, picture);
    show(stimulus, around, both);
  }
  return picture.take();
}

namespace {
std::vector<Unusable>& all_unusable() {
  static std::vector<Unusable> all;
  return all;
}
}  // namespace

const std::vector<Unusable>& unusable() { return all_unusable(); }

void add_benches(std::vector<std::unique_ptr<AnyBench>>& all,
                 void (*add)(std::vector<std::unique_ptr<AnyBench>>&)) {
  const std::size_t before = all.size();
  try {
    add(all);
  } catch (const InputError& error) {
    all.resize(before);
    const std::string why = error.what();
    all_unusable().push_back({why.substr(0, why.find_first_of(" :")), why});
  }
}

const std::vector<std::unique_ptr<AnyBench>>& benches_by(const AddBenches* add) {
  static const auto list = [&] {
    std::vector<std::unique_ptr<AnyBench>> all;
    for (; *add != nullptr; ++add) (*add)(all);
    return all;
  }();
  return list;
}

void require_shape(const AnyBench& bench, const std::string& shape) {
  if (bench.built_as() == shape) return;
  throw InputError(
      fmt::format("{}: its model says it is {}: Design::name and parameters() must be "
                  "those of cosim_add_design()",
                  shape, bench.built_as()));
}

}  // namespace cosim
