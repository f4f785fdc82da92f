// The commands of the program and their options, as its own help has them: nothing is listed twice.
#pragma once

#include <string>
#include <vector>

namespace cosim::careless {

struct Option {
  std::string name;   ///< "--csv"
  std::string value;  ///< the word that stands for its value: "FILE", "X,Y"; empty of a switch
  std::string help;
};

struct Command {
  std::vector<std::string> words;  ///< "sweep", "DESIGN"
  std::vector<std::string> positionals;
  std::vector<Option> options;
  std::vector<std::string> example;  ///< the arguments of its example, the words among them
  std::string help;                  ///< all of it
};

/// Those of `program`, a command of commands by its parts. std::runtime_error where it gives no
/// help or there is nothing in it.
std::vector<Command> commands_of(const std::string& program);

}  // namespace cosim::careless
