#include "tb/rtl/files.h"

#include <fstream>
#include <iterator>

#include "model/core/input_error.h"

namespace cosim::rtl {

std::string text_of(const std::filesystem::path& file, const std::string& name) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw InputError(name + ": no such file");
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  if (!(out << text).flush()) throw InputError(file.string() + ": cannot be written");
}

}  // namespace cosim::rtl
