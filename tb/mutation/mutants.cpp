#include "tb/mutation/mutants.h"

#include <sstream>
#include <utility>

#include "tb/support/read_file.h"

namespace cosim::mutation {

Subject::Subject(std::string verilog, const std::string& list) : verilog_(std::move(verilog)) {
  std::istringstream lines(read_file(list));
  for (std::string line; std::getline(lines, line);) mutants_.push_back(line);
}

Outcome attack(const Subject& subject, unsigned mutant, std::size_t first, std::size_t last) {
  subject.choose(mutant);
  for (std::size_t i = first; i < last; ++i) {
    const Case& one = subject.cases()[i];
    const Run run = one.run();
    if (run.mismatch) {
      return {Outcome::End::killed, one.name, run.mismatch->clock, run.mismatch->signal};
    }
  }
  return {};
}

}  // namespace cosim::mutation
