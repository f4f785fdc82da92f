// careless PROGRAM [--seed S] [--first K] [--cases N] [--seconds T] [--without COMMAND]...
//
// Runs whole command lines of the program, drawn from a seed, and checks what holds of each: see
// judge.h. Prints what does not hold, with the command line and the number of its case.
// Status: 0 all held, 1 not, 2 could not be run.
#include <sys/stat.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "tests/careless/judge.h"

namespace cosim::careless {
namespace {

struct Wanted {
  std::string program;
  std::uint64_t seed = 1, first = 0, cases = ~std::uint64_t{0};
  double seconds = 1e18;
  std::vector<std::string> without;
};

Wanted parse(int argc, char** argv) {
  if (argc < 2) throw std::invalid_argument("PROGRAM is needed");
  Wanted w;
  w.program = std::filesystem::absolute(argv[1]).string();
  for (int i = 2; i < argc; i += 2) {
    const std::string option = argv[i];
    if (i + 1 == argc) throw std::invalid_argument(option + " needs a value");
    const std::string value = argv[i + 1];
    const std::map<std::string, std::uint64_t*> numbers{
        {"--seed", &w.seed}, {"--first", &w.first}, {"--cases", &w.cases}};
    if (const auto number = numbers.find(option); number != numbers.end()) {
      *number->second = std::stoull(value);
    } else if (option == "--seconds") {
      w.seconds = std::stod(value);
    } else if (option == "--without") {
      w.without.push_back(value);
    } else {
      throw std::invalid_argument("no such option: " + option);
    }
  }
  return w;
}

// What no run may change: devices, and the project.
std::string outside(const Wanted& w) {
  std::string all;
  for (const std::string& path : {std::string("/dev/null"), std::string("/dev/full"), w.program,
                                  std::filesystem::path(w.program).parent_path().string(),
                                  std::filesystem::path(COSIM_ROOT).string()}) {
    struct stat now {};
    stat(path.c_str(), &now);
    all += path + ' ' + std::to_string(now.st_mode) + ' ' + std::to_string(now.st_ino) + ' ';
    // The build folder changes while others use it.
    if (path.starts_with("/dev/") || path == w.program) continue;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      if (entry.path().extension() == ".cosim-new") all += entry.path().string();
    }
  }
  return all;
}

int run_all(const Wanted& w) {
  adopt();
  std::vector<Command> commands = commands_of(w.program);
  for (const std::string& name : w.without) {
    std::erase_if(commands, [&](const Command& c) { return c.words.front() == name; });
  }
  const auto begin = std::chrono::steady_clock::now();
  const std::string untouched = outside(w);
  std::uint64_t at = w.first, bad = 0, statuses[4] = {};
  for (; at - w.first < w.cases; ++at) {
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin;
    if (gone.count() >= w.seconds) break;
    const Case one = draw(commands, w.seed, at);
    const Scratch scratch(std::filesystem::path(COSIM_ROOT));
    const Held before = scratch.holds();
    const Came came = run(w.program, one, scratch);
    ++statuses[came.status <= 2 ? came.status : 3];
    auto found = faults(one, came, scratch, before, scratch.holds());
    if (outside(w) != untouched) found.push_back("something outside of its folder is changed");
    if (found.empty()) continue;
    ++bad;
    std::cout << "case " << at << " of seed " << w.seed << ", status " << came.status << ", "
              << came.seconds << " s\n  " << command_line(w.program, one) << '\n';
    for (const std::string& fault : found) std::cout << "  " << fault << '\n';
    std::cout << std::flush;
  }
  std::cout << at - w.first << " command lines: " << statuses[0] << " ended with 0, " << statuses[1]
            << " with 1, " << statuses[2] << " with 2, " << statuses[3] << " by a signal; " << bad
            << " did what none may\n";
  return bad == 0 ? 0 : 1;
}

}  // namespace
}  // namespace cosim::careless

int main(int argc, char** argv) {
  try {
    return cosim::careless::run_all(cosim::careless::parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "careless: %s\n", error.what());
    return 2;
  }
}
