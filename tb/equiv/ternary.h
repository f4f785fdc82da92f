// Differences that do not depend on what memories hold.
#pragma once

#include "tb/equiv/product.h"

namespace cosim::equiv {

/// The product of RTLs whose memories are cut, with what they read as x: `bad` is that an output
/// differs whatever they read, `any` the bits of which that is not known in one of both.
/// A stimulus for it is one for the RTLs as they are. The inputs have the same numbers.
Product whatever_is_free(const Product& product);

}  // namespace cosim::equiv
