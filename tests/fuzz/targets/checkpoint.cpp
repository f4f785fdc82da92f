// The state in a checkpoint, with a hash that fits: the sweeps go on from it, or it is refused.
// Needs: linear
#include "tb/cli/sweep_checkpoint.h"
#include "tests/designs/linear/records.h"
#include "tests/fuzz/machines.h"
#include "tests/fuzz/run.h"

namespace cosim::fuzz {

FUZZ_TARGET(checkpoint) {
  static const auto linear = bench<linear::Design, linear::of(5, 2)>();
  static const Scratch scratch;
  static const std::string path = (scratch.path() / "state").string();
  std::vector<std::string> errors;
  const Json state = parse_json(text, errors);
  if (errors.empty()) {
    const Json file{{"work", "work, program " + program_hash()},
                    {"hash", hash_of(json_text(state))},
                    {"state", state}};
    write(path, json_text(file));
  } else {
    write(path, text);
  }
  constexpr std::uint64_t cases = 1000;
  accepted(path, [&] {
    cli::SweepCheckpoint checkpoint(path, "work");
    for (int sweep = 0; sweep < 2; ++sweep) {
      const Resume resume = checkpoint.resume(*linear, cases);
      expect(resume.done.cases <= cases, "no more is done than there is");
      resume.keep(resume.done);
    }
  });
}

}  // namespace cosim::fuzz
