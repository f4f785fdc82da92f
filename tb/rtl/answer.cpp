#include "tb/rtl/answer.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <exception>
#include <iostream>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/rtl/file_list.h"
#include "tb/rtl/files.h"
#include "tb/rtl/names.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/rtl/preprocessed.h"
#include "tb/rtl/registers.h"

namespace cosim::rtl {
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
  FileList all;
  for (const std::string& list : lists) {
    read_file_list(list, true, place_today, all);
  }
  if (!all.libraries.empty()) {
    throw InputError(lists.front() + ": -y or -v: the files that are needed must be named");
  }
  const auto print = [](const char* kind, const Words& words) {
    for (const std::string& word : words) std::cout << kind << ' ' << word << '\n';
  };
  print("SOURCES", all.files);
  print("INCLUDE_DIRS", all.include_dirs);
  print("DEFINES", with_defines(all.defines, {}));
  print("LISTS", all.lists);
}

// False where the words ask nothing.
bool is_answered(const Words& words) {
  if (words.size() > 1 && words[0] == "lists") {
    print_lists({words.begin() + 1, words.end()});
    return true;
  }
  if (words.size() > 3 && words[0] == "names") {
    check_names(words[1], words[2], {words.begin() + 3, words.end()});
    return true;
  }
  if (words.size() == 3 && words[0] == "warnings") {
    write_text(words[1], with_warnings(text_of(words[1]), parted(words[2], ';')));
    return true;
  }
  if (words.size() > 3 && words[0] == "registers") {
    const std::string netlist = words.size() > 4 ? words[4] : "";
    print_registers({words[1], words[2], netlist, words[3]}, std::cout);
    return true;
  }
  if (words.size() < 6 || words[0] != "verilog") return false;
  Sources sources;
  sources.top = words[1];
  sources.parameters = parted(words[3], ' ');
  sources.blackboxes = parted(words[4], ',');
  sources.files.assign(words.begin() + 5, words.end());
  for (const std::string& file : plain_verilog(sources, words[2], run_program)) {
    std::cout << file << '\n';
  }
  return true;
}

}  // namespace

int answer(const std::vector<std::string>& words) {
  try {
    if (is_answered(words)) return 0;
    std::cerr << "usage: cosim_rtl verilog TOP FOLDER 'NAME=VALUE NAME=VALUE' BLACKBOX,BLACKBOX "
                 "FILE... | names STAMP ROOT HEADER... | lists LIST... | registers TREE WARNINGS "
                 "CLOCKS [NETLIST] | warnings FILE 'FILE;FILE'\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return 2;
}

}  // namespace cosim::rtl
