#include <fmt/core.h>

#include "tb/equiv/referee.h"
#include "tb/equiv/referee_memories.h"
#include "tb/equiv/stepped.h"
#include "tb/equiv/vhdl_run.h"

namespace cosim::equiv {
namespace {

using Inputs = RefereeInputs::Row;

// GHDL shows no registers, and gives them no values: those without an initial one are x until they
// are written.
class VhdlMatch {
 public:
  VhdlMatch(const Side& side, const Referee& how)
      : side_(side),
        how_(how),
        is_cut_(!side.memories.empty() && side.is_cut()),
        stepped_(side, is_cut_, how.steps) {
    for (std::size_t i = 0; i < side.registers.size(); ++i) {
      const Register& reg = side.registers[i];
      stepped_.begin(i, reg.any ? 'x' : reg.first ? '1' : '0');
    }
  }

  Refereed judged() {
    const VhdlStimulus asked = stimulus();
    std::vector<std::string> files;
    for (const auto& file : side_.files().vhdl) files.push_back(file.string());
    const VhdlRun ran =
        run_vhdl(files, side_.files().top, side_.files().parameters, asked, how_.until);
    Refereed is;
    is.wrong = ran.error;
    if (ran.rows.empty()) return is;
    is.by = "GHDL";
    for (std::size_t t = 0; t < ran.rows.size() && wrong_.empty(); ++t) {
      std::size_t at = asked.clocks.size();
      for (const auto& [port, width] : asked.inputs) {
        rows_[t][port] = ran.inputs[t].substr(at, static_cast<std::size_t>(width));
        at += static_cast<std::size_t>(width);
      }
      stepped_.clock(rows_[t]);
      at = 0;
      for (const auto& [port, width] : asked.outputs) {
        for (int bit = width; bit-- > 0;) compare({t, {port, bit}, ran.rows[t][at++]});
      }
      ++is.clocks;
    }
    judge_vague();
    is.wrong = wrong_;
    is.agrees = is.wrong.empty();
    return is;
  }

 private:
  // A bit of an output, and what GHDL says.
  struct Seen {
    std::size_t clock;
    Name output;
    char digit;
  };

  VhdlStimulus stimulus() {
    const Stimulus s =
        referee_stimulus(side_, how_, Simulator::ghdl, stepped_.graph().gates().size(), rows_);
    rows_.erase(rows_.begin());  // before the first clock
    VhdlStimulus all;
    all.falls = side_.clocks;
    for (const auto& [clock, falls] : side_.clocks) all.clocks.push_back(clock);
    for (const std::string& port : s.inputs) {
      if (!side_.clocks.contains(port)) all.inputs.emplace_back(port, side_.inputs.at(port));
    }
    for (const std::string& port : s.outputs)
      all.outputs.emplace_back(port, side_.outputs.at(port));
    for (const Inputs& one : rows_) {
      std::string row;
      for (const std::string& clock : all.clocks) row += how_.steps ? one.at(clock) : "1";
      for (const auto& [port, width] : all.inputs) row += one.at(port);
      all.rows.push_back(row);
    }
    return all;
  }

  bool all_is_known() {
    if (!side_.memories.empty()) return false;
    for (std::size_t i = 0; i < side_.registers.size(); ++i) {
      if (Stepped::digit(stepped_.seen(i)) == 'x') return false;
    }
    return true;
  }

  void compare(const Seen& seen) {
    const char netlist = Stepped::digit(stepped_.output(seen.output));
    if (seen.digit == netlist || !wrong_.empty()) return;
    if (netlist == 'x') {
      vague_.push_back(seen);
    } else if (is_known(seen.digit) || all_is_known()) {
      say_wrong(seen, netlist);
    }
  }

  // An x of the netlist that comes from registers or memories without an initial value is gone
  // where these begin as something; one that is there whatever they begin as is of the logic
  // itself, and GHDL says that there is none.
  void judge_vague() {
    constexpr unsigned fills = 4;
    for (unsigned fill = 0; fill < fills && !vague_.empty() && wrong_.empty(); ++fill) {
      Stepped alike(side_, is_cut_, how_.steps);
      alike.begin_alike(fill);
      std::vector<Seen> left;
      auto at = vague_.begin();
      for (std::size_t t = 0; at != vague_.end(); ++t) {
        alike.clock(rows_[t]);
        for (; at != vague_.end() && at->clock == t; ++at) {
          if (Stepped::digit(alike.output(at->output)) == 'x') left.push_back(*at);
        }
      }
      vague_ = std::move(left);
    }
    if (!vague_.empty()) say_wrong(vague_.front(), 'x');
  }

  void say_wrong(const Seen& seen, char netlist) {
    const auto& [port, bit] = seen.output;
    const bool is_word = side_.outputs.at(port) > 1;
    wrong_ =
        fmt::format("output {}{} is {} on clock {} in GHDL, and {} on the netlist that {} reads",
                    port, is_word ? fmt::format("[{}]", bit) : "", seen.digit, seen.clock, netlist,
                    name_of(side_.front_end()));
  }

  const Side& side_;
  const Referee& how_;
  bool is_cut_;
  Stepped stepped_;
  std::vector<Inputs> rows_;
  std::vector<Seen> vague_;
  std::string wrong_;
};

}  // namespace

Refereed refereed_vhdl(const Side& side, const Referee& how) {
  return VhdlMatch(side, how).judged();
}

}  // namespace cosim::equiv
