// A job that is a list of numbers with ranges: smaller ones in place of a failing one, and its
// description.
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

namespace detail {

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
