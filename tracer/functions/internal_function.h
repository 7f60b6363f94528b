// What the tape builder tells internal functions.
#pragma once

#include "tracer/functions/compiled_function.h"

namespace durer {

// A call with constant H and lacunarity has been read: the first such call fixes the weights of
// f_ridged_mf for the picture unless the parser evaluates one before (spec/functions.md 4.5).
void remember_fractal_use(const CompiledFunction& function, double h, double lacunarity);

}  // namespace durer
