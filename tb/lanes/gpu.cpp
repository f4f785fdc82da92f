#include "tb/lanes/gpu.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/util/hash.h"
#include "tb/util/output_file.h"
#include "tb/util/read_file.h"

namespace cosim::lanes {

Gpu::Gpu(const std::filesystem::path& folder, const std::string& key,
         const std::function<Code()>& code) {
  const std::string file = (folder / (hash_of(key + device_.version) + ".clbin")).string();
  const bool is_kept = std::filesystem::exists(file);
  // The first line, and the source or its binary.
  const std::string text = is_kept ? read_file(file) : to_opencl(code(), device_);
  const std::size_t line = text.find('\n') + 1;
  const Device::Object program = device_.program(text.substr(line), is_kept);
  if (!is_kept) {
    make_folder(folder.string());
    write_file(file, text.substr(0, line) + Device::binary_of(program));
  }
  begin_ = Device::kernel(program, "begin");
  run_ = Device::kernel(program, "run");
  std::istringstream numbers(text.substr(2, line - 2));
  std::size_t planes = 0, local = 0;
  numbers >> cells_ >> planes >> local;
  layout_ = parse_layout({std::istreambuf_iterator<char>(numbers), {}});
  planes_ = device_.buffer(4 * device_.threads * layout_.planes.size());
  found_ = device_.buffer(4 * device_.threads);
  left_out_ = device_.buffer(4 * device_.threads * std::max<std::size_t>(layout_.counters, 1));
  lanes = 32 * device_.threads;
  fmt::print(
      "{}: {} lanes; a clock has {} cells and {} planes, {} of them in local memory, {} in "
      "registers\n",
      device_.name, lanes, cells_, planes, local, planes - local);
}

Gpu::~Gpu() {
  const double rate = static_cast<double>(clocks_) / std::max(seconds_, 1e-9);
  const double cells = rate * static_cast<double>(cells_), most = device_.lop3_limit;
  fmt::print("{}: {:.3g} clocks a second, without the host", device_.name, rate);
  if (device_.is_nvidia) {
    fmt::print(", {:.3g} cells: {:.0f} % of its limit of {:.2g}", cells, 100 * cells / most, most);
  }
  fmt::print("\n");
}

Outcome Gpu::play(std::uint64_t seed, std::uint64_t first, const std::vector<Part>& parts) {
  const std::lock_guard alone(busy_);
  std::uint64_t at_work = parts.front().lanes;
  std::uint32_t clock = 0;
  constexpr std::size_t group = Device::group;
  const auto threads = [&] { return (at_work + 32 * group - 1) / (32 * group) * group; };
  device_.run(begin_, threads(), {planes_.get(), device_.threads, seed, first});
  std::vector<std::uint32_t> words(1);
  for (const auto& planes : layout_.registers) {
    for (const std::size_t plane : planes) {
      if (plane != Layout::none) device_.read(planes_, words, plane * device_.threads);
      if (words[0] != 0 && words[0] != ~0U) {
        throw InputError(
            "--lanes gpu: the reset does not reach every "
            "register; --lanes auto takes their values "
            "from a Verilated instance of each case");
      }
    }
  }
  Outcome outcome{{}, std::vector<std::uint64_t>(layout_.counters)};
  for (const Part& part : parts) {
    at_work = std::min(at_work, part.lanes);
    if (clock >= part.to || at_work == 0) continue;
    const auto to = static_cast<std::uint32_t>(part.to);
    const auto began = std::chrono::steady_clock::now();
    device_.run(
        run_, threads(),
        {planes_.get(), device_.threads, clock, to, at_work, found_.get(), left_out_.get()});
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    clocks_ += at_work * (to - clock);
    clock = to;
    words.resize(threads());
    for (std::size_t i = 0; i < layout_.counters; ++i) {
      device_.read(left_out_, words, i * device_.threads);
      for (const std::uint32_t word : words) outcome.left_out[i] += word;
    }
    device_.read(found_, words);
    const auto found = std::ranges::find_if(words, [](auto w) { return w != ~0U; });
    if (found == words.end()) continue;
    at_work = 32 * static_cast<std::uint64_t>(found - words.begin()) + *found % 32;
    outcome.differs = {at_work, *found / 32};
  }
  return outcome;
}

}  // namespace cosim::lanes
