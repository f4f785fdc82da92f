// run FOLDER SEED: the outputs of that model of models.h as SEED.tb.v prints them, for the lines of
// SEED.in. Where that file is not there it is written, 10,000 clocks by chance.
// run FOLDER gold: each SEED.btor2 as SEED.gold.v. Compiled by scripts/models.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>

#include "model/clocked/model.h"
#include "tests/models/gold.h"

namespace cosim::clocked {
#include "models.h"

template <class Model>
void run(const std::string& file) {
  if (!std::filesystem::exists(file)) {
    std::mt19937 random(1);
    std::ofstream to(file);
    for (int clock = 0; clock < 10000; ++clock) {
      to << (clock < 3 || random() % 50 == 0);
      const auto in = zero<typename Model::In>();
      for_each_cell(in, [&]<class Cell>(const Label& label, const Cell&) {
        for (int i = 0; label.name != "rst" && i < Cell::width; ++i) to << random() % 2;
      });
      to << '\n';
    }
  }
  std::ifstream from(file);
  Model model{};
  for (std::string line; from >> line;) {
    std::size_t at = 0;
    auto in = zero<typename Model::In>();
    for_each_cell(in, [&]<class Cell>(const Label&, Cell& cell) {
      UInt<Cell::width> code = 0;
      for (int i = Cell::width - 1; i >= 0; --i) code[i] = Bit(line.at(at++) == '1');
      set_code(cell, code);
    });
    const auto out = model.clock(in);
    std::string text;
    for_each_cell(out, [&]<class Cell>(const Label&, const Cell& cell) {
      if (!text.empty()) text += ' ';
      const auto code = code_of(cell);
      for (int i = Cell::width - 1; i >= 0; --i) text += code[i] ? '1' : '0';
    });
    std::cout << text << '\n';
  }
}

}  // namespace cosim::clocked

int main(int, char** words) {
  using namespace cosim::clocked;
  const std::string folder = std::string(words[1]) + '/', wanted = words[2];
  for_each_model([&]<class Model>(const std::string& seed) {
    if (wanted == "gold") {
      std::ifstream file(folder + seed + ".btor2");
      std::ofstream(folder + seed + ".gold.v") << cosim::models::gold(file);
    } else if (wanted == seed) {
      run<Model>(folder + seed + ".in");
    }
  });
}
