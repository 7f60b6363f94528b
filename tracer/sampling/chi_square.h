// Quantiles of the chi-square distribution: how much the spread of few samples may deceive.
#pragma once

namespace durer {

// The value that a chi-square variable with `degrees` > 0 degrees of freedom exceeds with
// probability `confidence`, 0 < confidence < 1.
double chi_square_upper_quantile(int degrees, double confidence);

}  // namespace durer
