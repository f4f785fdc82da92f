// export FOLDER: the models of models.h as SEED.btor2. Compiled by scripts/models with
// -DCOSIM_SYMBOLIC.
#include <iostream>

#include "model/clocked/export.h"

namespace cosim::clocked {
#include "models.h"
}

int main(int, char** words) {
  using namespace cosim::clocked;
  ways.most_seconds = 120;  // not optimized
  for_each_model([&]<class Model>(const std::string& seed) {
    try {
      std::ofstream(std::string(words[1]) + '/' + seed + ".btor2") << exported<Model>(seed).text;
    } catch (const cosim::InputError& error) {
      std::cerr << error.what() << '\n';
    }
  });
}
