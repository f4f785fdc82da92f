// What is claimed of a design beyond its RTL, as theorems on its golden model. A design brings them
// by defining std::vector<Theorem> cosim::DESIGN::theorems() in tb/designs/DESIGN/proof.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/core/fields.h"
#include "tb/nets/number.h"
#include "tb/proof/questions.h"

namespace cosim::proof {

/// A question in two forms, with the theorem negated, which cannot be, and its premises alone,
/// which can: so it says something.
struct OnIntegers {
  std::string negated, premises;  ///< scripts of one question each, for z3
};
struct OnBits {
  std::string what;     ///< a few words: "i = 5", a machine
  Questions questions;  ///< asked[0]: negated, asked[1]: premises
};

struct Theorem {
  std::string design;
  std::string sentence;  ///< for a person, whole
  // One of them:
  std::optional<OnIntegers> on_integers = {};
  std::vector<OnBits> on_bits = {};

  const char* engine() const { return on_integers ? "z3" : "cadical"; }
};

/// Those of all designs; made by CMake.
std::vector<Theorem> theorems();

struct Judgement {
  bool proved = false;
  bool timed_out = false;
  std::string verdict;  ///< "proved", "REFUTED (W=8)", "UNDECIDED: timed out (W=32)"
  double seconds = 0;   ///< of processor time
};
/// Asks its engine, `limit` seconds of processor time at the most for a question. InputError where
/// there is none.
Judgement judged(const Theorem& theorem, int limit);

/// Several lists as one.
std::vector<Theorem> joined(std::vector<std::vector<Theorem>> lists);

/// Free numbers as bits of a graph, and what is assumed of them.
class FreeNumbers {
 public:
  /// Without a sign, or in two's complement.
  nets::Number number(const std::string& name, int width);
  nets::Number signed_number(const std::string& name, int width);
  void assume(const nets::Truth& condition) { assumed_ = assumed_ & condition; }
  /// Asks whether `wrong` can be; `what`: of what.
  OnBits asked(const std::string& what, const nets::Truth& wrong);

 private:
  nets::Bits code(const std::string& name, int width);

  nets::Graph graph_;
  std::vector<nets::Port> inputs_;
  nets::Truth assumed_ = true;
};

/// The values of a machine's parameters, in its own order.
using Widths = std::vector<Parameter>;

/// A theorem on a design's model at every width that is shipped. `wrong` gives what must not be.
Theorem at_every_width(const std::string& design, const std::string& sentence,
                       nets::Truth (*wrong)(const Widths&, FreeNumbers&));

}  // namespace cosim::proof
