// Golden models as their exporters wrote them, run on bits of gates.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/clocked/design.h"
#include "tb/nets/number.h"

namespace cosim::nets {

struct Btor2;
/// The file of a model, read once. InputError where it is not there, or the model could not be
/// exported.
const Btor2& exported_model(const std::string& path);

}  // namespace cosim::nets

namespace cosim::clocked {

template <>
struct SymbolsOf<nets::Number> {
  using Question = Asked<nets::Number>;
  using Cells = std::vector<SymbolCell<nets::Number>>;

  /// Sets the values of `wanted`, the cells of a record, to what a section of the file gives:
  /// "next" as numbers; "out", the outputs that are in no section, or those of any other as codes.
  /// InputError where the file is not there, or the model could not be exported.
  static void give(const Question& asked, const std::string& section, Cells& wanted);
  /// Its outputs of one bit.
  static std::vector<nets::Truth> conditions(const Question& asked, const std::string& section);
  /// The words of the ways in the file, as they are in their comments, and whether each is taken.
  static std::vector<std::pair<std::string, nets::Truth>> ways(const Question& asked);
};

}  // namespace cosim::clocked
