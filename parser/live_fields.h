// Patterns and pigments inside function{ }: they follow the noise generator in force.
#pragma once

#include <memory>

#include "tracer/field/field_settings.h"
#include "tracer/field/scalar_field.h"
#include "tracer/patterns/color_field.h"
#include "tracer/scene/scene.h"

namespace durer {

// Compiled for each state of `live` when it is first asked in that state; the state at the call is
// compiled at once. What cannot be rendered yet throws NotSupported at each evaluation, not here.
// Throws std::runtime_error for files that cannot be read.
std::shared_ptr<const ScalarField> make_live_pattern(std::shared_ptr<const PatternNode> pattern,
                                                     std::shared_ptr<const FieldSettings> live,
                                                     const GlobalSettings& globals,
                                                     int effective_version);
std::shared_ptr<const ColorField> make_live_pigment(std::shared_ptr<const PigmentNode> pigment,
                                                    std::shared_ptr<const FieldSettings> live,
                                                    const GlobalSettings& globals,
                                                    int effective_version);

}  // namespace durer
