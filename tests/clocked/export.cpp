// clocked_export FOLDER: writes each model there as NAME.btor2. Compiled twice, for the models of
// models.h and for the expressions.
#include "model/clocked/export.h"

#include <chrono>
#include <cstdio>
#include <fstream>

#ifdef COSIM_EXPRESSIONS
#include "tests/clocked/expressions.h"
#else
#include "tests/clocked/models.h"
#endif

int main(int, char** arguments) {
  using namespace cosim::clocked;
  const std::string folder = arguments[1];
  const auto write = [&]<class Model>(const std::string& name) {
    const auto begin = std::chrono::steady_clock::now();
    const Exported model = exported<Model>(name);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    std::ofstream(folder + "/" + name + ".btor2") << model.text;
#ifndef COSIM_EXPRESSIONS
    std::ofstream(folder + "/" + name + ".ways.btor2") << exported_ways<Model>(name).text;
#endif
    std::printf("%-16s %5llu ways %6zu nodes %8.2f ms\n", name.c_str(),
                static_cast<unsigned long long>(model.ways), model.nodes, spent.count() * 1e3);
  };
#ifdef COSIM_EXPRESSIONS
  test::for_each_width(write, test::AllWidths());
#else
  test::for_each_model(write);
#endif
}
