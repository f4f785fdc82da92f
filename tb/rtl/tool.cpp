// cosim_rtl: what CMake asks of RTL before there is a program of the project.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <exception>
#include <iostream>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/rtl/file_list.h"
#include "tb/rtl/names.h"
#include "tb/rtl/plain_verilog.h"

namespace {

using Words = std::vector<std::string>;

// The words of a text between such characters.
Words parted(const std::string& text, char by) {
  Words all;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, by);) all.push_back(word);
  return all;
}

// The status of a program, as Run has it.
int run_program(Words words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  pid_t child = 0;
  int status = 0;
  if (posix_spawnp(&child, list[0], nullptr, nullptr, list.data(), environ) != 0) return 127;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

// What lists of files name, a line each; each path is absolute where those of the lists are.
void print_lists(const Words& lists) {
  cosim::rtl::FileList all;
  for (const std::string& list : lists) {
    cosim::rtl::read_file_list(list, true, cosim::rtl::place_today, all);
  }
  if (!all.libraries.empty()) {
    throw cosim::InputError(lists.front() + ": -y or -v: the files that are needed must be named");
  }
  const auto print = [](const char* kind, const Words& words) {
    for (const std::string& word : words) std::cout << kind << ' ' << word << '\n';
  };
  print("SOURCES", all.files);
  print("INCLUDE_DIRS", all.include_dirs);
  print("DEFINES", cosim::rtl::with_defines(all.defines, {}));
  print("LISTS", all.lists);
}

bool answer(const Words& words) {
  if (words.size() > 1 && words[0] == "lists") {
    print_lists({words.begin() + 1, words.end()});
    return true;
  }
  if (words.size() > 3 && words[0] == "names") {
    cosim::rtl::check_names(words[1], words[2], {words.begin() + 3, words.end()});
    return true;
  }
  if (words.size() < 6 || words[0] != "verilog") return false;
  cosim::rtl::Sources sources;
  sources.top = words[1];
  sources.parameters = parted(words[3], ' ');
  sources.blackboxes = parted(words[4], ',');
  sources.files.assign(words.begin() + 5, words.end());
  for (const std::string& file : cosim::rtl::plain_verilog(sources, words[2], run_program)) {
    std::cout << file << '\n';
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (answer({argv + 1, argv + argc})) return 0;
    std::cerr << "usage: cosim_rtl verilog TOP FOLDER 'NAME=VALUE NAME=VALUE' BLACKBOX,BLACKBOX "
                 "FILE... | names STAMP ROOT HEADER... | lists LIST...\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return 2;
}
