// Jobs as nets: what drives them and what checks them (model/core/job.h).
#pragma once

#include <vector>

#include "model/core/design.h"
#include "tb/nets/draw.h"
#include "tb/nets/number.h"

namespace cosim::nets {

/// Whether the driver of the design's jobs, and its check, run on nets.
template <class Design>
concept DrivesOnNets = HasJobs<Design> &&
    requires(const typename Design::Params& p, const TaskOf<Design, Number>& task,
             const DriverOf<Design, Number>& driver,
             const typename Design::template Inputs<Number>& rest,
             const typename Design::template Outputs<Number>& out) {
  drive(p, task, driver, rest);
  driven(p, task, driver, out);
} &&(!has_check<Design> ||
     requires(const typename Design::Params& p, const TaskOf<Design, Number>& task,
              const DriverOf<Design, Number>& driver, const CheckerOf<Design, Number>& checker,
              const typename Design::template Outputs<Number>& out) {
       checked(p, task, driver, checker, out, Truth(true));
     });

namespace detail {

// Free bits as the numbers that they stand for, or of outputs as the codes that they are. `turned`:
// those that stand for their inverse.
template <class Record, class Params>
void free_code(const Params& p, Graph& graph, Record& r, std::vector<Bit>& bits,
               bool are_codes = false, const std::vector<bool>& turned = {}) {
  const auto fields = Record::fields(p);
  std::size_t at = 0;
  for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (fields[i].width == 0) return;
    std::vector<Bit> code;
    for (int b = 0; b < fields[i].width; ++b, ++at) {
      bits.push_back(graph.input());
      code.push_back(bits.back() ^ (!turned.empty() && turned[at]));
    }
    cell(r) = is_signed(fields[i]) && !are_codes ? Number::signed_code(graph, code)
                                                 : Number::unsigned_code(graph, code);
  });
}

template <class Record, class Params>
void add_code(const Params& p, const Record& r, std::vector<Bit>& bits) {
  const auto fields = Record::fields(p);
  for_each_cell<Record>([&](auto cell, std::size_t i) {
    for (const Bit bit : cell(r).code(fields[i].width)) bits.push_back(bit);
  });
}

// The bits of a driver as a job begins: they are held inverted, so that it begins as all 0.
template <class Design>
std::vector<bool> driver_bits(const typename Design::Params& p) {
  std::vector<Bit> bits;
  add_code(p, driver_for<Design, Number>(p), bits);
  std::vector<bool> all;
  for (const Bit bit : bits) all.push_back(bit == yes);
  return all;
}

// What is held of a job: whether it was over on the last clock, what it begins with, as JobLayout
// (tb/sim/lane_jobs.h) has it, and the driver.
template <class Design>
struct HeldJob {
  TaskOf<Design, Number> task;
  CheckerOf<Design, Number> checker;
  DriverOf<Design, Number> driver;
  std::size_t first_of_driver;
  std::vector<bool> turned;

  HeldJob(const typename Design::Params& p, Graph& graph, std::vector<Bit>& held)
      : turned(driver_bits<Design>(p)) {
    held.push_back(graph.input());
    free_code(p, graph, task, held);
    free_code(p, graph, checker, held);
    first_of_driver = held.size();
    free_code(p, graph, driver, held, false, turned);
  }
  std::vector<Bit> after(const typename Design::Params& p, const Truth& over) const {
    std::vector<Bit> bits{fact_of(over)};
    add_code(p, task, bits);
    add_code(p, checker, bits);
    add_code(p, driver, bits);
    for (std::size_t i = 0; i < turned.size(); ++i) {
      Bit& bit = bits[first_of_driver + i];
      bit = bit ^ turned[i];
    }
    return bits;
  }
};

}  // namespace detail

template <DrivesOnNets Design>
Draw draw_of_jobs(const typename Design::Params& p) {
  Draw draw;
  DrawStep& clock = draw.clock;
  const detail::HeldJob<Design> before(p, clock.graph, clock.held);
  clock.after = clock.held;
  const auto inputs = drive(p, before.task, before.driver, rest_on<Design, Number>());
  detail::add_code(p, inputs, clock.inputs);

  Answer& answer = draw.answer.emplace();
  detail::HeldJob<Design> job(p, answer.graph, answer.held);
  typename Design::template Outputs<Number> seen;
  detail::free_code(p, answer.graph, seen, answer.seen, true);
  const auto turn = driven(p, job.task, job.driver, seen);
  if constexpr (has_check<Design>) {
    const auto verdict = checked(p, job.task, job.driver, job.checker, seen, turn.over);
    job.checker = verdict.checker;
    answer.wrong = fact_of(verdict.wrong);
  }
  job.driver = select_record(turn.over, driver_for<Design, Number>(p), turn.driver);
  answer.after = job.after(p, turn.over);
  answer.driver = job.first_of_driver;
  detail::add_code(p, rest_on<Design, Number>(), answer.rest);
  return draw;
}

}  // namespace cosim::nets
