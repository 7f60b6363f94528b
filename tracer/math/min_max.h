// The smaller and the larger of two numbers, one instruction each: of the conditional expression g++ 12
// makes a detour through the integer registers. The second where one is NaN.
#pragma once

#include <emmintrin.h>

namespace durer {

[[gnu::always_inline]] inline double smaller_of(double a, double b) {
  return _mm_cvtsd_f64(_mm_min_sd(_mm_set_sd(a), _mm_set_sd(b)));
}
[[gnu::always_inline]] inline double larger_of(double a, double b) {
  return _mm_cvtsd_f64(_mm_max_sd(_mm_set_sd(a), _mm_set_sd(b)));
}

}  // namespace durer
