// Marks of functions in which most of the time goes.
#pragma once

// A kernel is compiled for plain x86-64 and for AVX2, and chosen when the program starts: the same
// expressions in the same order give the same bits. Sanitizers cannot run that choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define DURER_KERNEL __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define DURER_KERNEL
#endif
#define DURER_INLINE [[gnu::always_inline]] inline
