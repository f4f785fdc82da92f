// The models as they are compiled, beside the gates of what the exporter wrote of them.
#include <gtest/gtest.h>

#include "tb/nets/btor2.h"
#include "tb/nets/runs.h"
#include "tb/util/read_file.h"
#include "tests/clocked/compare.h"
#include "tests/clocked/models.h"

namespace cosim::clocked::test {
namespace {

constexpr std::size_t kRuns = 64;
using Planes = std::vector<std::uint64_t>;

// Adds the code of each cell: a bit of a plane for each of its bits, that of this run.
class Codes {
 public:
  Codes(Planes& planes, std::size_t run) : planes_(planes), run_(run) {}
  template <class T>
  void add(const T& object) {
    for_each_cell(object, [&]<class Cell>(const Label&, const Cell& cell) {
      const Wide code = to_wide(code_of(cell));
      for (int i = 0; i < Cell::width; ++i, ++at_) {
        if (at_ == planes_.size()) planes_.push_back(0);
        planes_[at_] |= (code[i / 64] >> i % 64 & 1) << run_;
      }
    });
  }

 private:
  Planes& planes_;
  std::size_t run_, at_ = 0;
};

template <class T>
void expect_cells(const T& object, const std::vector<nets::Btor2::Name>& cells) {
  std::size_t i = 0;
  for_each_cell(object, [&]<class Cell>(const Label& label, const Cell&) {
    ASSERT_LT(i, cells.size());
    EXPECT_EQ(label.name, cells[i].name);
    EXPECT_EQ(Cell::width, cells[i].width);
    ++i;
  });
  EXPECT_EQ(i, cells.size());
}
template <class Model>
void expect_init(const nets::Btor2& file) {
  std::size_t i = 0;
  const Model initial{};
  for_each_cell(initial, [&]<class Cell>(const Label& label, const Cell& cell) {
    const auto& init = file.init.at(i++);
    ASSERT_EQ(!init, label.is_unreset) << label.name;
    const Wide code = to_wide(code_of(cell));
    for (int k = 0; init && k < Cell::width; ++k) {
      ASSERT_EQ((*init)[static_cast<std::size_t>(k)], (code[k / 64] >> k % 64 & 1) != 0);
    }
  });
}

// Each run goes from clock to clock, and at times from a state that is drawn.
template <class Model>
void compare_gates(const std::string& name, int clocks) {
  SCOPED_TRACE(name);
  const std::string path = COSIM_EXPORTED "/" + name + ".btor2";
  nets::Btor2 file = nets::read_btor2(read_file(path), path);
  std::erase_if(file.outputs, [](const auto& of) {  // what the model says beside its clock
    return of.name.find(':') != std::string::npos;
  });
  expect_cells(zero<typename Model::In>(), file.inputs);
  expect_cells(Model{}, file.states);
  expect_cells(zero<typename Model::Out>(), file.outputs);
  expect_init<Model>(file);

  nets::Graph graph;
  const auto free_words = [&](const std::vector<nets::Btor2::Name>& cells) {
    std::vector<nets::Bits> words;
    for (const auto& cell : cells) {
      words.emplace_back();
      for (int i = 0; i < cell.width; ++i) words.back().push_back(graph.input());
    }
    return words;
  };
  const auto inputs = free_words(file.inputs), states = free_words(file.states);
  const nets::Clocked gates = nets::placed(graph, file, inputs, states);
  nets::Bits results;
  for (const auto* words : {&gates.outputs, &gates.next}) {
    for (const nets::Bits& word : *words) results.insert(results.end(), word.begin(), word.end());
  }

  Random random(1);
  std::vector<Model> models(kRuns);
  for (int clock = 0; clock < clocks; ++clock) {
    Planes before, after;
    for (std::size_t run = 0; run < kRuns; ++run) {
      std::vector<Wide> drawn;
      Model& model = models[run];
      if (random() % 32 == 0) draw(random, model, drawn);
      auto in = zero<typename Model::In>();
      draw(random, in, drawn);
      Codes from(before, run), to(after, run);
      from.add(in);
      from.add(model);
      const typename Model::Out out = model.clock(in);
      to.add(out);
      to.add(model);
    }
    const Planes planes = nets::run(graph, before);
    ASSERT_EQ(results.size(), after.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
      ASSERT_EQ(nets::in_runs(planes, results[i]), after[i]) << "clock " << clock << " bit " << i;
    }
  }
}

TEST(ClockedModels, AreTheGatesOfWhatTheExporterWrote) {
  for_each_model([]<class Model>(const std::string& name) { compare_gates<Model>(name, 100); });
}

}  // namespace
}  // namespace cosim::clocked::test
