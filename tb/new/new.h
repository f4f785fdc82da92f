// What `cosim new` writes: the texts of a project around a design of one's own.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "tb/new/found.h"
#include "tb/new/new_sources.h"

namespace cosim::cli {

enum class NewModel {
  proved,    ///< of every clock
  unproved,  ///< the same, of which nothing is proved
  stream,    ///< a function of transactions
};

/// "uart" as "UART".
std::string upper(std::string text);
/// "async_fifo" as "AsyncFifo".
std::string in_one_word(const std::string& name);

/// Names that C++, its library and macros, or a model have already.
class TakenNames {
 public:
  /// Beside those of C++: words with blanks between them.
  explicit TakenNames(const std::string& more);
  void insert(const std::string& name) { all_.insert(name); }
  bool contains(const std::string& name) const { return all_.contains(name); }
  /// A net's name as one of C++: "fifo.count" as "fifo_count"; one that is taken ends in _.
  std::string other_than(const std::string& path) const;

 private:
  std::set<std::string> all_;
};

/// InputError, one line, for files that a project cannot hold: two of one name, one of a name that
/// it has itself or that CMake would not take, one with a byte-order mark.
void require_files(const std::string& name, const Sources& sources);
/// The same for names in the RTL that no model can have.
void require_names(const Found& found);
/// A size in C++, or the number alone: "WIDTH + 1", where `name` makes WIDTH of WIDTH.
std::string text_of(const FoundSize& size,
                    const std::function<std::string(const std::string&)>& name);
/// The same in a model of a struct.
std::string text_of(const FoundSize& size);
/// The type of a net in such a model: "UInt<WIDTH + 1>".
std::string type_of(const FoundNet& net);
/// The line before the struct with its parameters; none where it has none.
std::string template_of(const Found& found);
/// Names that a member of a struct in it cannot have.
std::string taken_in(const std::string& title, const Found& found);
/// The widest elements of equal width, at most 64 bits, that make up a word of a memory.
int part_of(const FoundNet& memory);

/// The model of RTL that was read.
struct BegunModel {
  std::string text;
  std::vector<std::string> left;  ///< what is left to be done, sentences
};
BegunModel lockstep_model(const std::string& name, const Found& found);
/// The name of the struct of either.
std::string struct_of(const std::string& name, const Found& found);
/// InputError where no streams are found among its ports.
BegunModel stream_model(const std::string& name, const Found& found);

/// The design of a project without RTL of one's own.
struct FirstDesign {
  std::string what;  ///< a few words
  std::string rtl, model;
  std::string call;  ///< the words of cosim_add_design()
};
FirstDesign first_design(const std::string& name, NewModel model);

/// The words of cosim_add_design() for RTL that was read; `headers`: their folder, or "".
std::string design_of(const std::string& name, const Found& found,
                      const std::vector<std::string>& sources, NewModel model,
                      const std::string& headers, const std::vector<std::string>& defines,
                      const std::vector<std::string>& blackboxes);
std::string cmake_of(const std::string& name, const std::string& design);
std::string readme_of(const std::string& name, NewModel model);
std::string ci_of();

}  // namespace cosim::cli
