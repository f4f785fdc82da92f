// Cases run as many at a time as there are lanes. A lane that differs stops those of higher
// numbers, until the first case that differs is known. That one is run again in lockstep, by
// itself: it must differ on the same clock. The code of a shape is kept under a hash of all that it
// follows from.
#include "tb/lanes/sweep.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "model/core/input_error.h"
#include "tb/lanes/code.h"
#include "tb/lanes/player.h"
#include "tb/util/pattern.h"
#include "tb/util/read_file.h"

namespace cosim::lanes {
namespace {

namespace fs = std::filesystem;

// Planes of a memory that would not stay near the processor, and a source of hundreds of MB.
constexpr std::size_t most_bits = std::size_t{1} << 14;

// What the code of a shape follows from.
std::string key_of(const std::string& title, const nets::Played& played,
                   const proof::Source& source, int lanes) {
  std::string key = fmt::format("{} {} {}\n{}\n{}\n", COSIM_LANES_VERSION, lanes, title, tools(),
                                proof::commands_to_elaborate(source));
  std::vector<fs::path> files = source.files;
  for (const fs::path& folder : source.include_dirs) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) key += read_file(file.string());
  const nets::Machine& m = played.model.machine;
  nets::Bits out;
  const auto add = [&](const nets::Bits& bits) { out.insert(out.end(), bits.begin(), bits.end()); };
  const auto add_text = [&](const nets::Graph& graph) {
    key += aiger(graph, std::exchange(out, {}));
  };
  for (const auto* wires : {&m.registers, &m.seen, &m.outputs, &m.turned, &m.next}) {
    for (const nets::Wire& w : *wires) {
      add(w.code);
      if (w.when) add({*w.when});
      key += fmt::format("{} {} {}\n", label_of(w.field), w.field.net, w.when.has_value());
    }
  }
  add_text(played.model.graph);
  for (const auto* step : {&played.draw.clock, &played.draw.stretch}) {
    add(step->inputs);
    add(step->after);
    add_text(step->graph);
  }
  if (const auto& answer = played.draw.answer) {
    add(answer->after);
    add({answer->wrong});
    add(answer->rest);
    add_text(answer->graph);
    key += fmt::format("{}\n", answer->driver);
  }
  for (const auto* codes : {&played.reset_state, &played.reset_inputs}) {
    for (const Word code : *codes) key += fmt::format("{} ", code);
  }
  return key + fmt::format("{}", m.reset_clocks);
}

// Whether the RTL checks itself, outside of comments: what it says then, only Verilator hears.
bool speaks(const proof::Source& source) {
  static const Pattern comment(R"(//[^\n]*|/\*[^*]*\*+([^/*][^*]*\*+)*/)");
  static const Pattern says(R"(\$(error|fatal|stop|finish|warning)\b|\bassert\b)");
  for (const fs::path& file : source.files) {
    const std::string text = comment.replaced(read_file(file.string()), " ");
    if (says.in(text)) return true;
  }
  return false;
}

// The cases of a sweep, some at a time.
class Hostile {
 public:
  static constexpr std::uint64_t length = 1000;
  using Play = std::function<Outcome(std::uint64_t first, const std::vector<Part>& parts)>;

  Hostile(const AnyBench& bench, std::uint64_t lanes, std::uint64_t seed, std::uint64_t clocks,
          Play play)
      : bench_(bench), lanes_(lanes), seed_(seed), clocks_(clocks), play_(std::move(play)) {}

  Result run(std::uint64_t first, std::uint64_t count) const {
    const std::uint64_t ends = clocks_of(first + count - 1);  // of the last case, perhaps sooner
    Outcome outcome = play_(first, {{count, ends}, {count - 1, length}});
    if (outcome.differs) return failed(first, *outcome.differs);
    Result result;
    result.cases = count;
    result.clocks = (count - 1) * length + ends;
    result.left_out = std::move(outcome.left_out);
    return result;
  }

 private:
  std::uint64_t clocks_of(std::uint64_t i) const { return std::min(length, clocks_ - i * length); }
  Result failed(std::uint64_t first, const lanes::Player::Differs& differs) const {
    Result sum;
    if (differs.lane > 0) sum = run(first, differs.lane);
    const HostileCase c{seed_, first + differs.lane, clocks_of(first + differs.lane)};
    Run again = bench_.run_hostile(c);
    if (!again.mismatch || again.mismatch->clock != differs.clock) {
      throw Unconfirmed(fmt::format(
          "{}: case {}, in lane {} of {}, differs on clock {} there, and one at a time {}: an "
          "error "
          "of the lanes, or a register that nothing sets powers up otherwise; --lanes 0 runs "
          "without it",
          bench_.title(), c.index, differs.lane, lanes_, differs.clock,
          again.mismatch ? fmt::format("on clock {}", again.mismatch->clock) : "nowhere"));
    }
    Result one = hostile_result(bench_, c, std::move(again));
    one.cases = 1;
    add(sum, std::move(one));
    return sum;
  }

  const AnyBench& bench_;
  std::uint64_t lanes_, seed_, clocks_;
  Play play_;
};

Sweep sweep_of(const AnyBench& bench, std::uint64_t lanes, std::uint64_t seed, std::uint64_t clocks,
               Hostile::Play play) {
  Sweep sweep = cosim::hostile_sweep(bench, seed, clocks);
  sweep.at_once = lanes;
  sweep.run_some = [hostile = Hostile(bench, lanes, seed, clocks, std::move(play))](
                       std::uint64_t first, std::uint64_t count) {
    return hostile.run(first, count);
  };
  return sweep;
}

// The RTL as it is read. InputError, one line, where the design cannot run in lanes.
proof::Source checked(const std::string& title, const nets::Played& played,
                      const proof::Source& source) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("{}: does not run in lanes: {}", title, why));
  };
  if (!played.model.machine.legal.empty()) {
    refuse("its inputs have rules, and inputs that break one are drawn again, case by case");
  }
  if (speaks(source)) refuse("its RTL checks itself, with an assertion or $error");
  std::size_t bits = 0;
  for (const nets::Wire& w : played.model.machine.state) bits += w.code.size();
  if (bits > most_bits) {
    refuse(fmt::format("its memory is too large: {} bits, and {} can be planes", bits, most_bits));
  }
  return read_for(played.model.machine, source);
}

}  // namespace

std::unique_ptr<Built> built(const std::string& title, const nets::Played& played,
                             const proof::Source& source, int lanes, const fs::path& folder) {
  const proof::Source all = checked(title, played, source);
  return built(folder, key_of(title, played, all, lanes), lanes,
               [&] { return to_text(code_of(played, proof::RtlNets(all)), lanes); });
}

std::unique_ptr<Gpu> on_gpu(const std::string& title, const nets::Played& played,
                            const proof::Source& source, const fs::path& folder) {
  const proof::Source all = checked(title, played, source);
  return std::make_unique<Gpu>(folder, key_of(title, played, all, 0),
                               [&] { return code_of(played, proof::RtlNets(all)); });
}

Sweep hostile_sweep(const AnyBench& bench, const Built& built, std::uint64_t seed,
                    std::uint64_t clocks) {
  return sweep_of(bench, static_cast<std::uint64_t>(built.lanes), seed, clocks,
                  [&bench, &built, seed](std::uint64_t first, const std::vector<Part>& parts) {
                    Player player(built, bench);
                    player.begin(seed, first, parts.front().lanes);
                    Outcome outcome;
                    for (const Part& part : parts) {
                      player.work_below(part.lanes);
                      while (const auto differs = player.run(part.to)) {
                        outcome.differs = differs;
                        player.work_below(differs->lane);
                      }
                    }
                    outcome.left_out = player.left_out();
                    return outcome;
                  });
}
Sweep hostile_sweep(const AnyBench& bench, std::shared_ptr<Gpu> gpu, std::uint64_t seed,
                    std::uint64_t clocks) {
  return sweep_of(bench, gpu->lanes, seed, clocks, std::bind_front(&Gpu::play, gpu, seed));
}

}  // namespace cosim::lanes
