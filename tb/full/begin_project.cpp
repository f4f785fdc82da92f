#include "tb/full/begin_project.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "model/core/input_error.h"
#include "tb/equiv/front_end.h"
#include "tb/full/wrapped_top.h"
#include "tb/new/new.h"
#include "tb/new/new_sources.h"
#include "tb/new/verilog_words.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/rtl/verilog.h"
#include "tb/util/pattern.h"
#include "tb/util/quoted.h"
#include "tb/util/read_file.h"
#include "tb/util/scratch.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

// The words of values of parameters, some of which may be packages.
std::set<std::string> value_words(const std::vector<std::string>& parameters) {
  static const Pattern word("[A-Za-z_][A-Za-z0-9_$]*");
  std::set<std::string> all;
  for (const std::string& parameter : parameters) {
    const std::string value = parameter.substr(std::min(parameter.find('='), parameter.size()));
    for (const Pattern::Parts& one : word.all(value)) all.insert(one.front());
  }
  return all;
}

// A pin, a module: a name of Verilog.
std::string name_in(const std::string& option, const Text& value) {
  if (!value) return "";
  static const Pattern name("[A-Za-z_][A-Za-z0-9_$]*");
  if (name.whole(*value).empty()) {
    throw InputError(fmt::format("{}: {} is no name in Verilog", option, in_quotes(*value)));
  }
  return *value;
}

// The words that Verilator and yosys are given.
std::vector<std::string> options_of(const NewOptions& o, const std::string& headers) {
  static const Pattern define(R"([A-Za-z_][A-Za-z0-9_$]*(=[A-Za-z0-9_.:+'-]*)?)");
  std::vector<std::string> options;
  if (!headers.empty()) options.push_back("-I" + headers);
  for (const std::string& d : o.defines) {
    if (define.whole(d).empty()) {
      throw InputError(fmt::format("--define: {} is not NAME or NAME=VALUE", in_quotes(d)));
    }
    options.push_back("-D" + d);
  }
  return options;
}

// The folder of the headers, deep enough for those whose names begin with "../" to be in the
// project;
// "" where there are none.
std::string header_folder(const Sources& rtl) {
  std::size_t depth = 0;
  for (const SourceFile& header : rtl.headers) {
    const fs::path name = fs::path(header.name).lexically_normal();
    depth = std::max(depth, static_cast<std::size_t>(std::count(name.begin(), name.end(), "..")));
  }
  std::string folder = rtl.headers.empty() ? "" : "include";
  for (; depth > 0; --depth) folder += "/here";
  return folder;
}

// What slang makes of it. InputError, OutOfTime.
std::string slang_verilog(const RtlQuestion& asked, const std::string& headers,
                          const std::vector<std::string>& defines) {
  equiv::Files files;
  for (const std::string& file : asked.files) files.files.push_back(asked.folder / file);
  if (!headers.empty()) files.include_dirs = {asked.folder / headers};
  files.top = asked.top;
  files.defines = defines;
  for (const FoundParameter& p : asked.parameters) {
    files.parameters.push_back(p.name + '=' + (p.is_text ? '"' + p.value + '"' : p.value));
  }
  constexpr int seconds = 300;
  try {
    return equiv::verilog_by_slang(files, files.top, equiv::Budget(seconds));
  } catch (const InputError& error) {
    // The folder has its name when it is whole.
    std::string text = error.what();
    const std::string folder = asked.folder.string() + '/';
    for (std::size_t at = 0; (at = text.find(folder, at)) != std::string::npos;) {
      text.erase(at, folder.size());
    }
    throw InputError(text);
  }
}

// What yosys cannot read may be read by slang: then what keeps the design unproved is none.
void try_slang(Found& found, const RtlQuestion& asked, const std::string& headers,
               const std::vector<std::string>& defines) {
  if (found.unread.empty()) return;
  if (!equiv::has_slang()) {
    found.unread += equiv::slang_hint();
    return;
  }
  try {
    slang_verilog(asked, headers, defines);
    found.unread.clear();
  } catch (const InputError& error) {
    found.unread = error.what();
  } catch (const equiv::OutOfTime&) {
    found.unread = found.top + ": slang takes too long";
  }
}

// Defines SYNTHESIS, which most RTL asks for around what is no circuit, and reads it again.
bool with_synthesis(BegunProject& begun, RtlQuestion& asked, const Sources& rtl,
                    const std::string& why) {
  static const std::string macro = "SYNTHESIS";
  const auto is_asked = [](const SourceFile& file) {
    return file.text.find(macro) != std::string::npos;
  };
  const bool is_given = std::ranges::any_of(
      begun.defines, [](const std::string& d) { return d.substr(0, d.find('=')) == macro; });
  if (is_given ||
      (std::ranges::none_of(rtl.files, is_asked) && std::ranges::none_of(rtl.headers, is_asked))) {
    return false;
  }
  RtlQuestion again = asked;
  again.options.push_back("-D" + macro);
  try {
    begun.found = found_in(again);
  } catch (const InputError&) {
    return false;
  }
  asked = again;
  begun.defines.push_back(macro);
  begun.notes.push_back(fmt::format("{} is defined; without it: {}", macro, why));
  return true;
}

// Leaves out the defaults of inputs, which Verilator 5.006 does not read, where nothing needs them.
bool without_defaults(BegunProject& begun, RtlQuestion& asked, const Draft& project,
                      const std::string& why) {
  if (why.find("Default value on module input") == std::string::npos) return false;
  const Scratch scratch;
  const auto files = rtl::without_port_defaults(asked.folder, asked.files, scratch.path());
  std::map<std::string, std::string> before;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i] == asked.files[i]) continue;
    before[asked.files[i]] = read_file((asked.folder / asked.files[i]).string());
    project.write(asked.files[i], read_file(files[i]));
  }
  try {
    begun.found = found_in(asked);
  } catch (const InputError&) {
    for (const auto& [file, text] : before) project.write(file, text);
    return false;
  }
  begun.notes.push_back(fmt::format(
      "the defaults of inputs, which every instance gives a net, are left out: {}", why));
  return true;
}

// Has Verilog by slang in place of the sources. Gives "; " and why not; "" where it does.
std::string by_slang(BegunProject& begun, RtlQuestion& asked, const Draft& project,
                     const std::string& why) {
  if (!equiv::has_slang()) return equiv::slang_hint();
  const std::string file = asked.top + "_slang.v";
  RtlQuestion again = asked;
  again.files = {file};
  again.options.clear();
  again.parameters.clear();
  try {
    project.write(file, slang_verilog(asked, begun.headers, begun.defines));
    begun.found = found_in(again);
  } catch (const InputError& error) {
    fs::remove(project.folder() / file);
    return std::string("; ") + error.what();
  } catch (const equiv::OutOfTime&) {
    return "; slang takes too long";
  }
  for (const std::string& source : begun.sources) fs::remove(project.folder() / source);
  if (!begun.headers.empty()) fs::remove_all(project.folder() / begun.headers);
  asked = again;
  begun.headers.clear();
  begun.defines.clear();
  begun.sources = {file};
  begun.notes.push_back(fmt::format(
      "{} replaces the sources, as slang reads them with these parameters: {}", file, why));
  return "";
}

void read_rtl(BegunProject& begun, RtlQuestion& asked, const Sources& rtl, const Draft& project) {
  try {
    begun.found = found_in(asked);
    return;
  } catch (const InputError& refused) {
    static const std::string from = "new: ";
    const std::string all = refused.what();
    const std::string why = all.starts_with(from) ? all.substr(from.size()) : all;
    const bool is_of_words = why.starts_with("Verilator cannot ") ||
                             why.find(": waits, as a testbench does") != std::string::npos;
    if (!is_of_words) throw InputError(all);
    if (with_synthesis(begun, asked, rtl, why) || without_defaults(begun, asked, project, why)) {
      return;
    }
    const std::string otherwise = by_slang(begun, asked, project, why);
    if (otherwise.empty()) return;
    // Of words that are no language slang says the same.
    const bool is_alone = why.find("syntax error") != std::string::npos;
    throw InputError(is_alone ? all : all + otherwise);
  }
}

}  // namespace

BegunProject begin_project(const NewOptions& o, const Draft& project) {
  const std::string& name = o.words.front();
  const std::vector<std::string> given(o.words.begin() + 1, o.words.end());
  RtlQuestion question;
  question.folder = project.folder();
  for (const std::string& pin : parts_in(o.clock.value_or(""), ',')) {
    question.clocks.push_back(name_in("--clock", pin));
  }
  question.reset = name_in("--reset", o.reset);
  for (const std::string& box : o.blackboxes) {
    question.blackboxes.push_back(name_in("--blackbox", box));
  }
  Sources rtl = sources_of(
      {name, given, o.libraries, o.includes, name_in("--top", o.top), value_words(o.parameters)});
  require_files(name, rtl);
  require_homes(rtl, given);
  BegunProject begun;
  begun.headers = header_folder(rtl);
  begun.left_out = rtl.left_out;
  begun.top_is_guessed = rtl.top_is_guessed;
  for (const SourceFile& file : rtl.files) project.write(file.name, file.text);
  for (const SourceFile& header : rtl.headers) {
    const fs::path to = (fs::path(begun.headers) / header.name).lexically_normal();
    fs::create_directories((project.folder() / to).parent_path());
    project.write(to.string(), header.text);
  }
  if (!begun.headers.empty() && !fs::exists(project.folder() / begun.headers)) {
    fs::create_directories(project.folder() / begun.headers);
    project.write(begun.headers + "/.gitkeep", "");
  }
  question.options = options_of(o, begun.headers);
  const std::size_t files = rtl.files.size();
  question.parameters = with_wrapper(name, o.parameters, rtl, question);
  require_files(name, rtl);
  for (std::size_t i = files; i < rtl.files.size(); ++i)
    project.write(rtl.files[i].name, rtl.files[i].text);
  for (const SourceFile& file : rtl.files) begun.sources.push_back(file.name);
  question.files = begun.sources;
  question.top = rtl.top;
  begun.defines = o.defines;
  read_rtl(begun, question, rtl, project);
  try_slang(begun.found, question, begun.headers, begun.defines);
  require_names(begun.found);
  return begun;
}

}  // namespace cosim::cli
