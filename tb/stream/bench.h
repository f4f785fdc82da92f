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

#include "tb/bench/bench.h"
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

  std::string design() const override { return shape_.design; }
  std::string source() const override { return ""; }
  std::vector<Parameter> parameters() const override { return shape_.parameters; }
  std::vector<Field> compared() const override;
  std::size_t registers() const override { return 0; }
  std::string compared_text() const override;
  std::vector<Field> inputs() const override { return shape_.columns(); }
  const char* row() const override { return "transaction"; }
  std::vector<std::string> assumed() const override { return assumed_; }
  std::vector<Probe> probes() const override { return {}; }
  std::vector<Word> rest() const override;
  std::vector<Field> state() const override { return {}; }
  std::vector<Word> reset_state() const override { return {}; }
  std::string view() const override { return view_; }
  std::string hostile_text() const override { return "random transactions with random stalls"; }
  std::string text_of(const HostileCase& c) const override;
  Run run_hostile(const HostileCase& c) const override;
  Run replay(const Stimulus& stimulus, Window window) const override;
  std::optional<std::uint64_t> first_difference(const Stimulus& stimulus) const override;
  std::vector<std::vector<std::vector<Word>>> without(const std::vector<std::vector<Word>>& rows,
                                                      std::size_t n) const override;
  void show(const Stimulus& stimulus, Window around, WaveSink& sink) const override;

  const StreamShape& shape() const { return shape_; }
  /// A new instance of the RTL.
  virtual std::unique_ptr<StreamDut> dut(std::uint32_t power_up) const = 0;
  /// One that shows its whole hierarchy.
  virtual std::unique_ptr<StreamDut> open_dut(std::uint32_t power_up) const = 0;
  /// What must come out of each stream, in place of what `all` holds. InputError where the model
  /// gives what no port can hold.
  virtual void expect(const std::vector<Sequence>& given, std::vector<Sequence>& all) const = 0;
  /// The sizes of that alone for the first so many transactions of each stream of `given`, which
  /// stays; called with ever more.
  virtual StreamSizes sizes(const std::vector<Sequence>& given) const = 0;
  /// The first rule that a transaction of stream s breaks; null where it may go in.
  virtual const char* broken_rule(std::size_t s, std::span<const Word> words) const = 0;

 protected:
  StreamShape shape_;
  std::vector<std::string> assumed_;
  std::string view_;

 private:
  struct Rig;
  class Borrowed;

  MayGo may_go() const;
  // The case as a stimulus, that Rig::draw() takes apart.
  Stimulus drawn(const HostileCase& c, std::uint64_t number) const;

  mutable std::mutex guard_;
  mutable std::vector<std::unique_ptr<Rig>> spare_;  // one for each thread that ran a case
};

}  // namespace cosim
