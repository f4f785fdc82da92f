#include "tb/cli/verdicts.h"

#include <fmt/core.h>

#include <utility>

#include "model/core/input_error.h"
#include "tb/cli/outputs.h"
#include "tb/util/output_file.h"
#include "tb/util/words.h"

namespace cosim::cli {

Verdicts::Verdicts(const std::string& command, const Common& common)
    : suite_(program_name() + ' ' + command), file_(common.junit) {}

void Verdicts::add(ci::Verdict one) {
  const auto now = std::chrono::steady_clock::now();
  if (one.seconds == 0) one.seconds = std::chrono::duration<double>(now - last_).count();
  last_ = now;
  all_.push_back(std::move(one));
}

void Verdicts::add(const Outcome& o, bool allows_nothing, double seconds) {
  ci::Verdict one{fmt::format("{}, {}", o.bench->title(), o.work)};
  one.seconds = seconds;
  one.text = swept_text(o.result) + '\n';
  if (!o.result.match()) {
    one.end = ci::Verdict::End::failure;
    one.type = "mismatch";
    one.text = o.result.mismatch ? to_text(*o.result.mismatch) : o.result.checked.error;
  } else if (compared_nothing(o) && !allows_nothing) {
    one.end = ci::Verdict::End::error;
    one.type = "nothing";
    one.text = nothing_text(o);
  }
  add(one);
}

void Verdicts::write() const {
  for (const ci::Verdict& one : all_) {
    const bool failed = one.end != ci::Verdict::End::passed;
    if (failed && ci::is_on_github()) fmt::print("{}", ci::annotation(suite_, one));
  }
  if (file_) write_file(*file_, ci::junit_text(suite_, all_));
}

void add_junit(const Command& command, Common& common) {
  command.text("--junit", common.junit, "FILE",
               "Write each verdict as a test that CI services show: JUnit's XML");
}

int with_verdicts(const std::string& command, const std::string& subject, const Common& common,
                  const std::function<int(Verdicts&)>& run) {
  check_outputs(common);
  Verdicts verdicts(command, common);
  int status = 0;
  try {
    status = run(verdicts);
  } catch (const InputError& error) {
    verdicts.add({subject, ci::Verdict::End::error, "input", error.what()});
    verdicts.write();
    throw;
  }
  verdicts.write();
  return status;
}

}  // namespace cosim::cli
