#include "tb/show/fst.h"

#include <fmt/core.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "model/core/input_error.h"
#include "tb/show/wave_shape.h"
#include "tb/util/output_file.h"

namespace cosim {
namespace {

// The writer maps its file into memory, where a full disk is no error but a signal: so it is left
// some room.
void check_room(const std::string& path) {
  constexpr std::uintmax_t needed = 4U << 20;
  std::error_code error;
  const auto folder = std::filesystem::absolute(path, error).parent_path();
  const auto room = std::filesystem::space(folder, error);
  if (!error && room.available < needed) {
    throw InputError(fmt::format("{}: cannot write: {}", path, std::strerror(ENOSPC)));
  }
}

}  // namespace

Fst::Fst(const std::string& path)
    : path_(path), half_(beside(path)), hierarchy_(half_.path() + ".hier") {
  check_room(path);
  // The writer opens whatever has that name: made first, it is nobody else's.
  const int made = open_beside(path, half_.path());
  if (made >= 0) {
    ::close(made);
    writer_ = fstWriterCreate(half_.path().c_str(), 1);
  }
  if (writer_ == nullptr) {
    throw InputError(fmt::format("{}: cannot write: {}", path, std::strerror(errno)));
  }
  fstWriterSetTimescale(writer_, -9);
  fstWriterSetVersion(writer_, "cosim");
  fstWriterSetDate(writer_, "");  // the same run gives the same file
  fstWriterSetPackType(writer_, FST_WR_PT_LZ4);
}

Fst::~Fst() {
  if (writer_ != nullptr) fstWriterClose(writer_);
}

void Fst::open_scope(const std::string& name) {
  fstWriterSetScope(writer_, FST_ST_VCD_MODULE, name.c_str(), nullptr);
}

void Fst::close_scope() { fstWriterSetUpscope(writer_); }

Fst::Handle Fst::variable(const std::string& name, int width, const std::string& range) {
  const std::string bits = range.empty() ? range_of_bits(width) : range;
  const std::string full = bits.empty() ? name : name + ' ' + bits;
  return fstWriterCreateVar(writer_, FST_VT_VCD_WIRE, FST_VD_IMPLICIT,
                            static_cast<std::uint32_t>(width), full.c_str(), 0);
}

Fst::Handle Fst::real(const std::string& name) {
  return fstWriterCreateVar(writer_, FST_VT_VCD_REAL, FST_VD_IMPLICIT, sizeof(double), name.c_str(),
                            0);
}

Fst::Handle Fst::text(const std::string& name) {
  return fstWriterCreateVar(writer_, FST_VT_GEN_STRING, FST_VD_IMPLICIT, 0, name.c_str(), 0);
}

void Fst::time(std::uint64_t t) { fstWriterEmitTimeChange(writer_, t); }

void Fst::value(Handle handle, int width, Word value) {
  static_assert(std::endian::native == std::endian::little);
  bytes(handle, width, reinterpret_cast<const unsigned char*>(&value));
}

void Fst::bytes(Handle handle, int width, const unsigned char* bytes) {
  digits_.resize(static_cast<std::size_t>(width));
  for (int i = 0; i < width; ++i) {
    digits_[static_cast<std::size_t>(width - 1 - i)] =
        (bytes[i / 8] >> (i % 8) & 1) != 0 ? '1' : '0';
  }
  fstWriterEmitValueChange(writer_, handle, digits_.data());
}

void Fst::number(Handle handle, double number) {
  fstWriterEmitValueChange(writer_, handle, &number);
}

void Fst::text(Handle handle, const std::string& text) {
  // The writer has no look at what it was before.
  if (const auto now = texts_.find(handle); now != texts_.end() && now->second == text) return;
  texts_[handle] = text;
  fstWriterEmitVariableLengthValueChange(writer_, handle, text.data(),
                                         static_cast<std::uint32_t>(text.size()));
}

void Fst::close() {
  fstWriterClose(writer_);
  writer_ = nullptr;
  // The writer does not say that the disk was full; a file that is not whole cannot be opened.
  auto* const reader = fstReaderOpen(half_.path().c_str());
  if (reader == nullptr) throw InputError(fmt::format("{}: cannot write it whole", path_));
  fstReaderClose(reader);
  if (std::rename(half_.path().c_str(), path_.c_str()) != 0) {
    throw InputError(fmt::format("{}: cannot write: {}", path_, std::strerror(errno)));
  }
  half_.keep();
}

}  // namespace cosim
