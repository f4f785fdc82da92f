// run.json with hashes that fit: the run is one that can be gone on with, or is refused.
#include "tests/fuzz/run.h"

#include "tb/sim/checkpoint.h"

namespace cosim::fuzz {

FUZZ_TARGET(run) {
  static const RunInAFolder run([](const std::vector<regress::Part>&) { return Json(); });
  Json json = object_of(text);
  if (!json.is_null()) {
    json["program"] = program_hash();
    json["plan"] = hash_of(read_file((run.path() / "plan.json").string()));
    json.erase("hash");
    json["hash"] = hash_of(json_text(json));
  }
  write(run.path() / "run.json", json.is_null() ? text : json_text(json));
  accepted(run.path().string(), [&] {
    const regress::RunFolder read(run.path(), run.kinds());
    const auto none =
        regress::read_results(read.path() / "results", read.identity(), read.shards().size());
    const auto report = regress::report(read, run.kinds(), none);
    expect(report.json["verdict"] == "unfinished", "nothing was run");
    expect(regress::missing(read, none, ends_at_failure(read, run.kinds())).size() ==
               read.shards().size(),
           "every shard is missing");
  });
}

}  // namespace cosim::fuzz
