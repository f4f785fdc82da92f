#include <fmt/format.h>

#include <charconv>
#include <memory>

#include "model/core/input_error.h"
#include "model/linear/control_code.h"
#include "tb/check.h"
#include "tb/cli/choose.h"
#include "tb/cli/command.h"
#include "tb/cli/conclude.h"
#include "tb/cli/number.h"
#include "tb/cli/shape_options.h"
#include "tb/output_file.h"
#include "tb/table.h"

namespace cosim::cli {
namespace {

constexpr std::uint64_t most_steps = 0xffffffff;

struct Options {
  Common common;
  std::string major, minor, code = "best";
  ShapeOptions shape;
};

// A code of m bits: its bits, or its value in decimal, 0x hexadecimal or 0b binary.
linear::Code parse_code(const std::string& text, int m) {
  const bool bits = text.find_first_not_of("01") == std::string::npos;
  const std::uint64_t largest = (std::uint64_t{1} << m) - 1;
  std::size_t skip = 0;
  int base = 10;
  if (bits && text.size() == static_cast<std::size_t>(m)) base = 2;
  if (text.starts_with("0b")) base = 2, skip = 2;
  if (text.starts_with("0x")) base = 16, skip = 2;
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + skip, end, value, base);
  if (error != std::errc{} || rest != end || value > largest) {
    throw InputError(fmt::format(
        "--code: '{}' is not greedy, best, {} bits, or a whole number from 0 to {}", text, m,
        largest));
  }
  return value;
}

class Rows final : public Observer<linear::Design> {
 public:
  Rows(OutputFile& file, int word) : file_(file), word_(word) {}
  void clock(std::size_t, const Compared<linear::Design>& seen) override {
    if (!seen.outputs.strobe) return;
    file_.line("{},{:0{}b},{:0{}b}", ++tick_, static_cast<std::uint64_t>(seen.outputs.major), word_,
               static_cast<std::uint64_t>(seen.outputs.minor), word_);
  }

 private:
  OutputFile& file_;
  int word_;
  std::uint64_t tick_ = 0;
};

int run(const Options& o) {
  const std::uint64_t seed = o.common.seed();
  const auto major = static_cast<std::int64_t>(whole("--major", o.major, 0, most_steps));
  const auto& bench = choose(o.shape.linear(), major);
  const linear::Params p = bench.params();

  std::optional<std::int64_t> minor;
  if (!o.minor.empty()) {
    minor = static_cast<std::int64_t>(whole("--minor", o.minor, 0, most_steps));
    if (*minor > major) {
      throw InputError(fmt::format("--minor: {} is more than --major {} (MP <= BP)", *minor, major));
    }
  }
  const bool chosen = o.code != "best" && o.code != "greedy";
  if (!chosen && !minor) throw InputError("--minor: is needed where --code gives no bits");
  linear::Code code = 0;
  if (chosen) {
    code = parse_code(o.code, p.m);
    const std::int64_t given = linear::minor_steps(p.m, major, code);
    if (minor && given != *minor) {
      throw InputError(fmt::format("--code: {} gives {} minor steps on a line of {}, not {}", o.code,
                                   given, major, *minor));
    }
    minor = given;
  } else {
    code = o.code == "best" ? linear::best_code(p.m, major, *minor)
                            : linear::greedy_code(p.m, major, *minor);
  }

  const std::string work = fmt::format("BP = {}, MP = {}, UK = {:0{}b}{}", major, *minor, code, p.m,
                                       chosen ? "" : " (" + o.code + ")");
  fmt::print("{}: {}\n", bench.title(), work);

  const linear::Job job{{major, code}, {}};
  OutputFile csv(o.common.csv);
  csv.line("tick,major,minor");
  LineCheck check(p, {&job, 1});
  Rows rows(csv, p.word());
  Observers<linear::Design> observers{&check, &rows};
  std::unique_ptr<Table<linear::Design>> table;
  if (o.common.table) observers.add(*(table = std::make_unique<Table<linear::Design>>(p)));

  Run run = bench.open(static_cast<std::uint32_t>(seed))->draw({&job, 1}, observers);
  csv.close();
  Outcome outcome{&bench, work, {}};
  outcome.result.clocks = run.clocks;
  outcome.result.cases = 1;
  outcome.result.mismatch = std::move(run.mismatch);
  outcome.result.checked = outcome.result.mismatch ? check.so_far() : check.finish();
  outcome.result.failed = work;
  return conclude({outcome}, o.common);
}

}  // namespace

void add_line(CLI::App& app, Action& action) {
  auto o = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("line", "A straight line on the linear machine");
  command->add_option("--major", o->major, "BP, steps on the major axis, 0 to 2^32 - 1")
      ->required()->type_name("BP");
  command->add_option("--minor", o->minor, "MP, steps on the minor axis, 0 to BP")->type_name("MP");
  command->add_option("--code", o->code,
                      "UK: best (default), greedy, m bits such as 01010, or a number")
      ->type_name("UK");
  o->shape.add_linear(*command);
  add_csv(*command, o->common, "tick,major,minor");
  add_table(*command, o->common);
  add_common(*command, o->common);
  command->callback([&action, o] { action = [o] { return run(*o); }; });
}

}  // namespace cosim::cli
