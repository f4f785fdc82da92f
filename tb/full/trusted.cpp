#include "tb/full/trusted.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "model/core/input_error.h"
#include "tb/cli/registry.h"
#include "tb/equiv/front_end.h"
#include "tb/equiv/referee.h"
#include "tb/full/readable.h"
#include "tb/nets/runs.h"
#include "tb/proof/rtl_nets.h"
#include "tb/util/hash.h"
#include "tb/util/json.h"
#include "tb/util/json_at.h"
#include "tb/util/output_file.h"
#include "tb/util/place.h"
#include "tb/util/random.h"
#include "tb/util/read_file.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;
using nets::no;

constexpr int time_for_one = 60;  // seconds

std::string key_of(const nets::Model& model, const proof::Source& source) {
  std::string key = COSIM_REFEREE_VERSION + hash_of_rtl(source);
  for (const nets::Wire& w : model.machine.registers) key += w.field.net + std::string("\n");
  return hash_of(key);
}

// The cells of a side and the gates, 64 random clocks at a time.
class SideBySide {
 public:
  SideBySide(const equiv::Side& side, const proof::RtlNets& gates) {
    nets::Bits unknown, state;
    for (std::size_t i = 0; i < side.registers.size(); ++i) state.push_back(input(states_));
    for (std::size_t i = 0; i < side.unknowns; ++i) unknown.push_back(input(unknowns_));
    made_ = side.make(
        cells_, [&](const equiv::Name& name) { return port(name); }, unknown, state);
    // A word of a memory that nothing writes.
    for (std::size_t i = 0; i < side.registers.size(); ++i) {
      if (made_.next[i] != state[i] || side.registers[i].any) continue;
      const std::uint64_t always = side.registers[i].first ? ~std::uint64_t{0} : 0;
      constants_.emplace_back(states_[i], always);
    }
    std::map<std::size_t, nets::Bit> given;
    std::map<std::size_t, std::size_t> input_of;  // of nets_, by gate of the RTL
    const auto give = [&](nets::Bit net) {
      input_of[net.gate()] = nets_.inputs().size();
      given[net.gate()] = nets_.input();
    };
    for (const auto* free : {&gates.pins(), &gates.undefined()}) std::ranges::for_each(*free, give);
    for (const auto& f : gates.flip_flops()) give(f.now);
    const nets::Bits bits = placed(nets_, gates.graph(), given);
    for (const auto& [name, at] : ports_) {
      if (gates.width(name.first) > name.second) {
        pairs_.emplace_back(input_of.at(gates.net(name.first, name.second).gate()), at);
      }
    }
    // Registers by the names that both have.
    std::set<std::size_t> taken;
    for (const auto& [name, registers] : side.variables) {
      if (gates.width(name) != static_cast<int>(registers.size())) continue;
      for (std::size_t b = 0; b < registers.size(); ++b) {
        const auto shown = gates.shown(gates.net(name, static_cast<int>(b)));
        if (!shown || !taken.insert(*shown).second) continue;
        const auto& flip_flop = gates.flip_flops()[*shown];
        pairs_.emplace_back(input_of.at(flip_flop.now.gate()), states_[registers[b]]);
        compared_.push_back({fmt::format("register {}[{}]", name, b), made_.next[registers[b]],
                             placed_at(bits, flip_flop.next)});
      }
    }
    unpaired_ = gates.flip_flops().size() - taken.size();
    for (const auto& [name, lit] : made_.outputs) {
      if (gates.width(name.first) <= name.second) continue;
      compared_.push_back({fmt::format("output {}[{}]", name.first, name.second), lit,
                           placed_at(bits, gates.net(name.first, name.second))});
    }
  }

  // The first difference, or nothing.
  ReadAs differs(int rounds) {
    if (unpaired_ > 0) {
      return {"", fmt::format("{} flip-flops have no register of their name", unpaired_)};
    }
    Random random = Random::for_case(1989, 0);
    for (int round = 0; round < rounds; ++round) {
      std::vector<std::uint64_t> in(cells_.inputs().size()), of_nets(nets_.inputs().size());
      for (auto& word : in) word = random.next();
      for (auto& word : of_nets) word = random.next();
      for (const auto& [at, word] : constants_) in[at] = word;
      for (const auto& [gate_input, at] : pairs_) of_nets[gate_input] = in[at];
      const auto gates = nets::run(nets_, of_nets);
      // What is not known is 0, 1, or anything: what it then changes is no difference. Most often a
      // few such values show that there is none; some depend on two that are seldom unlike.
      constexpr int few = 3, many = 64;
      std::vector<std::uint64_t> varies(compared_.size()), first(compared_.size());
      for (int fill = 0; fill < many; ++fill) {
        for (const std::size_t at : unknowns_) {
          in[at] = fill == 0 ? 0 : fill == 1 ? ~std::uint64_t{0} : random.next();
        }
        nets::Runs runs(cells_);
        runs.clock(in);
        std::size_t wrong = compared_.size();
        for (std::size_t i = 0; i < compared_.size(); ++i) {
          const std::uint64_t is = runs.of(compared_[i].cell);
          if (fill == 0) first[i] = is;
          varies[i] |= is ^ first[i];
          if (((nets::in_runs(gates, compared_[i].gate) ^ first[i]) & ~varies[i]) != 0) wrong = i;
        }
        if (wrong == compared_.size() && fill + 1 >= few) break;
        if (wrong < compared_.size() && fill + 1 == many) {
          return {"", compared_[wrong].name + ": its gates say another value than its cells", true};
        }
      }
    }
    return {};
  }

 private:
  struct Compared {
    std::string name;
    nets::Bit cell;
    nets::Bit gate;
  };
  nets::Bit input(std::vector<std::size_t>& kind) {
    kind.push_back(cells_.inputs().size());
    return cells_.input();
  }
  nets::Bit port(const equiv::Name& name) {
    const auto [at, is_new] = ports_.try_emplace(name, cells_.inputs().size());
    if (is_new) port_lits_[name] = cells_.input();
    return port_lits_.at(name);
  }

  nets::Graph cells_;
  nets::Graph nets_;
  std::vector<std::size_t> states_, unknowns_;                    // inputs of cells_
  std::vector<std::pair<std::size_t, std::uint64_t>> constants_;  // states that are always the same
  std::map<equiv::Name, std::size_t> ports_;
  std::map<equiv::Name, nets::Bit> port_lits_;
  equiv::Side::Made made_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  // inputs of both
  std::vector<Compared> compared_;
  std::size_t unpaired_ = 0;
};

ReadAs judged(const nets::Model& model, const proof::Source& source) {
  const equiv::Budget budget(time_for_one);
  const bool steps = source.clocks_are_inputs;
  equiv::Referee how{steps, {}, true, true, budget.ends()};
  for (const nets::Wire& w : model.machine.reset_inputs) {
    if (w.code.size() == 1) how.resets[net_path(w.field.net).path] = w.code.front() == nets::yes;
  }
  const proof::RtlNets gates(source);
  // What the first front end comes to that does not refuse the RTL.
  ReadAs first;
  bool is_refused = true;
  for (const equiv::FrontEnd front_end : {equiv::FrontEnd::yosys, equiv::FrontEnd::slang}) {
    if (front_end == equiv::FrontEnd::slang && !equiv::has_slang()) break;
    ReadAs one;
    bool is_read = true;
    try {
      equiv::Side side(files_of(source), "the RTL", front_end, budget);
      side.make_gates(equiv::Memories::registers, steps, budget);
      std::erase_if(how.resets, [&](const auto& r) { return !side.inputs.contains(r.first); });
      const equiv::Refereed is = refereed(side, how);
      if (is.agrees) {
        constexpr int rounds = 1600;  // of 64 clocks: 10^5
        one = SideBySide(side, gates).differs(rounds);
      } else {
        one = {"", is.wrong, !is.by.empty()};
      }
      if (one.why.empty()) {
        one.by = fmt::format("read by {}, as {} simulates it on {} clocks", name_of(front_end),
                             is.by, is.clocks);
        return one;
      }
    } catch (const InputError& error) {
      one = {"", error.what(), true};
      is_read = false;
    } catch (const equiv::OutOfTime&) {
      one.why = fmt::format("not in {} s", time_for_one);
    }
    if (first.why.empty() || (is_refused && is_read)) first = one;
    is_refused = is_refused && !is_read;
  }
  return first;
}

}  // namespace

ReadAs read_as(const nets::Model& model, const proof::Source& source) {
  const fs::path folder = fs::path(registry().build_folder()) / "referee";
  const fs::path kept = folder / key_of(model, source);
  std::error_code error;
  if (fs::is_regular_file(kept, error)) {
    const std::string text = read_file(kept.string());
    const auto lines = JsonAt(kept.string(), text);
    return {lines.at("by").text(), lines.at("why").text(), lines.at("is_wrong").yes()};
  }
  const ReadAs is = judged(model, source);
  // What could not be compared may be, another time.
  if (is.by.empty() && !is.is_wrong) return is;
  fs::create_directories(folder, error);
  if (!error) {
    write_file(kept.string(),
               json_text({{"by", is.by}, {"why", is.why}, {"is_wrong", is.is_wrong}}));
  }
  return is;
}

void require_read(const nets::Model& model, const proof::Source& source) {
  const ReadAs is = read_as(model, source);
  if (!is.is_wrong) return;
  throw InputError(fmt::format("{}: {}", source.top, is.wrong()));
}

}  // namespace cosim::cli
