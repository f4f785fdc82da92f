// What `cosim new` writes: the texts of a project around a design of one's own.
#pragma once

#include <string>
#include <vector>

#include "tb/new/found.h"
#include "tb/new/new_sources.h"

namespace cosim::cli {

enum class NewModel {
  generic,  ///< a step over a value type
  plain,    ///< a step on machine integers alone
  stream,   ///< a function of transactions
};

/// A row of a table.
struct NewRow {
  std::string field;  ///< its name in the model
  FoundNet net;
  bool elsewhere = false;  ///< where the RTL has it does not follow from that name
  std::string bits = {};   ///< "[7:4]", where it is only these of the net

  std::string at() const { return net.name + bits; }
};

/// "uart" as "UART".
std::string upper(std::string text);
/// A net's name as one of C++: "fifo.count" as "fifo_count"; one that C++ or the records need for
/// themselves ends in _.
std::string field_of(const std::string& path);
/// InputError, one line, for files that a project cannot hold: two of one name, one of a name that
/// it has itself or that CMake would not take, one with a byte-order mark.
void require_files(const std::string& name, const Sources& sources);
/// The same for names in the RTL that cannot be written in a table.
void require_names(const Found& found);
/// "p.WIDTH + 1", or the number alone.
std::string text_of(const FoundSize& size);
/// #define NAME and the rows behind it.
std::string table_of(const std::string& name, const std::vector<NewRow>& rows);
/// The members of struct Params.
std::string params_of(const Found& found);
/// The function parameters() of struct Design; nothing where there are none.
std::string parameters_of(const Found& found);

/// The model of RTL that was read.
struct BegunModel {
  std::string text;
  std::vector<std::string> left;  ///< what is left to be done, sentences
};
BegunModel lockstep_model(const std::string& name, const Found& found, bool plain);
/// InputError where no streams are found among its ports.
BegunModel stream_model(const std::string& name, const Found& found);

/// The design of a project without RTL of one's own.
struct FirstDesign {
  std::string what;  ///< a few words
  std::string rtl, model;
  std::string call;  ///< the words of cosim_add_design()
};
FirstDesign first_design(const std::string& name, NewModel model);

/// The words of cosim_add_design() for RTL that was read.
std::string design_of(const std::string& name, const Found& found,
                      const std::vector<std::string>& sources, NewModel model, bool has_headers,
                      const std::vector<std::string>& defines,
                      const std::vector<std::string>& blackboxes);
std::string cmake_of(const std::string& name, const std::string& design);
std::string readme_of(const std::string& name, NewModel model);
std::string ci_of();

}  // namespace cosim::cli
