// Integers of 128 bits, for products and sums that 64 bits do not hold.
#pragma once

namespace cosim {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Uint128;

}  // namespace cosim
