// What an exporter wrote of a golden model, its driver and its checker against these themselves, on
// random clocks. They differ where one depends on what is no member of it, or where a block of
// merge() changes what it does not name.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/core/input_error.h"
#include "model/core/synchronizer.h"
#include "tb/nets/jobs.h"
#include "tb/nets/model.h"
#include "tb/nets/runs.h"
#include "tb/util/random.h"

namespace cosim::nets {

/// A graph beside what it was made of: 100,000 clocks, 64 at a time.
template <class Params>
class Beside {
 public:
  /// What the graph gives of a field, or under a name.
  struct Result {
    std::string name;
    Bits code;
  };
  /// `title` stands in front of an error.
  Beside(const Params& p, const Graph& graph, std::string title)
      : p_(p), graph_(graph), title_(std::move(title)) {}

  /// clock() draws records for the free bits of the graph, in their order, and adds what is
  /// expected, in the order of `results`. InputError where the graph gives another.
  template <class Clock>
  void compare(const std::vector<Result>& results, const Clock& clock) {
    for (std::size_t round = 0; round < 100'000 / lanes; ++round) {
      given_.assign(graph_.inputs().size(), 0);
      for (lane_ = 0; lane_ < lanes; ++lane_) {
        next_ = 0;
        expected_[lane_].clear();
        clock();
      }
      const auto gates = run(graph_, given_);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        for (std::size_t i = 0; i < results.size(); ++i) {
          std::uint64_t code = 0;
          for (std::size_t b = 0; b < results[i].code.size(); ++b) {
            code |= (in_runs(gates, results[i].code[b]) >> lane & 1) << b;
          }
          const auto wanted = static_cast<std::uint64_t>(expected_[lane].at(i));
          if (code != wanted) differ(results[i].name, wanted, code);
        }
      }
    }
  }
  /// A record: numbers, or codes. `turned`: bits of its code that the graph has inverted.
  template <class Record>
  Record draw(bool are_codes, const std::vector<bool>& turned = {}) {
    const auto fields = Record::fields(p_);
    Words<Record> words{};
    const bool some_turned = !turned.empty();
    std::size_t at = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].width == 0) continue;
      const Word code = random_code(fields[i]);
      words[i] =
          is_signed(fields[i]) && !are_codes ? from_twos_complement(code, fields[i].width) : code;
      for (int b = 0; b < fields[i].width; ++b, ++at) {
        const bool is = cosim::bit(code, b) != (some_turned && turned[at]);
        given_[next_++] |= std::uint64_t{is} << lane_;
      }
    }
    return from_words<Record>(words);
  }
  /// One free bit.
  void draw_bit() { given_[next_++] |= (random_.next() & 1) << lane_; }
  template <class Record>
  void expect(const Record& r) {
    const auto fields = Record::fields(p_);
    const auto words = to_words(r);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].width != 0) expect_word(cosim::low_bits(words[i], fields[i].width));
    }
  }
  void expect_word(Word word) { expected_[lane_].push_back(word); }

  /// The fields of a record, whose codes are `bits` from `at` on.
  template <class Record>
  void add(std::vector<Result>& results, const Bits& bits, std::size_t& at,
           const std::vector<bool>& turned = {}) const {
    std::size_t k = 0;
    for (const Field& f : Record::fields(p_)) {
      if (f.width == 0) continue;
      Result& one = results.emplace_back(Result{label_of(f), {}});
      for (int b = 0; b < f.width; ++b, ++k) {
        one.code.push_back(bits[at++] ^ (!turned.empty() && turned[k]));
      }
    }
  }

 private:
  static constexpr std::size_t lanes = 64;

  // In two's complement.
  Word random_code(const Field& field) {
    const Word code = random_.one_in_power(1)
                          ? random_.corner(field.width)
                          : cosim::low_bits(static_cast<Word>(random_.next()), field.width);
    // The ones' complement has one number less.
    const bool is_none =
        field.format == Format::ones_complement && code == cosim::shift_left(1, field.width - 1);
    return is_none ? 0 : code;
  }
  [[noreturn]] void differ(const std::string& name, std::uint64_t wanted,
                           std::uint64_t code) const {
    throw InputError(title_ + ": " + name + " is " + std::to_string(wanted) +
                     " in the model, and " + std::to_string(code) +
                     " in its exported form: clock() may depend on its members and on "
                     "In alone, and merge() names all that its block changes");
  }

  Params p_;
  const Graph& graph_;
  std::string title_;
  Random random_{1};
  std::vector<std::uint64_t> given_;
  std::size_t lane_ = 0, next_ = 0;
  std::array<std::vector<Word>, lanes> expected_;
};

/// InputError, which begins with `title`, where the nets of a design differ from its model.
template <class Design>
void require_same(const Model& model, const typename Design::Params& p, const std::string& title) {
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using State = typename Design::template State<Word>;
  Beside<typename Design::Params> beside(p, model.graph, title);
  std::vector<typename decltype(beside)::Result> results;
  for (const auto* wires : {&model.machine.next, &model.machine.outputs}) {
    for (const Wire& w : *wires) results.push_back({label_of(w.field), w.code});
  }
  const State none{};
  const Inputs no_inputs{};
  // What the model says stands first, but for the invariant that its fields are in range.
  const auto add = [&](const std::vector<Named>& stated, std::size_t first, std::size_t many) {
    for (std::size_t i = first; i < first + many; ++i) {
      results.push_back({stated[i].name, {stated[i].condition}});
    }
  };
  add(model.machine.cases, 0, cases_of<Word>(p, none, no_inputs).size());
  add(model.machine.legal, 0, legal_of<Word>(p, none, no_inputs).size());
  add(model.machine.invariant, 1, invariant_of<Word>(p, none).size());
  const Synchronizers<Design> taking(p);
  beside.compare(results, [&] {
    const auto in = beside.template draw<Inputs>(true);
    const auto s = beside.template draw<State>(false);
    const auto step = clock_of<Design, Word>(p, s, in);
    beside.expect(taking.taken(p, s, in, step.state));
    beside.expect(Outputs(step.outputs));
    const auto say = [&](const auto& stated) {
      for (const auto& one : stated) beside.expect_word(one.holds ? 1 : 0);
    };
    say(cases_of<Word>(p, s, in));
    say(legal_of<Word>(p, s, in));
    say(invariant_of<Word>(p, s));
  });
}

/// The same of what drives and checks its jobs.
template <class Design>
void require_same_jobs(const Draw& draw, const typename Design::Params& p,
                       const std::string& title) {
  using Task = TaskOf<Design, Word>;
  using Checker = CheckerOf<Design, Word>;
  using Driver = DriverOf<Design, Word>;
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  const auto turned = detail::driver_bits<Design>(p);
  std::size_t at = 0;

  Beside<typename Design::Params> driving(p, draw.clock.graph, title + ": driver");
  std::vector<typename decltype(driving)::Result> results;
  driving.template add<Inputs>(results, draw.clock.inputs, at);
  driving.compare(results, [&] {
    driving.draw_bit();
    const Task task = driving.template draw<Task>(false);
    driving.template draw<Checker>(false);
    const Driver driver = driving.template draw<Driver>(false, turned);
    driving.expect(drive(p, task, driver, rest_of<Design>()));
  });

  const Answer& answer = *draw.answer;
  Beside<typename Design::Params> answering(p, answer.graph, title + ": driver and checker");
  results.assign({{"over", {answer.after[0]}}, {"wrong", {answer.wrong}}});
  at = 1;
  answering.template add<Task>(results, answer.after, at);
  answering.template add<Checker>(results, answer.after, at);
  answering.template add<Driver>(results, answer.after, at, turned);
  answering.compare(results, [&] {
    answering.draw_bit();
    const Task task = answering.template draw<Task>(false);
    Checker checker = answering.template draw<Checker>(false);
    const Driver driver = answering.template draw<Driver>(false, turned);
    const Outputs seen = answering.template draw<Outputs>(true);
    const auto turn = driven(p, task, driver, seen);
    answering.expect_word(turn.over ? 1 : 0);
    bool is_wrong = false;
    if constexpr (has_check<Design>) {
      const auto verdict = checked(p, task, driver, checker, seen, turn.over);
      checker = verdict.checker;
      is_wrong = verdict.wrong;
    }
    answering.expect_word(is_wrong ? 1 : 0);
    answering.expect(task);
    answering.expect(checker);
    answering.expect(turn.over ? driver_for<Design, Word>(p) : turn.driver);
  });
}

}  // namespace cosim::nets
