// A state and inputs that refute a claim.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/core/fields.h"
#include "tb/nets/model.h"

namespace cosim::proof {

/// One value of a signal in a counterexample.
struct Value {
  Field field;
  Word expected = 0;
  Word actual = 0;
};
/// A state and inputs under which RTL and model differ, or the RTL asserts what is not so.
struct Counterexample {
  std::vector<Value> state;         ///< of the model
  std::vector<Value> inputs;        ///< of the clock
  std::vector<Value> outputs;       ///< during the clock
  std::vector<Value> after;         ///< registers, after it
  std::vector<std::string> broken;  ///< what of the invariant the model's next state breaks
};
/// A counterexample to claim_step, or to the same of a mutant, from the values of its terms; none
/// if some are missing.
std::optional<Counterexample> counterexample(const nets::Model& model,
                                             const std::map<std::string, Word>& values);

/// What the model expects of each.
std::vector<Word> words(const std::vector<Value>& values);

/// Every signal of it, expected above actual where they differ. Lines end in '\n'.
std::string to_text(const Counterexample& c);

/// "in.start", of an element "state.store.3"; of what both sides give, "model.count.after".
std::string term_of(const char* side, const Field& field);
/// Whether the model's next state keeps sentence i of the invariant.
std::string term_of_invariant(std::size_t i);

inline constexpr const char* kSeen = ".seen";
inline constexpr const char* kOutput = ".output";
inline constexpr const char* kAfter = ".after";

}  // namespace cosim::proof
