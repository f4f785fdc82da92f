#include "tb/equiv/referee.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "tb/equiv/misread.h"
#include "tb/equiv/referee_memories.h"
#include "tb/equiv/simulator.h"
#include "tb/equiv/sources.h"
#include "tb/equiv/stepped.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

using Inputs = RefereeInputs::Row;

class Match {
 public:
  Match(const Side& side, const Referee& how, Simulator simulator)
      : side_(side),
        how_(how),
        simulator_(simulator),
        is_cut_(!side.memories.empty() && side.is_cut()),
        stepped_(side, is_cut_, how.steps),
        memories_(side) {
    const std::vector<SourceText> sources = sources_of(side.files());
    const bool four = simulator == Simulator::icarus;
    casex_ = four && !place_of(sources, "\\bcasex\\b").empty();
    casez_ = four && !place_of(sources, "\\bcasez\\b").empty();
  }

  Refereed judged() {
    Refereed is;
    Stimulus s = stimulus();
    const Program program(side_, s, simulator_, how_.until);
    if (!program.why_not().empty()) {
      is.wrong = program.why_not();
      return is;
    }
    is.by = name_of(simulator_);
    const Simulated ran = program.run(how_.until);
    variables_ = program.stimulus().variables;
    loads_ = program.stimulus().states;
    first_load_ = program.stimulus().first_load;
    for (const auto& [name, registers] : side_.variables) registers_of_[name] = &registers;
    sources_.emplace(side_, program.stimulus(), simulator_, how_.until);
    was_x_ = sources_->has_hidden();
    for (const Contents& one : program.stimulus().memories) {
      if (const std::string wrong = memories_.begin(one, ran, stepped_); !wrong.empty()) {
        wrong_ = wrong;
      }
    }
    begin(ran);
    constexpr std::size_t enough = 32;
    for (std::size_t t = 0; t < ran.clocks.size() && wrong_.empty(); ++t) {
      const bool is_late = !loads_.empty() && t >= first_load_;
      is_lenient_ = is_late;
      if (is_late && (t - first_load_) % load_clocks == 0) {
        load(loads_[(t - first_load_) / load_clocks]);
      } else if (was_x_) {
        take_over(ran.clocks[t], t);
      }
      stepped_.clock(rows_[t + 1]);
      compare(ran.clocks[t], t);
      if (!is_late) ++is.clocks;
    }
    if (wrong_.empty() && !vague_.empty()) find_values_lost(program, ran);
    is.wrong = wrong_;
    if (wrong_.empty() && !ran.is_complete && ran.clocks.size() < enough) {
      is.by.clear();
      is.wrong = fmt::format("{} came to clock {} only{}{}", name_of(simulator_), ran.clocks.size(),
                             ran.why.empty() ? "" : ": ", ran.why);
    }
    is.agrees = !is.by.empty() && is.wrong.empty();
    return is;
  }

 private:
  Stimulus stimulus() {
    Stimulus s = referee_stimulus(side_, how_, simulator_, stepped_.graph().gates().size(), rows_);
    if (is_cut_) memories_.add_to(s);
    return s;
  }

  void load(const std::string& state) {
    for (const Variable& one : variables_) {
      if (!one.is_loaded) continue;
      const auto& registers = *registers_of_.at(one.name);
      for (std::size_t i = 0; i < registers.size(); ++i) {
        stepped_.begin(registers[i], state[one.at + one.width - 1 - i]);
      }
    }
  }

  // After an x the netlist goes on from what the registers of the source are: an `if` that reads an
  // x takes one way there, and what comes of it may be known for good. What is known in both before
  // that has to be the same.
  void take_over(const std::vector<std::string>& words, std::size_t t) {
    stepped_.settle(rows_[t + 1]);
    for (std::size_t v = 0; v < variables_.size(); ++v) {
      const std::string& word = words[side_.outputs.size() + v];
      const std::string says = netlist_word(variables_[v]);
      for (std::size_t i = 0; i < word.size() && word.size() == says.size(); ++i) {
        if (is_known(word[i]) && is_known(says[i]) && word[i] != says[i] && wrong_.empty()) {
          say_wrong(variables_[v].name, word, says, false, t);
        }
      }
    }
    for (std::size_t v = 0; v < variables_.size(); ++v) {
      const std::string& word = words[side_.outputs.size() + v];
      const auto& registers = *registers_of_.at(variables_[v].name);
      for (std::size_t i = 0; i < registers.size(); ++i) {
        stepped_.begin(registers[i], word[word.size() - 1 - i]);
      }
    }
  }

  void say_wrong(const std::string& name, const std::string& source, const std::string& netlist,
                 bool is_output, std::size_t t) {
    wrong_ = fmt::format("{} {} is {} on clock {} in {}, and {} on the netlist that {} reads",
                         is_output ? "output" : "register", name, source, t, name_of(simulator_),
                         netlist, name_of(side_.front_end()));
  }

  // What the registers begin as, and what they were before they were given a value.
  void begin(const Simulated& ran) {
    std::vector<char> digits(side_.registers.size(), '-');
    for (const auto& [name, registers] : side_.variables) {
      const auto was = ran.before.find(name), is = ran.after.find(name);
      if (was == ran.before.end() || is == ran.after.end() ||
          was->second.size() != registers.size() || is->second.size() != registers.size()) {
        continue;
      }
      for (std::size_t i = 0; i < registers.size(); ++i) {
        const Register& reg = side_.registers[registers[i]];
        const char before = was->second[registers.size() - 1 - i];
        const char says = reg.any ? 'x' : reg.first ? '1' : '0';
        const bool is_zero_by_type = side_.has_zeros_by_type() && says == '0';
        if (is_known(before) ? before != says : says != 'x' && !is_zero_by_type) {
          if (wrong_.empty()) {
            wrong_ = fmt::format("{} begins as {}, and {} says {}", name, was->second,
                                 name_of(side_.front_end()),
                                 says == 'x' ? std::string("any value") : std::string(1, says));
          }
        }
        digits[registers[i]] = is->second[registers.size() - 1 - i];
      }
    }
    for (std::size_t i = 0; i < digits.size(); ++i) {
      const Register& reg = side_.registers[i];
      const char says = reg.any || may_be_x(side_, simulator_) ? 'x' : reg.first ? '1' : '0';
      stepped_.begin(i, digits[i] == '-' ? says : digits[i]);
    }
  }

  // Verilator has no x. What the netlist does not know on many clocks, and is the same in Verilator
  // whatever has no value there is, is a value that the front end has lost. Division by zero, which
  // is 0 in Verilator, is not.
  void find_values_lost(const Program& program, const Simulated& ran) {
    static const std::set<std::string> divisions{"$div", "$mod", "$divfloor", "$modfloor"};
    if (std::ranges::any_of(side_.module().cells,
                            [](const Cell& cell) { return divisions.contains(cell.type); })) {
      return;
    }
    constexpr std::size_t many = 8;
    const Simulated ones = program.run(how_.until, "1"), others = program.run(how_.until, "2");
    if (ones.clocks.size() != ran.clocks.size() || others.clocks.size() != ran.clocks.size())
      return;
    for (const auto& [bit, clocks] : vague_) {
      const std::size_t port = bit.first, i = bit.second;
      const auto is_known_at = [&](std::size_t t) {
        const char is = ran.clocks[t][port][i];
        return ones.clocks[t][port][i] == is && others.clocks[t][port][i] == is;
      };
      if (clocks.size() * many < ran.clocks.size() || !std::ranges::all_of(clocks, is_known_at)) {
        continue;
      }
      const auto name = std::next(side_.outputs.begin(), std::ptrdiff_t(port))->first;
      const std::string& source = ran.clocks[clocks.front()][port];
      std::string netlist = source;
      netlist[i] = 'x';
      return say_wrong(name, source, netlist, true, clocks.front());
    }
  }

  void compare(const std::vector<std::string>& words, std::size_t t) {
    std::size_t at = side_.outputs.size();
    std::set<std::string> x;
    was_x_ = sources_->has_hidden();
    for (const Variable& one : variables_) {
      if (words[at++].find_first_not_of("01") == std::string::npos) continue;
      was_x_ = true;
      // An x that comes from none, where the netlist has a value, is no excuse for another one.
      const bool is_one = netlist_word(one).find('x') == std::string::npos;
      if (!is_one || sources_->reach(one.name)) x.insert(one.name);
    }
    sources_->clock(std::move(x));
    at = 0;
    for (const auto& [port, width] : side_.outputs) {
      const std::string netlist = netlist_word(port, width);
      for (std::size_t i = 0; simulator_ == Simulator::verilator && i < netlist.size(); ++i) {
        if (!is_known(netlist[i])) vague_[{at, i}].push_back(t);
      }
      compare(port, words[at++], netlist, true, t);
    }
    for (const Variable& one : variables_) {
      compare(one.name, words[at++], netlist_word(one), false, t);
    }
  }

  std::string netlist_word(const std::string& port, int width) {
    std::string text;
    for (int i = width; i-- > 0;) text += Stepped::digit(stepped_.output({port, i}));
    return text;
  }
  std::string netlist_word(const Variable& one) {
    std::string text;
    for (const std::size_t reg : *registers_of_.at(one.name))
      text += Stepped::digit(stepped_.seen(reg));
    return {text.rbegin(), text.rend()};
  }

  void compare(const std::string& name, const std::string& source, const std::string& netlist,
               bool is_output, std::size_t t) {
    if (!wrong_.empty() || source.size() != netlist.size()) return;
    const bool four = simulator_ != Simulator::verilator;
    const bool sees_x = is_output && four && how_.x_matters;
    bool is_wrong = false, is_vague = false;
    for (std::size_t i = 0; i < source.size(); ++i) {
      const char is = source[i], says = netlist[i];
      if (is == says) continue;
      if (is_known(is) && is_known(says)) is_wrong = true;
      if (is_lenient_) continue;
      if (four && is_known(is) && !is_known(says)) is_vague = true;
      if (sees_x && !is_known(is) && is_known(says)) is_wrong = is_wrong || !sources_->reach(name);
    }
    // What casez takes for any value is known in the source and is not in the netlist.
    const bool is_matched = is_vague && (casex_ || (casez_ && sources_->z_reaches(name, t)));
    is_wrong = is_wrong || is_matched;
    if (!is_wrong && is_vague && !sources_->reach(name)) {
      // An `if` that reads an x takes one way in the source.
      is_wrong = !sources_->net_reaches(name, t);
      was_x_ = was_x_ || !is_wrong;
    }
    if (is_wrong) say_wrong(name, source, netlist, is_output, t);
  }

  const Side& side_;
  const Referee& how_;
  Simulator simulator_;
  bool is_cut_;
  Stepped stepped_;
  RefereeMemories memories_;
  std::vector<Inputs> rows_;
  std::vector<Variable> variables_;
  std::map<std::string, const std::vector<std::size_t>*> registers_of_;
  std::optional<XSources> sources_;
  /// In Verilator: the clocks on which the netlist does not know a digit of an output.
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> vague_;
  std::vector<std::string> loads_;
  std::size_t first_load_ = 0;
  bool is_lenient_ = false;  ///< the state is perhaps never reached
  bool casex_, casez_;       ///< the source has such a case
  bool was_x_ = false;       ///< what the source is on the clock before may rest on an x
  std::string wrong_;
};

// Whether a block waits for signals by a list of its own: Icarus Verilog alone does so.
bool has_lists(const std::vector<SourceText>& sources) {
  static const rtl::Regex list("@\\s*\\(([^)]*)\\)"), edge("\\b(posedge|negedge)\\b|^\\s*[*]\\s*$");
  for (const SourceText& source : sources) {
    const std::string plain = rtl::blanked(source.text);
    for (const rtl::Match& one : list.all(plain)) {
      const std::string events = one[1];
      if (!edge.find(events)) return true;
    }
  }
  return false;
}

}  // namespace

Refereed refereed(const Side& side, const Referee& how) {
  if (!side.files().vhdl.empty()) return refereed_vhdl(side, how);
  Refereed first;
  if (how.verilator && has_rows(sources_of(side.files()))) {
    first.wrong = "Icarus Verilog misreads an array of several dimensions";
  } else {
    first = Match(side, how, Simulator::icarus).judged();
    const bool may_be_wrong = !first.agrees && side.front_end() == FrontEnd::slang &&
                              may_be_cut_on_ports(sources_of(side.files())) &&
                              !has_lists(sources_of(side.files()));
    if ((!first.by.empty() && !may_be_wrong) || !how.verilator) return first;
  }
  Refereed second;
  try {
    second = Match(side, how, Simulator::verilator).judged();
  } catch (const OutOfTime&) {
    second.wrong = "Verilator needs more time to build it: give --seconds N";
  }
  if (second.by.empty()) second.wrong = first.wrong + "; " + second.wrong;
  return second;
}

}  // namespace cosim::equiv
