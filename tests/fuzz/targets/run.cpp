// run.json with hashes that fit: the run is one that can be gone on with, or is refused.
#include "tests/fuzz/run.h"

#include "tb/sweep/checkpoint.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cosim;
  static const fuzz::RunInAFolder run([](const std::vector<regress::Part>&) { return Json(); });
  const std::string text = fuzz::text_of(data, size);
  Json json = fuzz::object_of(text);
  if (!json.is_null()) {
    json["program"] = program_hash();
    json["plan"] = hash_of(read_file((run.path() / "plan.json").string()));
    json.erase("hash");
    json["hash"] = hash_of(json_text(json));
  }
  fuzz::write(run.path() / "run.json", json.is_null() ? text : json_text(json));
  fuzz::accepted(run.path().string(), [&] {
    const regress::RunFolder read(run.path(), run.kinds());
    const auto none =
        regress::read_results(read.path() / "results", read.identity(), read.shards().size());
    const auto report = regress::report(read, run.kinds(), none);
    fuzz::expect(report.json["verdict"] == "unfinished", "nothing was run");
    fuzz::expect(regress::missing(read, none, ends_at_failure(read, run.kinds())).size() ==
                     read.shards().size(),
                 "every shard is missing");
  });
  return 0;
}
