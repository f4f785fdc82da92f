// Mutants as yosys plants them: small faults in a design's RTL, each turned on by its number on a
// further input, mutsel.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tb/proof/rtl_nets.h"
#include "tb/proof/yosys.h"

namespace cosim::mutation {

class Planted {
 public:
  /// The list of at most `count` mutants, all there are where these are fewer. InputError where
  /// yosys cannot be run or cannot read the RTL.
  Planted(proof::Source source, unsigned count);

  const proof::Source& source() const { return source_; }
  /// What each mutant is, in the words of yosys's `mutate`, with files without their folders; that
  /// of mutsel = 1 first.
  const std::vector<std::string>& mutants() const { return mutants_; }

  /// The RTL as one flat module that has these mutants: as nets, and as Verilog.
  proof::RtlNets nets(const std::vector<unsigned>& numbers) const;
  void write_verilog(const std::vector<unsigned>& numbers, const std::filesystem::path& file) const;

 private:
  std::string prepared() const;
  void run(const std::vector<unsigned>& numbers, const std::string& then) const;

  proof::Source source_;
  std::vector<std::string> commands_;  // what plants each
  std::vector<std::string> mutants_;
};

}  // namespace cosim::mutation
