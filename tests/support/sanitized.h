// What a build for the sanitizers cannot be held to: it is several times slower, and its memory is
// not the program's alone. One that counts its lines is slow as well.
#pragma once

namespace cosim::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#ifdef COSIM_COUNTED
inline constexpr bool slow = true;
#else
inline constexpr bool slow = sanitized;
#endif

/// Bytes: 256 MiB of what was freed are kept back, and all has a shadow.
inline constexpr long kept_back = sanitized ? 400'000'000 : 0;

}  // namespace cosim::test
