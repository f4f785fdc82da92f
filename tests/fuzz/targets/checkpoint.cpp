// The state in a checkpoint, with a hash that fits: the sweeps go on from it, or it is refused.
#include "model/linear/host.h"
#include "tb/cli/sweep_checkpoint.h"
#include "tests/fuzz/machines.h"
#include "tests/fuzz/run.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cosim;
  static const auto linear = fuzz::bench<linear::Design, linear::Params{5, 2}>();
  static const Scratch scratch;
  static const std::string path = (scratch.path() / "state").string();
  const std::string text = fuzz::text_of(data, size);
  std::vector<std::string> errors;
  const Json state = parse_json(text, errors);
  if (errors.empty()) {
    const Json file{{"work", "work, program " + program_hash()},
                    {"hash", hash_of(json_text(state))},
                    {"state", state}};
    fuzz::write(path, json_text(file));
  } else {
    fuzz::write(path, text);
  }
  constexpr std::uint64_t cases = 1000;
  fuzz::accepted(path, [&] {
    cli::SweepCheckpoint checkpoint(path, "work");
    for (int sweep = 0; sweep < 2; ++sweep) {
      const Resume resume = checkpoint.resume(*linear, cases);
      fuzz::expect(resume.done.cases <= cases, "no more is done than there is");
      resume.keep(resume.done);
    }
  });
  return 0;
}
