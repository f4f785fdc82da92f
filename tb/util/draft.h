// A folder that appears when it is whole.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "tb/util/interrupt.h"

namespace cosim {

/// InputError where a folder of that name has anything that no draft wrote, and where something
/// else has its name: it is not to be replaced.
void require_own_folder(const std::filesystem::path& folder);

/// Written under another name, and removed if it is not finished. A signal that interrupts waits
/// until then.
class Draft {
 public:
  /// Of root/name. InputError where that cannot be written, and as require_own_folder().
  Draft(const std::filesystem::path& root, const std::string& name);
  ~Draft();
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  const std::filesystem::path& target() const { return target_; }
  /// A file of the folder. InputError as OutputFile.
  void write(const std::string& name, const std::string& text) const;

  /// Replaces an older folder of that name. The list of its files, .cosim, is one of them: by that
  /// the next draft knows them. If two programs write the same folder, the last one stays.
  void finish_replacing();
  /// The same where there is no folder of that name, and without a list.
  void finish();

 private:
  [[noreturn]] void fail(const std::error_code& error) const;

  InterruptGuard interrupts_;
  std::filesystem::path target_, folder_, old_;
};

}  // namespace cosim
