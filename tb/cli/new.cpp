// cosim new: a project around a design of one's own.
#include "tb/cli/new.h"

#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "model/core/input_error.h"
#include "tb/cli/commands.h"
#include "tb/cli/taken.h"
#include "tb/support/draft.h"
#include "tb/support/read_file.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
  std::vector<std::string> words;  ///< the name, then the files
  bool plain = false, stream = false;
};

// The folder's name is that of a namespace, too.
void require_name(const std::string& name) {
  const bool good =
      !name.empty() &&
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos &&
      name.front() >= 'a' && name.front() <= 'z';
  if (!good) {
    throw InputError(fmt::format("NAME: {} is not small letters, digits and _, a letter first",
                                 in_quotes(name)));
  }
  if (is_cpp_word(name)) throw InputError(fmt::format("NAME: {} is a word of C++", name));
  if (const std::string header = taken_by(name); !header.empty()) {
    throw InputError(fmt::format("NAME: {} is the harness's own, in {}", name, header));
  }
  if (fs::exists(name)) throw InputError(name + ": exists");
}

int run(const NewOptions& o) {
  if (o.words.empty()) throw InputError("NAME: is needed");
  if (o.plain && o.stream) throw InputError("--plain: does not go with --stream");
  const NewModel model = o.stream  ? NewModel::stream
                         : o.plain ? NewModel::plain
                                   : NewModel::generic;
  const std::string& name = o.words.front();
  require_name(name);
  const std::vector<std::string> files(o.words.begin() + 1, o.words.end());
  std::vector<std::string> texts;
  for (const std::string& f : files) texts.push_back(read_file(f));
  require_files(name, files, texts);
  const Found found = files.empty() ? Found{} : found_in(files, !o.stream);
  if (!files.empty()) require_names(found);

  Draft project(fs::current_path(), name);
  const FirstDesign first = files.empty() ? first_design(name, model) : FirstDesign{};
  std::string design = first.call;
  BegunModel begun;
  if (files.empty()) {
    project.write(name + ".v", first.rtl);
    project.write(name + ".h", first.model);
  } else {
    std::vector<std::string> sources;
    for (std::size_t i = 0; i < files.size(); ++i) {
      sources.push_back(fs::path(files[i]).filename().string());
      project.write(sources.back(), texts[i]);
    }
    begun = o.stream ? stream_model(name, found) : lockstep_model(name, found, o.plain);
    project.write(name + ".h", begun.text);
    design = design_of(name, found, sources, model);
  }
  project.write("CMakeLists.txt", cmake_of(name, design));
  project.write("README.md", readme_of(name, model));
  fs::create_directories(project.folder() / ".github/workflows");
  project.write(".github/workflows/ci.yml", ci_of());
  project.finish();
  if (files.empty()) {
    fmt::print("{}/: {}; README.md has its two commands\n", name, first.what);
    return 0;
  }
  fmt::print("{}/: {}, {}, {}; README.md has its two commands\n", name,
             count(found.inputs.size(), "input"), count(found.outputs.size(), "output"),
             o.stream ? "as streams" : count(found.registers.size(), "register"));
  for (const std::string& left : begun.left) fmt::print("{0}/{0}.h: {1}\n", name, left);
  return 0;
}

}  // namespace

void add_new(const Command& program) {
  auto o = std::make_shared<NewOptions>();
  const Command command = program.sub("new", "A project for a design of your own, in a new folder");
  command.arguments("NAME FILE...", o->words,
                    "The name of the folder and the design; then its Verilog files, whose ports,\n"
                    "parameters and registers become the model's tables. Without a file: a small\n"
                    "design that passes");
  command.flag("--plain", o->plain,
               "The model's step in any C++, on machine integers: nothing is proved of it");
  command.flag("--stream", o->stream,
               "A model without clocks: what comes out of the ports *_valid for what goes in");
  command.footer(fmt::format("Example: {} new adder adder.v", program_name()));
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli
