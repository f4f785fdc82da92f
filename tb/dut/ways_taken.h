// How often each way through an exported model is taken: 64 clocks at a time are run through the
// conditions in its file.
#pragma once

#include <fmt/core.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "model/core/fields.h"
#include "model/core/input_error.h"
#include "tb/dut/counts.h"
#include "tb/nets/exported.h"
#include "tb/nets/machine.h"
#include "tb/nets/runs.h"

namespace cosim::coverage {

/// The counts of a design of one shape, written when the process ends.
template <class Design>
class WaysTaken {
  using Params = typename Design::Params;
  using Inputs = typename Design::template Inputs<Word>;
  using State = typename Design::template State<Word>;

 public:
  static void clock(const Params& p, const State& s, const Inputs& in) {
    static WaysTaken all(p);
    if (all.ways_.empty()) return;
    thread_local Clocks some(all);
    some.add(p, s, in);
  }
  ~WaysTaken() {
    std::vector<Count> counts;
    for (std::size_t i = 0; i < ways_.size(); ++i) counts.push_back({ways_[i].name, hits_[i]});
    if (!counts.empty()) leave("ways", Design::name, counts);
  }

 private:
  explicit WaysTaken(const Params& p) {
    typename Design::template State<nets::Number> s;
    typename Design::template Inputs<nets::Number> in;
    make_free(p, s, false);
    make_free(p, in, true);
    try {
      ways_ = nets::ways_of<Design>(p, s, in);
    } catch (const InputError& error) {
      fmt::print("{}: the ways through its model are not counted: {}\n", Design::name,
                 error.what());
    }
    hits_.resize(ways_.size());
  }

  // A record of numbers whose bits are free, or of codes.
  template <class Record>
  void make_free(const Params& p, Record& r, bool are_codes) {
    const auto fields = Record::fields(p);
    for_each_cell<Record>([&](auto cell, std::size_t i) {
      nets::Bits code;
      for (int b = 0; b < fields[i].width; ++b) code.push_back(graph_.input());
      if (code.empty()) return;
      const bool has_sign = is_signed(fields[i]) && !are_codes;
      cell(r) = has_sign ? nets::Number::signed_code(graph_, code)
                         : nets::Number::unsigned_code(graph_, code);
    });
  }

  // Those of one thread.
  class Clocks {
   public:
    explicit Clocks(WaysTaken& all) : all_(all), given_(all.graph_.inputs().size()) {}
    ~Clocks() { count(); }
    void add(const Params& p, const State& s, const Inputs& in) {
      std::size_t at = 0;
      add_code(p, s, at);
      add_code(p, in, at);
      if (++lane_ == 64) count();
    }

   private:
    template <class Record>
    void add_code(const Params& p, const Record& r, std::size_t& at) {
      const auto fields = Record::fields(p);
      const auto words = to_words(r);
      for (std::size_t i = 0; i < fields.size(); ++i) {
        for (int b = 0; b < fields[i].width; ++b) {
          given_[at++] |= (static_cast<std::uint64_t>(words[i]) >> b & 1) << lane_;
        }
      }
    }
    void count() {
      const auto gates = nets::run(all_.graph_, given_);
      const std::uint64_t used = lane_ == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << lane_) - 1;
      const std::lock_guard lock(all_.mutex_);
      for (std::size_t i = 0; i < all_.ways_.size(); ++i) {
        all_.hits_[i] += static_cast<std::uint64_t>(
            std::popcount(nets::in_runs(gates, all_.ways_[i].condition) & used));
      }
      given_.assign(given_.size(), 0);
      lane_ = 0;
    }

    WaysTaken& all_;
    std::vector<std::uint64_t> given_;
    std::size_t lane_ = 0;
  };

  nets::Graph graph_;
  std::vector<nets::Named> ways_;
  std::mutex mutex_;
  std::vector<std::uint64_t> hits_;
};

}  // namespace cosim::coverage
