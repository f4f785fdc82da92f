// For models with a struct of 65 to 256 members: it takes a compiler some seconds.
#pragma once

#include "model/cosim/model.h"

namespace cosim::clocked::reflect {

// clang-format off
#define COSIM_TIE(n, ...)                                              \
  template <>                                                          \
  struct Many<n> {                                                     \
    static constexpr auto tie(auto& object) {                          \
      auto& [__VA_ARGS__] = object;                                    \
      return std::tie(__VA_ARGS__);                                    \
    }                                                                  \
  };
#define COSIM_TIES(n, ...)                                             \
  COSIM_TIE((n + 1), __VA_ARGS__ a)                                    \
  COSIM_TIE((n + 2), __VA_ARGS__ a, b)                                 \
  COSIM_TIE((n + 3), __VA_ARGS__ a, b, c)                              \
  COSIM_TIE((n + 4), __VA_ARGS__ a, b, c, d)                           \
  COSIM_TIE((n + 5), __VA_ARGS__ a, b, c, d, e)                        \
  COSIM_TIE((n + 6), __VA_ARGS__ a, b, c, d, e, f)                     \
  COSIM_TIE((n + 7), __VA_ARGS__ a, b, c, d, e, f, g)                  \
  COSIM_TIE((n + 8), __VA_ARGS__ a, b, c, d, e, f, g, h)
#define COSIM_8(x) x##0, x##1, x##2, x##3, x##4, x##5, x##6, x##7,
#define COSIM_32(x) COSIM_8(x##0) COSIM_8(x##1) COSIM_8(x##2) COSIM_8(x##3)
#define COSIM_64(x) COSIM_32(x##0) COSIM_32(x##1)
#define COSIM_TIES_32(n, ...)                                          \
  COSIM_TIES(n, __VA_ARGS__)                                           \
  COSIM_TIES(n + 8, __VA_ARGS__ COSIM_8(p))                            \
  COSIM_TIES(n + 16, __VA_ARGS__ COSIM_8(p) COSIM_8(q))                \
  COSIM_TIES(n + 24, __VA_ARGS__ COSIM_8(p) COSIM_8(q) COSIM_8(r))
COSIM_TIES_32(64, COSIM_64(k))
COSIM_TIES_32(96, COSIM_64(k) COSIM_32(l))
COSIM_TIES_32(128, COSIM_64(k) COSIM_64(l))
COSIM_TIES_32(160, COSIM_64(k) COSIM_64(l) COSIM_32(m))
COSIM_TIES_32(192, COSIM_64(k) COSIM_64(l) COSIM_64(m))
COSIM_TIES_32(224, COSIM_64(k) COSIM_64(l) COSIM_64(m) COSIM_32(n))
#undef COSIM_TIE
#undef COSIM_TIES
#undef COSIM_TIES_32
#undef COSIM_8
#undef COSIM_32
#undef COSIM_64
// clang-format on

}  // namespace cosim::clocked::reflect
