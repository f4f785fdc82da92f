#include "tb/new/found_shape.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <cstdlib>

#include "model/core/input_error.h"
#include "tb/rtl/plain_verilog.h"

namespace cosim::cli {

std::string verilator_program() {
  // The program itself: the script in front of it takes five times as long as a small design.
  if (const char* root = std::getenv("VERILATOR_ROOT"); root != nullptr) {
    const std::string own = fmt::format("{}/bin/verilator_bin", root);
    if (std::filesystem::exists(own)) return own;
  }
  for (const char* program : {"verilator_bin", "verilator"}) {
    if (is_installed(program)) return program;
  }
  throw InputError("needs verilator");
}

std::string verilator_option(const FoundParameter& p) {
  return fmt::format("-G{}={}", p.name, p.is_text ? '"' + p.value + '"' : p.value);
}

rtl::Ran run_for_rtl(const std::vector<std::string>& words) {
  Ended ended = cosim::run_program(words);
  return {ended.status, std::move(ended.text)};
}

std::vector<std::string> plain_verilog(const RtlQuestion& question,
                                       const std::vector<std::string>& parameters,
                                       const std::filesystem::path& work) {
  return rtl::plain_verilog(
      {question.folder, question.files, question.top, parameters, question.blackboxes}, work,
      run_for_rtl);
}

std::optional<rtl::Shape> shape_with(const RtlQuestion& question, const std::string& other,
                                     long value, const std::vector<std::string>& verilator,
                                     const std::filesystem::path& work) {
  std::filesystem::create_directories(work);
  const std::string tree = (work / "tree").string();
  std::vector<std::string> words{"env", "-C", question.folder.string()};
  words.insert(words.end(), verilator.begin(), verilator.end());
  words.insert(words.end(), {tree, "--top-module", question.top, "-Mdir", work.string()});
  words.insert(words.end(), {"--no-timing", "-Wno-fatal", "-Wno-lint", "-Wno-style"});
  words.insert(words.end(), question.options.begin(), question.options.end());
  for (const FoundParameter& p : question.parameters) {
    if (p.name != other) words.push_back(verilator_option(p));
  }
  words.push_back(fmt::format("-G{}={}", other, value));
  std::vector<std::string> parameters{fmt::format("{}={}", other, value)};
  for (const FoundParameter& p : question.parameters) {
    if (p.name != other) parameters.push_back(p.name + '=' + p.value);
  }
  try {
    const auto files = plain_verilog(question, parameters, work);
    words.insert(words.end(), files.begin(), files.end());
  } catch (const InputError&) {
    return std::nullopt;
  }
  // An address of twice the width may be a memory that takes minutes.
  constexpr int seconds = 10;
  if (const Ended ended = cosim::run_program(words, seconds);
      ended.timed_out || ended.status != 0) {
    return std::nullopt;
  }
  try {
    return rtl::shape_of(tree);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace cosim::cli
