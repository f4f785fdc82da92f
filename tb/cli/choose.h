// Picks the bench a piece of work runs on: the smallest built one that holds it, unless named.
#pragma once

#include <cstdint>
#include <optional>

#include "model/circular/host.h"
#include "model/dda/host.h"
#include "model/linear/host.h"
#include "tb/bench/bench.h"

namespace cosim::cli {

/// What the person fixed of a machine; an absent one is free.
struct LinearShape {
  std::optional<int> m, n;
};
struct CircularShape {
  std::optional<int> width;
};
struct DdaShape {
  std::optional<int> width;
};

/// All built benches of that shape, smallest first. InputError where none was built.
std::vector<const Bench<linear::Design>*> matching(const LinearShape& shape);
std::vector<const Bench<circular::Design>*> matching(const CircularShape& shape);
std::vector<const Bench<dda::Design>*> matching(const DdaShape& shape);

/// The smallest of them with major < 2^m. InputError where none holds it.
const Bench<linear::Design>& choose(LinearShape shape, std::int64_t major);
/// The smallest of them at least `width` wide. InputError where none holds it.
const Bench<circular::Design>& choose(CircularShape shape, int width);
const Bench<dda::Design>& choose(DdaShape shape, int width);

}  // namespace cosim::cli
