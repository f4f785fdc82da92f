// Work on several threads.
#pragma once

#include <cstdint>
#include <functional>

namespace cosim {

/// How many threads this computer runs at once, >= 1.
unsigned cores();

/// Calls work(0), ..., work(count - 1) on `threads` threads, the calling one among them, and
/// returns when all have ended. No call begins after one that returned false or threw; the first
/// exception is thrown on.
void in_parallel(std::uint64_t count, unsigned threads,
                 const std::function<bool(std::uint64_t)>& work);

}  // namespace cosim
