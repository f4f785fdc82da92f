// The shapes that a model is tested in: those the project ships and the corners of the parameters.
// A design has them in its shapes.h as TestedShapes; shapes.h has those of all designs.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "model/core/fields.h"

namespace cosim::test {

template <class D, typename D::Params P>
struct Shape {
  using Design = D;
  static constexpr typename D::Params params = P;
};

/// Several lists of types as one.
template <class...>
struct Joined;
template <class... A>
struct Joined<testing::Types<A...>> {
  using Types = testing::Types<A...>;
};
template <class... A, class... B, class... More>
struct Joined<testing::Types<A...>, testing::Types<B...>, More...>
    : Joined<testing::Types<A..., B...>, More...> {};

/// "linearM5N2"
struct ShapeNames {
  template <class S>
  static std::string GetName(int) {
    std::string name = S::Design::name;
    for (const Parameter& p : S::Design::parameters(S::params)) {
      name += p.name + std::to_string(p.value);
    }
    return name;
  }
};

}  // namespace cosim::test
