// The shapes a model is tested in: those the project ships and the corners of the parameters.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "model/circular/machine.h"
#include "model/dda/machine.h"
#include "model/linear/machine.h"

namespace cosim::test {

template <class D, typename D::Params P>
struct Shape {
  using Design = D;
  static constexpr typename D::Params params = P;
};

using Shapes = testing::Types<
    Shape<linear::Design, linear::Params{2, 1}>, Shape<linear::Design, linear::Params{5, 2}>,
    Shape<linear::Design, linear::Params{6, 3}>, Shape<linear::Design, linear::Params{7, 1}>,
    Shape<linear::Design, linear::Params{8, 5}>, Shape<linear::Design, linear::Params{16, 12}>,
    Shape<linear::Design, linear::Params{16, 13}>, Shape<linear::Design, linear::Params{24, 21}>,
    Shape<linear::Design, linear::Params{32, 26}>, Shape<linear::Design, linear::Params{32, 31}>,
    Shape<circular::Design, circular::Params{2}>, Shape<circular::Design, circular::Params{4}>,
    Shape<circular::Design, circular::Params{8}>, Shape<circular::Design, circular::Params{12}>,
    Shape<circular::Design, circular::Params{16}>, Shape<circular::Design, circular::Params{24}>,
    Shape<circular::Design, circular::Params{32}>, Shape<dda::Design, dda::Params{2}>,
    Shape<dda::Design, dda::Params{6}>, Shape<dda::Design, dda::Params{8}>,
    Shape<dda::Design, dda::Params{16}>, Shape<dda::Design, dda::Params{32}>>;

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
