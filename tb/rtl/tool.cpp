// cosim_rtl: what CMake asks of RTL before there is a program of the project.
#include <fcntl.h>
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
#include "tb/rtl/read.h"

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

Ran run_program(Words words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw InputError("no pipe can be made");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {1, 2}) posix_spawn_file_actions_adddup2(&actions, ends[1], stream);
  pid_t child = 0;
  const bool runs = posix_spawnp(&child, list[0], &actions, nullptr, list.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  Ran ran;
  char part[4096];
  for (ssize_t n = 0; (n = read(ends[0], part, sizeof part)) > 0;) {
    ran.text.append(part, static_cast<std::size_t>(n));
  }
  close(ends[0]);
  int status = 127 << 8;
  if (runs) waitpid(child, &status, 0);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  return ran;
}

// A line for each, as a string of C++ has them.
template <class All, class Text>
std::string lines(const All& all, Text text) {
  std::string made;
  for (const auto& one : all) made += (made.empty() ? "" : "\\n") + text(one);
  return made;
}

// What tables of registers have: NAME WIDTH WORDS BITS [NET WIDTH WORDS LOW]... BITS are ranges,
// "7:4,0:0".
std::string register_text(const Register& r) {
  const auto sizes = [](const auto& net) {
    return ' ' + std::to_string(net.width) + ' ' + std::to_string(net.words) + ' ';
  };
  std::string bits;
  for (const auto& [high, low] : r.bits) {
    bits += (bits.empty() ? "" : ",") + std::to_string(high) + ':' + std::to_string(low);
  }
  std::string text = r.name + sizes(r) + bits;
  for (const Register::Carrier& c : r.carriers) {
    text += ' ' + c.net + sizes(c) + std::to_string(c.low);
  }
  return text;
}

// FOLDER/found.cmake: what read_rtl() says, as variables of CMake.
void read_for_cmake(const Words& words) {
  RtlAsked asked{words[1], words[2], ".", {}, {}, words[3], words[4], words[5]};
  for (std::size_t i = 6; i < words.size(); ++i) {
    const bool is_option = words[i].starts_with('-') || words[i].starts_with('+');
    (is_option ? asked.options : asked.files).push_back(words[i]);
  }
  const RtlRead read = read_rtl(asked, run_program);
  std::vector<Reset> resets;
  for (const Reset& r : read.found.resets) {
    if (r.kind != Reset::Kind::synchronous) resets.push_back(r);
  }
  std::string text;
  const auto set = [&](const char* name, const std::string& value) {
    text += std::string("set(found_") + name + " [==[" + value + "]==])\n";
  };
  const auto list = [](const Words& all) {
    std::string made;
    for (const std::string& one : all) made += (made.empty() ? "" : ";") + one;
    return made;
  };
  const auto as_is = [](const std::string& name) { return name; };
  set("registers", lines(read.found.registers, register_text));
  set("resets", lines(resets, [](const Reset& r) {
        return (r.kind == Reset::Kind::inner ? "inner " : "") +
               std::string(r.is_active_low ? "low " : "") + r.name;
      }));
  set("clocks", lines(read.found.clocks,
                      [](const Clock& c) { return (c.falls ? "falling " : "") + c.name; }));
  set("outputs", lines(read.found.outputs, as_is));
  set("unrolled", list(read.verilator));
  set("sources", list(read.sources));
  set("language", read.language);
  set("doubt", read.doubt);
  write_text(asked.work / "found.cmake", text);
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
  if (words.size() > 6 && words[0] == "read") {
    read_for_cmake(words);
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
}  // namespace cosim::rtl

int main(int argc, char** argv) {
  try {
    if (cosim::rtl::is_answered({argv + 1, argv + argc})) return 0;
    std::cerr << "usage: cosim_rtl verilog TOP FOLDER 'NAME=VALUE NAME=VALUE' BLACKBOX,BLACKBOX "
                 "FILE... | names STAMP ROOT HEADER... | lists LIST... | read VERILATOR YOSYS TOP "
                 "CLOCKS FOLDER OPTION... FILE...\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return 2;
}
