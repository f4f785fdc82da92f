#include "tb/lanes/gpu.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "model/core/input_error.h"
#include "tb/sim/hostile.h"
#include "tb/util/hash.h"
#include "tb/util/output_file.h"
#include "tb/util/read_file.h"

namespace cosim::lanes {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t nothing_found = ~std::uint32_t{0};

// The values that a clock of the code leaves no other place for are the registers' of a thread: of
// 255, less those of a clock's own values.
constexpr std::size_t planes_in_registers = 96;

// "// NAME NUMBER" of the source.
std::size_t noted(const std::string& source, const std::string& name) {
  const std::string word = "\n// " + name + ' ';
  const std::size_t at = source.find(word);
  if (at == std::string::npos) throw InputError("--lanes gpu: no kernel");
  return std::stoul(source.substr(at + word.size()));
}

}  // namespace

Gpu::Gpu(const fs::path& folder, const std::string& key,
         const std::function<std::string()>& source) {
  const fs::path file = folder / (hash_of(key) + ".cl");
  if (!fs::exists(file)) {
    const std::string text = source();
    std::error_code error;
    fs::create_directories(folder, error);
    write_file(file.string(), text);
  }
  const std::string text = read_file(file.string());
  layout = parse_layout(text.substr(3, text.find('\n') - 3));
  cells_ = noted(text, "cells");
  const std::size_t of_a_clock = noted(text, "planes"), fit = device.local_bytes / (4 * group);
  // Registers first, then local memory, as far as it goes.
  const std::size_t local =
      std::min(of_a_clock - std::min(of_a_clock, planes_in_registers), fit - fit / 32);
  const std::string options =
      fmt::format("-DCOSIM_LOCAL={}{}", local, device.is_nvidia ? " -DLOP3" : "");
  const fs::path kept =
      folder / (hash_of(text + options + device.name + device.version) + ".clbin");
  Device::Object program;
  if (fs::exists(kept)) {
    program = device.program(read_file(kept.string()));
  } else {
    program = device.program(text, options);
    write_file(kept.string(), Device::binary_of(program));
  }
  begin_ = Device::kernel(program, "begin");
  run_ = Device::kernel(program, "run");
  threads = device.units * (device.is_gpu ? 1536 : 64);
  lanes = static_cast<int>(32 * threads);
  planes_ = device.buffer(4 * threads * layout.planes.size());
  found_ = device.buffer(4 * threads);
  left_out_ = device.buffer(4 * threads * std::max<std::size_t>(layout.counters, 1));
  about = fmt::format(
      "{}: {} lanes; a clock has {} cells and {} planes, {} of them in local memory, {} in "
      "registers",
      device.name, lanes, cells_, of_a_clock, local, of_a_clock - local);
}

std::string Gpu::speed() const {
  const double rate = static_cast<double>(clocks_) / std::max(seconds_, 1e-9);
  std::string text = fmt::format("{}: {:.3g} clocks a second, without the host", device.name, rate);
  if (!device.is_nvidia) return text;
  // A multiprocessor runs 64 of these instructions at once, each on 32 lanes.
  const double limit = 32 * 64e6 * device.units * device.megahertz;
  return text + fmt::format(", {:.3g} cells: {:.0f} % of its limit of {:.2g}",
                            rate * static_cast<double>(cells_),
                            100 * rate * static_cast<double>(cells_) / limit, limit);
}

GpuPlayer::GpuPlayer(Gpu& gpu, const AnyBench&)
    : gpu_(gpu), alone_(gpu.busy_), left_out_(gpu.layout.counters) {}

std::size_t GpuPlayer::threads() const {
  const std::size_t lanes = 32 * Gpu::group;
  return (at_work_ + lanes - 1) / lanes * Gpu::group;
}

void GpuPlayer::begin(std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
  at_work_ = count;
  clock_ = 0;
  std::fill(left_out_.begin(), left_out_.end(), 0);
  gpu_.device.run(gpu_.begin_, threads(), Gpu::group, gpu_.planes_,
                  static_cast<std::uint32_t>(gpu_.threads), seed, first);
  std::vector<std::uint32_t> word(1);
  for (const auto& planes : gpu_.layout.registers) {
    for (const std::size_t plane : planes) {
      if (plane == Layout::none) continue;
      gpu_.device.read(gpu_.planes_, word, plane * gpu_.threads);
      if (word[0] == 0 || word[0] == ~std::uint32_t{0}) continue;
      throw InputError(
          "--lanes gpu: the reset does not reach every register; --lanes auto takes their values "
          "from a Verilated instance of each case");
    }
  }
}

std::optional<Player::Differs> GpuPlayer::run(std::uint64_t to) {
  if (clock_ >= to || at_work_ == 0) return {};
  const auto began = std::chrono::steady_clock::now();
  gpu_.device.run(gpu_.run_, threads(), Gpu::group, gpu_.planes_,
                  static_cast<std::uint32_t>(gpu_.threads), static_cast<std::uint32_t>(clock_),
                  static_cast<std::uint32_t>(to), at_work_, gpu_.found_, gpu_.left_out_);
  gpu_.seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  gpu_.clocks_ += at_work_ * (to - clock_);
  clock_ = to;
  std::vector<std::uint32_t> words(threads());
  for (std::size_t i = 0; i < left_out_.size(); ++i) {
    gpu_.device.read(gpu_.left_out_, words, i * gpu_.threads);
    for (const std::uint32_t word : words) left_out_[i] += word;
  }
  gpu_.device.read(gpu_.found_, words);
  const auto found = std::ranges::find_if(words, [](auto w) { return w != nothing_found; });
  if (found == words.end()) return {};
  const auto thread = static_cast<std::size_t>(found - words.begin());
  return Player::Differs{32 * thread + *found % 32, *found / 32};
}

}  // namespace cosim::lanes
