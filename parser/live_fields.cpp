#include "parser/live_fields.h"

#include <mutex>
#include <optional>

#include "tracer/patterns/pattern.h"
#include "tracer/scene/not_supported.h"
#include "tracer/texture/surface_texture.h"
#include "tracer/world/pattern_services.h"

namespace durer {
namespace {

// One compiled form per noise generator, while the scene is read and afterwards.
template <typename Node, typename Compiled>
class CompiledByState {
 public:
  using Compile = std::shared_ptr<const Compiled> (*)(const Node&, const TextureSettings&);

  CompiledByState(std::shared_ptr<const Node> node, std::shared_ptr<const FieldSettings> live,
                  const GlobalSettings& globals, int effective_version, Compile compile)
      : node_(std::move(node)),
        live_(std::move(live)),
        globals_(globals),
        effective_version_(effective_version),
        compile_(compile) {
    form();
  }

  const Compiled& now() const {
    const Form& found = form();
    if (!found.compiled) throw NotSupported(*found.missing);
    return *found.compiled;
  }

 private:
  struct Form {
    std::once_flag once;
    std::shared_ptr<const Compiled> compiled;
    std::optional<NotSupported> missing;
  };

  const Form& form() const {
    Form& form = forms_[live_->noise_generator - 1 + (live_->frozen ? 3 : 0)];
    std::call_once(form.once, [&] {
      TextureSettings settings;
      settings.patterns.noise_generator = live_->noise_generator;
      settings.patterns.number_of_waves = live_->number_of_waves;
      settings.effective_version = effective_version_;
      const WorldPatternServices services(settings, globals_);
      try {
        form.compiled = compile_(*node_, services.settings());
      } catch (const NotSupported& what) {
        form.missing = what;
      }
    });
    return form;
  }

  std::shared_ptr<const Node> node_;
  std::shared_ptr<const FieldSettings> live_;
  GlobalSettings globals_;
  int effective_version_;
  Compile compile_;
  mutable Form forms_[6];
};

class LivePattern : public ScalarField {
 public:
  LivePattern(std::shared_ptr<const PatternNode> node, std::shared_ptr<const FieldSettings> live,
              const GlobalSettings& globals, int effective_version)
      : forms_(std::move(node), std::move(live), globals, effective_version,
               [](const PatternNode& pattern,
                  const TextureSettings& settings) -> std::shared_ptr<const ScalarField> {
                 return std::make_shared<Pattern>(pattern, settings.patterns);
               }) {}

  double value(const Vec3& p) const override { return forms_.now().value(p); }
  void values(const Vec3 points[8], double out[8]) const override {
    forms_.now().values(points, out);
  }
  ValueRange range(const Bounds& box) const override { return forms_.now().range(box); }
  Vec3 gradient(const Vec3& p) const override { return forms_.now().gradient(p); }

 private:
  CompiledByState<PatternNode, ScalarField> forms_;
};

class LivePigment : public ColorField {
 public:
  LivePigment(std::shared_ptr<const PigmentNode> node, std::shared_ptr<const FieldSettings> live,
              const GlobalSettings& globals, int effective_version)
      : forms_(std::move(node), std::move(live), globals, effective_version,
               [](const PigmentNode& pigment, const TextureSettings& settings)
                   -> std::shared_ptr<const CompiledPigment> {
                 return compile_pigment(pigment, settings);
               }) {}

  bool color(const Vec3& p, const PatternContext* context, ColorRGBFT& color) const override {
    return forms_.now().evaluate(p, context ? *context : PatternContext{}, color);
  }

 private:
  CompiledByState<PigmentNode, CompiledPigment> forms_;
};

}  // namespace

std::shared_ptr<const ScalarField> make_live_pattern(std::shared_ptr<const PatternNode> pattern,
                                                     std::shared_ptr<const FieldSettings> live,
                                                     const GlobalSettings& globals,
                                                     int effective_version) {
  return std::make_shared<LivePattern>(std::move(pattern), std::move(live), globals,
                                       effective_version);
}

std::shared_ptr<const ColorField> make_live_pigment(std::shared_ptr<const PigmentNode> pigment,
                                                    std::shared_ptr<const FieldSettings> live,
                                                    const GlobalSettings& globals,
                                                    int effective_version) {
  return std::make_shared<LivePigment>(std::move(pigment), std::move(live), globals,
                                       effective_version);
}

}  // namespace durer
