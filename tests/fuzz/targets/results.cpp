// Lines of results with hashes that fit: what they say comes to the report, or is refused.
// Needs: linear
#include <sstream>

#include "tb/cli/result_json.h"
#include "tb/sim/report.h"
#include "tests/designs/linear/records.h"
#include "tests/fuzz/machines.h"
#include "tests/fuzz/run.h"

namespace cosim::fuzz {
namespace {

// As a sweep merges.
Json merged(const std::vector<regress::Part>& parts) {
  static const auto linear = bench<linear::Design, linear::of(5, 2)>();
  Result sum;
  for (const regress::Part& part : parts) {
    part.result.at("cases").whole(part.failed ? 1 : part.units(), part.units());
    add(sum, cli::result_from(part.result, *linear));
  }
  return json_of(run_json({linear.get(), "work", sum}));
}

}  // namespace

FUZZ_TARGET(results) {
  static const RunInAFolder folder(merged);
  static const regress::RunFolder run(folder.path(), folder.kinds());
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    if (Json json = object_of(line); !json.is_null()) {
      json.erase("hash");
      json["hash"] = hash_of(run.identity() + json_text(json));
      line = json_text(json);
    }
    all += line + '\n';
  }
  write(run.path() / "results" / "a.jsonl", all);
  accepted(run.path().string(), [&] {
    const auto results =
        regress::read_results(run.path() / "results", run.identity(), run.shards().size());
    json_text(regress::report(run, folder.kinds(), results).json);
  });
}

}  // namespace cosim::fuzz
