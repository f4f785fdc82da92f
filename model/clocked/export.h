// Writes a golden model as a file of BTOR2, which model checkers of words read: btormc, Pono, AVR.
//
//   #define COSIM_SYMBOLIC  // or by the compiler's -D; with -g1, for the lines in errors
//   #include "uart.h"
//   #include "model/clocked/export.h"
//   int main() { std::cout << cosim::clocked::exported<Uart<4>>("uart").text; }
//
// or, for the files of a model, its driver and its checker, write_exported<Uart<4>>(path, "uart").
//
// The file, one line each, in this order; NAME is that of the member, "store[3]" of an element,
// "head.tag" within a struct, or the path of an At:
//
//   ; model NAME                      what is exported, and with how many ways
//   N sort bitvec W                   where a width is used first
//   N input SORT NAME                 each member of In, in their order
//   N state SORT NAME                 each register, in their order
//   N OP SORT ...                     nodes: the operations of BTOR2; constants are consth
//   N init SORT STATE CONSTANT        a register's reset value, its default initializer; an
//                                     Unreset has none
//   N next SORT STATE NODE            its value after the clock
//   N output NODE NAME                each member of Out, in their order: its value before the edge
//   N output NODE SECTION:I           what the model says beside its clock (says.h), sentence I of
//                                     cases, legal, invariant, reached, registers or outputs: the
//                                     last two of compared()
//   N output NODE SECTION:NAME        of idle, a member of In; of reset, a register after
//                                     reset_at_once()
//
// A driver is such a file, too: its states are its members, its inputs job:NAME and out:NAME, and
// its outputs drive:NAME, the inputs that it drives, and over. Those of a checker are job:NAME,
// driver:NAME, out:NAME and over; its output is wrong.
//
// The ways through clock() are another file, PATH.ways.btor2, of the same inputs and states, which
// keep their values. Its outputs are ways:I, each whether a clock takes a way; one of them is true
// on every clock. Where there are more than 256 ways they are what each condition may be, and so
// are those of conditions in blocks of merge() always. Each has a comment, a tabulator between two
// words:
//
//   ; ways:I KIND FILE LINE WHAT      as WayPoint has them (way_points.h)
//
// All bits are codes as RTL has them: two's complement, or ones' complement of a OnesComplement.
// Assignments to members of In that are OnesComplement may have either code of 0.
//
// An InputError is thrown where clock() has more ways than ways.most_ways, takes longer than
// ways.most_seconds, or is not the same when it is run again.
#pragma once

#ifndef COSIM_SYMBOLIC
#error "export.h belongs to the exporter: compile it with -DCOSIM_SYMBOLIC"
#endif

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "model/clocked/btor2.h"
#include "model/clocked/model.h"
#include "model/clocked/way_points.h"

namespace cosim::clocked {

struct Exported {
  std::string text;        ///< the file
  std::uint64_t ways = 0;  ///< through clock(), and through blocks of merge()
  std::size_t nodes = 0;   ///< in the file, inputs and states among them
};

/// Makes a file of a struct's registers and what becomes of them.
class Exporting {
 public:
  /// `what`: "model uart", in the first line; `name` is for errors.
  Exporting(std::string what, const std::string& name) : what_(std::move(what)) {
    ways.begin(name);
    graph = Graph();
  }
  /// A record of inputs, whose names begin with `section`.
  template <class T>
  T inputs(const std::string& section = "") {
    T all = zero<T>();
    for_each_cell(all,
                  [&](const Label& l, auto& cell) { declare("input", section + l.name, cell); });
    return all;
  }
  /// The members of an object, which has its initial values, as states.
  template <class T>
  T states() {
    T all{};
    for_each_cell(all, [&](const Label& label, auto& cell) {
      const Id init = Inside::node(code_of(cell));
      const Id state = declare("state", label.name, cell);
      states_.push_back({state, label.is_unreset ? std::nullopt : std::optional(init)});
      next_.push_back(state);
    });
    return all;
  }
  /// run(object): what the object is after that is its next state. It gives what file() writes as
  /// outputs, a record.
  template <class T, class Run>
  void clock(const T& object, const char* section, const Run& run) {
    std::vector<std::string> names;
    const std::vector<Id> nodes = ways.join_twice([&] {
      std::vector<Id> all;
      T after = object;
      const auto out = run(after);
      names.clear();
      for_each_cell(after, [&](const Label&, const auto& cell) { add(all, cell); });
      for_each_cell(out, [&](const Label& label, const auto& cell) {
        add(all, cell);
        names.push_back(section + label.name);
      });
      return all;
    });
    next_.assign(nodes.begin(), nodes.begin() + std::ptrdiff_t(states_.size()));
    for (std::size_t i = 0; i < names.size(); ++i) output(names[i], nodes[states_.size() + i]);
  }
  /// Outputs that run() gives: a record, sentences, or a condition.
  template <class Run>
  void say(const std::string& section, const Run& run) {
    std::vector<std::string> names;
    const std::vector<Id> nodes = ways.join([&] {
      std::vector<Id> all;
      const auto said = run();
      names.clear();
      if constexpr (Operand<decltype(said)>) {
        add(all, Bit(said));
        names.push_back(section + ":0");
      } else if constexpr (requires { said[0].sentence; }) {
        for (const Stated& one : said) {
          add(all, one.holds);
          names.push_back(section + ':' + std::to_string(all.size() - 1));
        }
      } else {
        for_each_cell(said, [&](const Label& label, const auto& cell) {
          add(all, cell);
          names.push_back(section + ':' + label.name);
        });
      }
      return all;
    });
    for (std::size_t i = 0; i < names.size(); ++i) output(names[i], nodes[i]);
  }
  /// The ways through run() as outputs.
  template <class Run>
  void say_ways(const Run& run) {
    ways.keep();
    ways.join([&] {
      run();
      return std::vector<Id>();
    });
    for (const WayPoint& point : WayPoints().all()) {
      const std::string name = "ways:" + std::to_string(outputs_.size());
      file_.comment(name + '\t' + point.kind + '\t' + point.at.path + '\t' +
                    std::to_string(point.at.line) + '\t' + point.what);
      output(name, point.holds);
    }
  }
  Exported file() {
    for (const Register& one : states_) {
      if (one.init) file_.assign("init", one.state, *one.init);
    }
    for (std::size_t i = 0; i < states_.size(); ++i) {
      file_.assign("next", states_[i].state, next_[i]);
    }
    for (const auto& [name, node] : outputs_) file_.output(node, name);
    const std::string first =
        "; " + what_ + ", " + std::to_string(ways.count()) + " ways through it\n";
    return {first + file_.text(), ways.count(), file_.nodes()};
  }

 private:
  struct Register {
    Id state;
    std::optional<Id> init;
  };
  template <class Cell>
  Id declare(const char* kind, const std::string& name, Cell& cell) {
    const Id node = graph.input(Cell::width);
    file_.declare(kind, node, name);
    set_code(cell, Inside::of<UInt<Cell::width>>(node));
    return node;
  }
  template <class Cell>
  static void add(std::vector<Id>& all, const Cell& cell) {
    all.push_back(Inside::node(code_of(cell)));
  }
  void output(const std::string& name, Id node) { outputs_.emplace_back(name, node); }

  std::string what_;
  Btor2 file_;
  std::vector<Register> states_;
  std::vector<Id> next_;
  std::vector<std::pair<std::string, Id>> outputs_;
};

/// The model as a file, `name` in its first line and in errors.
template <class Model>
Exported exported(const std::string& name) {
  check_clock<Model>();
  Exporting file("model " + name, name);
  const auto in = file.inputs<typename Model::In>();
  const auto model = file.states<Model>();
  using Out = typename Model::Out;
  if constexpr (HasClock<Model>) file.clock(model, "", [&](Model& m) { return m.clock(in); });
  if constexpr (requires { model.cases(in); }) file.say("cases", [&] { return model.cases(in); });
  if constexpr (requires { model.legal(in); }) file.say("legal", [&] { return model.legal(in); });
  if constexpr (requires { model.invariant(); }) {
    file.say("invariant", [&] { return model.invariant(); });
  }
  if constexpr (requires { model.reached(); }) file.say("reached", [&] { return model.reached(); });
  if constexpr (requires { model.compared(); }) {
    file.say("registers", [&] { return model.compared(); });
  }
  if constexpr (requires(const Out& out) { model.compared(in, out); }) {
    file.say("outputs", [&] {
      Model m = model;
      const Out out = m.clock(in);
      return model.compared(in, out);
    });
  }
  if constexpr (requires { model.idle(); }) file.say("idle", [&] { return model.idle(); });
  if constexpr (requires(Model m) { m.reset_at_once(in); }) {
    file.say("reset", [&] {
      Model m = model;
      m.reset_at_once(in);
      return m;
    });
  }
  return file.file();
}

/// The ways through its clock.
template <class Model>
Exported exported_ways(const std::string& name) {
  Exporting file("ways of " + name, name);
  const auto in = file.inputs<typename Model::In>();
  const auto model = file.states<Model>();
  file.say_ways([&] {
    Model m = model;
    m.clock(in);
  });
  return file.file();
}

/// The driver of its jobs.
template <class Model>
Exported exported_driver(const std::string& name) {
  using Driver = typename Model::Driver;
  Exporting file("driver of " + name, name);
  const auto job = file.inputs<typename Model::Job>("job:");
  const auto out = file.inputs<typename Model::Out>("out:");
  const auto driver = file.states<Driver>();
  struct Over {
    Bit over;
  };
  file.clock(driver, "", [&](Driver& d) { return Over{d.driven(job, out)}; });
  file.say("drive", [&] { return driver.drive(job, resting<Model>(false)); });
  return file.file();
}

/// The checker of its jobs.
template <class Model>
Exported exported_checker(const std::string& name) {
  using Checker = typename Model::Checker;
  Exporting file("checker of " + name, name);
  const auto job = file.inputs<typename Model::Job>("job:");
  const auto driver = file.inputs<typename Model::Driver>("driver:");
  const auto out = file.inputs<typename Model::Out>("out:");
  struct Over {
    Bit over;
  };
  const auto over = file.inputs<Over>().over;
  const auto checker = file.states<Checker>();
  struct Wrong {
    Bit wrong;
  };
  file.clock(checker, "", [&](Checker& c) { return Wrong{c.checked(job, driver, out, over)}; });
  return file.file();
}

/// Writes PATH.btor2, PATH.ways.btor2 and, of a model with jobs, PATH.driver.btor2 and
/// PATH.checker.btor2. Where one cannot be exported it has a line "; error: TEXT" alone, and so
/// have those after it.
template <class Model>
void write_exported(const std::string& path, const std::string& name) {
  std::string failure;
  const auto write = [&](const std::string& more, const auto& make) {
    std::string text;
    try {
      if (failure.empty()) text = make().text;
    } catch (const InputError& error) {
      failure = error.what();
    } catch (const std::exception& error) {
      failure = name + ": the model throws: " + error.what();
    }
    if (!failure.empty()) text = "; error: " + failure + '\n';
    std::ofstream(path + more + ".btor2.new") << text;
    std::filesystem::rename(path + more + ".btor2.new", path + more + ".btor2");
  };
  write("", [&] { return exported<Model>(name); });
  write(".ways", [&] { return exported_ways<Model>(name); });
  if constexpr (requires { typename Model::Job; }) {
    write(".driver", [&] { return exported_driver<Model>(name); });
  }
  if constexpr (requires { typename Model::Checker; }) {
    write(".checker", [&] { return exported_checker<Model>(name); });
  }
}

}  // namespace cosim::clocked
