// A job declared by one table: what a design is given to do, as numbers with ranges. From the table
// come random jobs, smaller ones in place of a failing one, their description and the words that
// name one on a command line. A table is a macro of rows
//
//   FIELD(name, low, high, meaning)
//
// whose ends may use p, the design's parameters. COSIM_JOB(Job, TABLE, Params) defines
// `template <class V> struct Job`, a record of these numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include "model/core/fields.h"

namespace cosim {

struct JobField {
  const char* name;
  Word low, high;  ///< the ends of its range, both in it
  const char* meaning;
};

/// The number nearest to 0 in a field's range: the simplest.
constexpr Word simplest(const JobField& field) {
  return std::clamp<Word>(0, field.low, field.high);
}

/// The field of a record that holds any number of the range.
constexpr Field cell_of(const JobField& field) {
  const bool negative = field.low < 0;
  int width = 1;
  const auto holds = [&](Word v) {
    return v == (negative ? from_twos_complement(v, width) : low_bits(v, width));
  };
  while (width < 64 && !(holds(field.low) && holds(field.high))) ++width;
  const Format format = negative ? Format::twos_complement : Format::number;
  return {field.name, width, format, "", field.meaning};
}

namespace detail {

template <std::size_t N>
constexpr std::array<Field, N> cells_of(const std::array<JobField, N>& fields) {
  std::array<Field, N> cells{};
  for (std::size_t i = 0; i < N; ++i) cells[i] = cell_of(fields[i]);
  return cells;
}

/// Jobs nearer to the simplest in one field and the same in all others, the simplest first.
template <class Job, class Params>
std::vector<Job> smaller_of_table(const Params& p, const Job& job) {
  std::vector<Job> all;
  const auto fields = Job::job_fields(p);
  for_each_member<Job>([&](auto member, std::size_t i) {
    const Word least = simplest(fields[i]);
    const Word now = job.*member;
    for (const Word less : {least, least + (now - least) / 2, now < least ? now + 1 : now - 1}) {
      if (now == least || less == now) continue;
      all.push_back(job);
      all.back().*member = less;
    }
  });
  return all;
}

/// "idle=3 byte=65"
template <class Record, class Params>
std::string named_values(const Params& p, const Record& record) {
  std::string text;
  const auto fields = Record::fields(p);
  for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (fields[i].width == 0) return;
    text += (text.empty() ? "" : " ") + (label_of(fields[i]) + '=' + std::to_string(cell(record)));
  });
  return text;
}

}  // namespace detail

}  // namespace cosim

#define COSIM_JOB_MEMBER(name, low, high, meaning) V name{};
#define COSIM_JOB_INDEX(name, low, high, meaning) index_##name,
#define COSIM_JOB_VISIT(name, low, high, meaning) \
  visit(&Self::name, std::integral_constant<std::size_t, index_##name>());
#define COSIM_JOB_FIELD(name, low, high, meaning) ::cosim::JobField{#name, low, high, meaning},

/// Defines `template <class V> struct Job` with one member a row of TABLE, and its table as data.
/// Params is the type of p in the rows' ends.
#define COSIM_JOB(Job, TABLE, Params)                                           \
  template <class V>                                                            \
  struct Job {                                                                  \
    TABLE(COSIM_JOB_MEMBER)                                                     \
    enum Index : std::size_t { TABLE(COSIM_JOB_INDEX) index_end };              \
    static constexpr std::size_t size = index_end;                              \
    template <class Visit>                                                      \
    static constexpr void each_member(Visit& visit) {                           \
      using Self = Job;                                                         \
      TABLE(COSIM_JOB_VISIT)                                                    \
    }                                                                           \
    static constexpr std::array<::cosim::JobField, size> job_fields(            \
        [[maybe_unused]] const Params& p) {                                     \
      return {TABLE(COSIM_JOB_FIELD)};                                          \
    }                                                                           \
    static constexpr std::array<::cosim::Field, size> fields(const Params& p) { \
      return ::cosim::detail::cells_of(job_fields(p));                          \
    }                                                                           \
  };                                                                            \
  static_assert(true, "so that a semicolon stands behind it")
