// Checks of what an exporter wrote, kept beside its files.
#pragma once

#include <functional>
#include <string>

namespace cosim::nets {

/// Runs `check`, which throws where something differs, unless this program ran it before on the
/// same files of the exporter: FILE.NAME.PROGRAM has the hash of both.
void check_once(const std::string& file, const std::string& name,
                const std::function<void()>& check);

}  // namespace cosim::nets
