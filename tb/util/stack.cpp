#include "tb/util/stack.h"

#include <pthread.h>
#include <sys/resource.h>

#include <algorithm>

namespace cosim {

void allow_large_records() {
  constexpr rlim_t kBytes = rlim_t{64} << 20U;
  rlimit now{};
  if (getrlimit(RLIMIT_STACK, &now) != 0) return;
  const rlim_t bytes = std::min(kBytes, now.rlim_max);
  if (now.rlim_cur < bytes) {  // of the first thread; the programs that it starts have it too
    now.rlim_cur = bytes;
    setrlimit(RLIMIT_STACK, &now);
  }
  pthread_attr_t of_others;
  pthread_attr_init(&of_others);
  pthread_attr_setstacksize(&of_others, bytes);
  pthread_setattr_default_np(&of_others);
  pthread_attr_destroy(&of_others);
}

}  // namespace cosim
