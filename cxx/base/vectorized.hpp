#pragma once
// Compiled for several instruction sets, the one of the processor is taken when the program starts.

/// Before a function whose loops are worth it: AVX2 with fused multiply-add, AVX-512, and what every x86-64 has. Nothing on
/// other compilers and processors. Results differ by rounding between processors, as those of the BLAS do.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define BURNISH_VECTORIZED                                                                                             \
  __attribute__((optimize("O3"), target_clones("arch=skylake-avx512", "arch=haswell", "default")))
#else
#define BURNISH_VECTORIZED
#endif
