// Jobs as nets: the device outside that drives them (model/core/drive.h), and the oracle that
// judges them (model/core/walk.h). A design's Jobs has
//
//   using Design
//   Walk<V>
//   std::size_t figures               the first field of Walked that is read of a job's end
#pragma once

#include <cstddef>
#include <vector>

#include "model/core/fields.h"
#include "tb/nets/draw.h"
#include "tb/nets/number.h"

namespace cosim::nets {

/// Which bits of what is held are what: the first says that the job was over on the last clock.
/// Behind it stands what a job begins with, in the order of its tables.
struct JobLayout {
  std::vector<int> begins;           ///< widths of the fields of task, of what is due, of how far
  std::size_t figures = 0;           ///< the first bit of the figures
  std::vector<int> figure_widths{};  ///< of their fields
};

template <class Jobs>
JobLayout job_layout_of(const typename Jobs::Design::Params& p) {
  JobLayout all;
  std::size_t at = 1;
  const auto add = [&](const auto& fields) {
    for (const Field& field : fields) {
      all.begins.push_back(field.width);
      at += static_cast<std::size_t>(field.width);
    }
  };
  using Walk = typename Jobs::template Walk<Word>;
  add(decltype(Walk::task)::fields(p));
  add(decltype(Walk::due)::fields(p));
  const auto walked = decltype(Walk::walked)::fields(p);
  all.figures = at;
  for (std::size_t i = 0; i < walked.size(); ++i) {
    if (i + 1 > Jobs::figures) {
      all.figure_widths.push_back(walked[i].width);
    } else {
      all.figures += static_cast<std::size_t>(walked[i].width);
    }
  }
  add(walked);
  return all;
}

namespace detail {

// Free bits as the numbers that they stand for, or of outputs as the codes that they are.
template <class Record, class Params>
void free_code(const Params& p, Graph& graph, Record& r, std::vector<Bit>& bits,
               bool are_codes = false) {
  const auto fields = Record::fields(p);
  for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (fields[i].width == 0) return;
    std::vector<Bit> code;
    for (int b = 0; b < fields[i].width; ++b) code.push_back(graph.input());
    bits.insert(bits.end(), code.begin(), code.end());
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

template <class Jobs>
auto free_job(const typename Jobs::Design::Params& p, Graph& graph, std::vector<Bit>& held) {
  typename Jobs::template Walk<Number> job;
  held.push_back(graph.input());
  free_code(p, graph, job.task, held);
  free_code(p, graph, job.due, held);
  free_code(p, graph, job.walked, held);
  free_code(p, graph, job.driven, held);
  return job;
}

}  // namespace detail

template <class Jobs>
Draw draw_of_jobs(const typename Jobs::Design::Params& p) {
  using Design = typename Jobs::Design;
  Draw draw;
  DrawStep& clock = draw.clock;
  const auto before = detail::free_job<Jobs>(p, clock.graph, clock.held);
  clock.after = clock.held;
  detail::add_code(p, pins(p, before.task, before.driven), clock.inputs);

  Answer& answer = draw.answer.emplace();
  auto job = detail::free_job<Jobs>(p, answer.graph, answer.held);
  typename Design::template Outputs<Number> seen;
  detail::free_code(p, answer.graph, seen, answer.seen, true);
  const auto turn = turned(p, job.driven, seen);
  const auto verdict = walked(p, job, seen, turn.over);
  answer.after.push_back(fact_of(turn.over));
  detail::add_code(p, job.task, answer.after);
  detail::add_code(p, job.due, answer.after);
  detail::add_code(p, verdict.walked, answer.after);
  detail::add_code(p, turn.driven, answer.after);
  answer.wrong = fact_of(verdict.wrong);
  return draw;
}

}  // namespace cosim::nets
