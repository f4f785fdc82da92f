#include "tb/util/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace cosim {

unsigned cores() { return std::max(1U, std::thread::hardware_concurrency()); }

void in_parallel(std::uint64_t count, unsigned threads,
                 const std::function<bool(std::uint64_t)>& work) {
  std::atomic<std::uint64_t> next{0};
  std::atomic<bool> stopped{false};
  std::mutex guard;
  std::exception_ptr error;
  const auto run = [&] {
    try {
      for (std::uint64_t i = 0; !stopped && (i = next++) < count;) {
        if (!work(i)) stopped = true;
      }
    } catch (...) {
      const std::scoped_lock lock(guard);
      if (!error) error = std::current_exception();
      stopped = true;
    }
  };
  {
    std::vector<std::jthread> others;
    for (unsigned t = 1; t < threads; ++t) others.emplace_back(run);
    run();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace cosim
