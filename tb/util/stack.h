// Room on the stack.
#pragma once

namespace cosim {

/// Gives this thread and those to come 64 MB of stack, as far as the system allows: the tables of a
/// design with memories of thousands of words take more than the usual 8. To be called before
/// another thread is there.
void allow_large_records();

}  // namespace cosim
