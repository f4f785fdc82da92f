// The bench of a design with a stream model. A case of it is a stimulus, so that sweeps, replays,
// shrinking, waves and the folder of a failure are what they are for lockstep.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tb/sim/bench.h"
#include "tb/stream/draw.h"
#include "tb/stream/dut.h"
#include "tb/stream/run.h"
#include "tb/stream/shape.h"

namespace cosim {

/// All of it that needs no type of the design.
class AnyStreamBench : public AnyBench {
 public:
  AnyStreamBench();
  ~AnyStreamBench() override;

  Run run_hostile(const HostileCase& c) const override;
  std::string drawn_text(std::uint64_t seed) const override;
  Stimulus program(const std::string& path, std::uint64_t seed, std::string& wrong) const override;
  void prepare_replays() const override { open_dut(1); }
  Run replay(const Stimulus& stimulus, Window window) const override;
  std::optional<std::uint64_t> first_difference(const Stimulus& stimulus) const override;
  std::vector<std::vector<std::vector<Word>>> without(const std::vector<std::vector<Word>>& rows,
                                                      std::size_t n) const override;
  void show(const Stimulus& stimulus, Window around, WaveSink& sink) const override;

  /// The first finding of a hostile case on RTL with the same ports, which can restart().
  std::optional<StreamFinding> finding_on(StreamDut& other, const HostileCase& c) const;

  const StreamShape& shape() const { return shape_; }
  /// A new instance of the RTL.
  virtual std::unique_ptr<StreamDut> dut(std::uint32_t power_up) const = 0;
  /// One that shows its whole hierarchy.
  virtual std::unique_ptr<StreamDut> open_dut(std::uint32_t power_up) const = 0;
  /// What must come out of each stream, in place of what `all` holds.
  virtual void expect(const std::vector<Sequence>& given, std::vector<Sequence>& all) const = 0;
  /// The transactions of a file into `given`, and what the program in it finds wrong.
  virtual std::string read_program(const std::string& /*path*/,
                                   std::vector<Sequence>& /*given*/) const {
    return {};
  }
  /// The sizes of that alone for the first so many transactions of each stream of `given`, which
  /// stays; called with ever more.
  virtual StreamSizes sizes(const std::vector<Sequence>& given) const = 0;
  /// The state of the model behind these transactions of each stream that goes in, in words of the
  /// design's own; empty where it has none.
  virtual std::string state_after(const std::vector<Sequence>& /*given*/) const { return {}; }
  /// Adds to `hits`, of each of the cases() of stream s, how often it happened in the first n
  /// transactions of `some`.
  virtual void count_cases(bool /*goes_in*/, std::size_t /*s*/, const Sequence& /*some*/,
                           std::size_t /*n*/, std::span<std::uint64_t> /*hits*/) const {}
  /// The first rule that a transaction of stream s breaks; null where it may go in.
  virtual const char* broken_rule(std::size_t s, std::span<const Word> words) const = 0;

 protected:
  /// What of the tables follows from shape_: to be called once that is there.
  void fill_tables();

  StreamShape shape_;

 private:
  struct Rig;
  class Borrowed;

  // Of the last that went in, of what was expected and what came, and the state: lines.
  std::vector<std::string> told(const StreamFinding& finding, const StreamOrder& order,
                                const Sequence& came, const std::vector<std::size_t>& taken) const;
  MayGo may_go() const;
  // The case as a stimulus, that Rig::draw() takes apart.
  Stimulus drawn(const HostileCase& c, std::uint64_t number) const;

  mutable std::mutex guard_;
  mutable std::vector<std::unique_ptr<Rig>> spare_;  // one for each thread that ran a case
};

}  // namespace cosim
