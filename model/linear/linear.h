// Golden model of the linear interpolator, SU 1631518. Position q >= 1 of a line is a step of the
// major axis, and of the minor one where bit a_i of the code UK is 1, q = 2^(i-1) * odd; a_1 is the
// high bit.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <string_view>
#include <vector>

#include <cosim/model.h>

#include "model/linear/job.h"
#include "model/linear/oracle.h"
#include "model/linear/view.h"

/// M: bits of BP and UK, 2 to 32. N: low bits of UK that the serial multiplier takes, 1 to M - 1.
template <int M, int N>
struct Linear {
  static constexpr int gamma = M - N;           // 1 to 6
  static constexpr int positions = 1 << gamma;  // of a word
  using Positions = UInt<positions>;            // position 1 leftmost

  struct In {
    Source<"17", Bit> initial_set_n;  // active low: forget the line, keep the code
    Source<"26", Bit> reset;          // clear everything
    Source<"15", Bit> write_bp;       // take BP from data while idle
    Source<"16", Bit> write_uk;       // take UK from data while idle
    Source<"18", Bit> start;          // start, while idle and a code is written
    Source<"14", UInt<M>> data;       // BP or UK
  };
  struct Out {
    Source<"22", Bit> busy;              // a line is being drawn
    Source<"23", Bit> strobe;            // minor and major hold a pair of words
    Source<"24", Hex<Positions>> minor;  // steps of the minor axis
    Source<"25", Hex<Positions>> major;  // steps of the major axis
  };
  static constexpr const char* source = "SU 1631518";
  static constexpr auto reset = active_high<&In::reset>;
  static constexpr std::string_view register_suffix = "_q";
  static constexpr In rest() {
    return {.initial_set_n = 1, .reset = 0, .write_bp = 0, .write_uk = 0, .start = 0, .data = 0};
  }

  Source<"30", Bit> trigger30 = 0;         // a pair of words is formed and on the outputs
  Source<"31", Bit> trigger31 = 0;         // a line is being drawn
  Source<"32", Bit> trigger32 = 0;         // a code was written for the present BP
  Source<"4", UInt<N + 1>> counter4 = 0;   // words still to form
  Source<"5", UInt<gamma>> register5 = 0;  // BP modulo 2^gamma
  At<"multiplier6.ticks_q", Source<"6", UInt<N>>> multiplier6 = 0;  // words formed, modulo 2^N
  Source<"3", Hex<UInt<N>>> register3 = 0;                          // a_(gamma+1) .. a_M
  Source<"9", Hex<UInt<positions - 1>>> register9 = 0;  // minor steps of positions 1 .. 2^gamma - 1
  Source<"10", Bit> trigger10 = 0;                      // minor step of position 2^gamma

  Out clock(const In& in) {
    const Positions whole = -1, none = 0;
    const Bit is_part = counter4 == 0 && register5 != 0;
    const Positions live = mux(trigger30, mux(is_part, first(register5), whole), none);
    const Out out{.busy = trigger31,
                  .strobe = trigger30,
                  .minor = cat(register9, trigger10) & live,
                  .major = live};
    if (in.reset) {
      *this = Linear{};
    } else if (!in.initial_set_n || (trigger31 && counter4 == 0)) {
      forget();
    } else if (trigger31) {
      form();
    } else {
      prepare(in);
    }
    return out;
  }

  /// The word whose first k positions are 1, k < 2^gamma.
  static Positions first(const UInt<gamma>& k) { return ~(Positions(-1) >> k); }

  /// The word with a 1 at each position 2^(i-1) * odd, for i up to gamma.
  static constexpr std::array<std::uint64_t, gamma + 1> positions_of = [] {
    std::array<std::uint64_t, gamma + 1> words{};
    for (unsigned q = 1; q < positions; ++q) {
      words[std::size_t(std::countr_zero(q) + 1)] |= std::uint64_t{1} << (positions - q);
    }
    return words;
  }();

  /// The minor steps of positions 1 .. 2^gamma - 1 of every word.
  static UInt<positions - 1> within_word(const UInt<M>& code) {
    using Steps = UInt<positions - 1>;
    Steps steps = 0;
    for (int i = 1; i <= gamma; ++i) {
      steps = steps | mux(code[M - i], Steps(positions_of[std::size_t(i)] >> 1), Steps(0));
    }
    return steps;
  }

  /// The minor step of position k * 2^gamma; none where k is 0.
  Bit end_of_word(const UInt<N>& k) const {
    for (int i = 1; i <= N; ++i) {
      if (k[i - 1]) return register3[N - i];
    }
    return 0;
  }

  /// The line is over; the code stays.
  void forget() { *this = Linear{.register3 = register3, .register9 = register9}; }

  /// The next pair of words.
  void form() {
    trigger30 = 1;
    --counter4;
    ++multiplier6;
    merge(trigger10, [&] { trigger10 = end_of_word(multiplier6); });
  }

  /// A clock on which no line runs. BP wins over UK, a write over a start.
  void prepare(const In& in) {
    if (in.write_bp) {
      counter4 = in.data >> gamma;
      register5 = in.data;
      trigger32 = 0;
    } else if (in.write_uk) {
      counter4 = counter4 + (!trigger32 && register5 != 0);  // a word for the remainder, once
      register3 = in.data;
      register9 = within_word(in.data);
      trigger32 = 1;
    } else {
      trigger31 = in.start && trigger32;
    }
  }

  /// Positions of the line not yet put out.
  auto left() const {
    const Bit is_counted = trigger32 && register5 != 0;
    return cat(UInt<N + 1>(counter4 + trigger30 - is_counted), register5);
  }

  /// Each must be possible, and must happen under the stimuli.
  auto cases(const In& in) const {
    const Bit set = !in.reset && !in.initial_set_n, quiet = !in.reset && in.initial_set_n;
    const Bit running = trigger31, idle = quiet && !running, coded = trigger32;
    const Bit forming = running && !trigger30, is_last = trigger30 && counter4 == 0;
    const Bit between = trigger30 && counter4 != 0;
    const Bit bp = in.write_bp, uk = in.write_uk, start = in.start;
    const Bit begins = idle && start && coded && !bp && !uk;
    const auto bp_left = left();
    const Bit none_left = bp_left == 0, whole = register5 == 0;
    const Bit code0 = register3 == 0 && register9 == 0;
    const Bit code1 = reduce_and(register3) && reduce_and(register9);
    return stated({{"reset with no code", in.reset && !running && !coded},
                   {"reset with a code", in.reset && !running && coded},
                   {"reset before the first word", in.reset && forming},
                   {"reset between words", in.reset && between},
                   {"reset on the last word", in.reset && is_last},
                   {"initial set while idle", set && !running},
                   {"initial set before the first word", set && forming},
                   {"initial set between words", set && between},
                   {"initial set on the last word", set && is_last},
                   {"BP written", idle && bp && !uk},
                   {"UK written", idle && uk && !bp},
                   {"UK written twice", idle && uk && !bp && coded},
                   {"UK written with no new BP", idle && uk && !bp && !coded && none_left},
                   {"BP and UK written at once", idle && bp && uk},
                   {"start on the clock of a write", idle && start && uk && coded},
                   {"start with no code", idle && start && !coded && !bp && !uk},
                   {"start", begins},
                   {"start of BP = 0", begins && none_left},
                   {"start of BP = 1", begins && bp_left == 1},
                   {"start of BP = 2^m - 1", begins && bp_left == UInt<M>(-1)},
                   {"start of BP a multiple of 2^gamma", begins && whole && !none_left},
                   {"start of BP no multiple of 2^gamma", begins && !whole},
                   {"start with counter 4 at 2^n", begins && counter4 == UInt<N>(-1) + 1},
                   {"start of UK all zeros", begins && code0},
                   {"start of UK all ones", begins && code1},
                   {"BP written while running", quiet && running && bp},
                   {"UK written while running", quiet && running && uk},
                   {"start while running", quiet && running && start},
                   {"the first word", quiet && forming && !none_left},
                   {"a line of no words", quiet && forming && none_left},
                   {"a word that is not the last", quiet && between},
                   {"the last word", quiet && is_last}});
  }

  /// True of every state after a reset, and no matter to RTL and model: what a mutant may rest on.
  auto reached() const {
    return stated({{"a word is formed only while a line runs", trigger31 || !trigger30},
                   {"a line runs only with a code written", trigger32 || !trigger31},
                   {"a word that is formed has a position left", left() > 0 || !trigger30},
                   {"the positions left are of a BP of M bits", left() <= UInt<M>(-1)},
                   {"between lines no words are counted", trigger31 || multiplier6 == 0},
                   {"between lines the multiplier has no bit", trigger31 || !trigger10}});
  }

  // What it is given to do is a line, perhaps given up (job.h); a job is what driver and checker
  // see of it.
  using Work = cosim::linear::Job;
  static constexpr std::uint64_t most_clocks = std::uint64_t{1} << 40;  // no line waits for ever

  struct Job {
    UInt<M> bp;         // the line
    Hex<UInt<M>> uk;    // and its code
    Bit counted;        // give it up after so many words
    UInt<N + 1> words;  // which no line has more of
  };
  static Job job_of(const Work& work) {
    constexpr auto most = (std::int64_t{1} << (N + 1)) - 1;
    return {.bp = work.line.major,
            .uk = work.line.code,
            .counted = work.words.has_value(),
            .words = std::min(work.words.value_or(0), most)};
  }
  static std::vector<Work> smaller(const Work& work) { return cosim::linear::smaller(M, work); }
  static std::string describe(const Work& work) { return cosim::linear::describe(M, work); }

  /// It writes BP and UK, starts the line and waits for its end: three clocks, one until the first
  /// word, one a word and one to see the end.
  struct Driver {
    UInt<3> clock = 0;      // 0 to 3: it writes BP, UK, starts, waits; 4: the line runs
    UInt<N + 1> words = 0;  // words so far

    In drive(const Job& job, In in) const {
      in.initial_set_n = !(clock == 4 && job.counted && words >= job.words);
      in.write_bp = clock == 0;
      in.write_uk = clock == 1;
      in.start = clock == 2;
      in.data = mux(clock == 0, job.bp, mux(clock == 1, job.uk, 0));
      return in;
    }
    /// `busy` shows one clock after the start.
    Bit driven(const Job&, const Out& out) {
      const Bit is_started = clock > 2;
      words = mux(is_started, words + out.strobe, 0);
      clock = clock + (clock < 4);
      return is_started && !out.busy;
    }
  };

  /// On which positions each axis steps, from their numbers alone.
  struct Checker {
    UInt<N + 1> due = 0;    // words of the line
    UInt<N + 1> words = 0;  // so far

    /// Wrong are the words on the outputs, or the number of them.
    Bit checked(const Job& job, const Driver&, const Out& out, const Bit& over) {
      Bit wrong = 0;
      if (out.strobe) {
        const Positions whole = -1, none = 0;
        const UInt<N> all = job.bp >> gamma;
        const Positions major = mux(words < all, whole, mux(words == all, first(job.bp), none));
        ++words;
        Bit at_end = 0;  // the minor step of position words * 2^gamma
        merge(at_end, [&] {
          for (int i = 1; i <= N; ++i) {
            if (!words[i - 1]) continue;
            at_end = job.uk[N - i];
            return;
          }
        });
        Positions minor = at_end;
        for (int i = 1; i <= gamma; ++i) {
          minor = minor | mux(job.uk[M - i], Positions(positions_of[std::size_t(i)]), none);
        }
        wrong = out.major != major || out.minor != (minor & major);
      }
      return wrong || (over && !job.counted && words != due);
    }
  };
  static Checker checker_of(const Work& work) {
    return {.due = cosim::linear::ticks(gamma, work.line.major)};
  }

  /// Calls take(dx, dy) for each step of a clock, the first one first: x along the major axis,
  /// which makes every step.
  template <class Take>
  static void for_each_step(const Out& out, const Take& take) {
    for (int i = positions - 1; i >= 0; --i) {
      if (out.major[i]) take(1, int(out.minor[i]));
    }
  }
  using View = cosim::linear::View;
};
