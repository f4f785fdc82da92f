#include "tb/cli/choose.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"

namespace cosim::cli {
namespace {

template <class Design>
std::string built() {
  std::string text;
  for (const auto* bench : benches_of<Design>()) {
    text += (text.empty() ? "" : ", ") + bench->title().substr(bench->design().size() + 1);
  }
  return text;
}

template <class Design, class Keep, class Size>
std::vector<const Bench<Design>*> keep(const std::string& asked, Keep keep, Size size) {
  auto found = benches_of<Design>();
  std::erase_if(found, [&](const auto* bench) { return !keep(bench->params()); });
  if (found.empty()) {
    throw InputError(
        fmt::format("{} {} was not built; built are {}", Design::name, asked, built<Design>()));
  }
  std::stable_sort(found.begin(), found.end(), [&](const auto* a, const auto* b) {
    return size(a->params()) < size(b->params());
  });
  return found;
}

template <class Design, class Shape>
std::vector<const Bench<Design>*> of_width(const Shape& s) {
  return keep<Design>(
      s.width ? fmt::format("W={}", *s.width) : "",
      [&](const auto& p) { return !s.width || *s.width == p.width; },
      [](const auto& p) { return p.width; });
}

template <class Design>
const Bench<Design>& at_least(const std::vector<const Bench<Design>*>& found, int width,
                              const char* work) {
  for (const auto* bench : found) {
    if (width <= bench->params().width) return *bench;
  }
  throw InputError(
      fmt::format("{} that needs {} bits does not fit {}", work, width, found.back()->title()));
}

}  // namespace

std::vector<const Bench<linear::Design>*> matching(const LinearShape& s) {
  std::string asked;
  if (s.m) asked += fmt::format("M={}", *s.m);
  if (s.n) asked += fmt::format("{}N={}", s.m ? " " : "", *s.n);
  return keep<linear::Design>(
      asked,
      [&](const linear::Params& p) { return (!s.m || *s.m == p.m) && (!s.n || *s.n == p.n); },
      [](const linear::Params& p) { return p.m; });
}

std::vector<const Bench<circular::Design>*> matching(const CircularShape& s) {
  return of_width<circular::Design>(s);
}

std::vector<const Bench<dda::Design>*> matching(const DdaShape& s) {
  return of_width<dda::Design>(s);
}

const Bench<linear::Design>& choose(LinearShape shape, std::int64_t major) {
  const auto found = matching(shape);
  for (const auto* bench : found) {
    if (major >> bench->params().m == 0) return *bench;
  }
  throw InputError(fmt::format("a line of {} major steps does not fit {}: BP < 2^{}", major,
                               found.back()->title(), found.back()->params().m));
}

const Bench<circular::Design>& choose(CircularShape shape, int width) {
  return at_least(matching(shape), width, "an arc");
}

const Bench<dda::Design>& choose(DdaShape shape, int width) {
  return at_least(matching(shape), width, "a curve");
}

}  // namespace cosim::cli
