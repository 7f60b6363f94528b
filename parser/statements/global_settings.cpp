// global_settings{} (spec/language.md 26).
#include <algorithm>
#include <cmath>

#include "parser/parser.h"
#include "parser/statements/textures.h"
#include "tracer/scene/scene.h"

namespace durer {
namespace {

class SettingsReader {
 public:
  explicit SettingsReader(Parser& parser)
      : parser_(parser), settings_(parser.scene().settings) {}

  bool accept_item() {
    if (parser_.accept(Keyword::adc_bailout)) {
      settings_.adc_bailout = parser_.parse_float();
    } else if (parser_.accept(Keyword::ambient_light)) {
      settings_.ambient_light = parser_.parse_rgb();
    } else if (parser_.accept(Keyword::assumed_gamma)) {
      parse_assumed_gamma();
    } else if (parser_.accept(Keyword::charset)) {
      parse_charset();
    } else if (parser_.accept(Keyword::hf_gray_16)) {
      parser_.parse_optional_switch();
      parser_.possible_error("hf_gray_16 has no effect any more; ask for +FNg or Grayscale_Output");
    } else if (parser_.accept(Keyword::irid_wavelength)) {
      settings_.irid_wavelength = parser_.parse_rgb();
    } else if (parser_.accept(Keyword::max_trace_level)) {
      const int level = parser_.parse_int();
      settings_.max_trace_level = std::clamp(level, 1, 256);
      if (level > 256) parser_.warning("max_trace_level is limited to 256");
    } else if (parser_.accept(Keyword::max_intersections)) {
      parser_.parse_float();
      if (parser_.language_version() >= 370) {
        parser_.warning("max_intersections has no effect any more");
      }
    } else if (parser_.accept(Keyword::mm_per_unit)) {
      settings_.mm_per_unit = parser_.parse_float();
    } else if (parser_.accept(Keyword::noise_generator)) {
      const int generator = parser_.parse_int();
      if (generator < 1 || generator > 3) parser_.error("noise_generator is 1, 2 or 3");
      settings_.noise_generator = generator;
      settings_.noise_generator_given = true;
      parser_.follow_noise_generator();
    } else if (parser_.accept(Keyword::number_of_waves)) {
      settings_.number_of_waves = parser_.parse_int();
      if (settings_.number_of_waves <= 0) {
        parser_.warning("number_of_waves must be positive; 1 is used");
        settings_.number_of_waves = 1;
      }
    } else if (parser_.accept(Keyword::subsurface)) {
      parse_subsurface();
    } else if (parser_.accept(Keyword::photons)) {
      parse_photons();
    } else if (parser_.accept(Keyword::radiosity)) {
      parse_radiosity();
    } else {
      return false;
    }
    return true;
  }

 private:
  void parse_assumed_gamma() {
    const bool first = settings_.gamma_kind == AssumedGamma::none;
    AssumedGamma kind = AssumedGamma::srgb;
    double gamma = 1;
    if (!parser_.accept(Keyword::srgb)) {
      gamma = parser_.parse_float();
      if (!(gamma > 0)) parser_.error("assumed_gamma must be positive");
      if (gamma < 1) parser_.possible_error("an assumed_gamma below 1 is unusual");
      kind = AssumedGamma::power;
    }
    if (!first) {
      parser_.warning("assumed_gamma was given before; only the first one counts");
      return;
    }
    settings_.gamma_kind = kind;
    settings_.assumed_gamma = gamma;
    parser_.note_assumed_gamma();
  }

  void parse_charset() {
    if (parser_.accept(Keyword::utf8)) {
      parser_.set_utf8(true);
    } else if (parser_.accept(Keyword::ascii)) {
      parser_.set_utf8(false);
    } else if (parser_.accept(Keyword::sys)) {
      parser_.set_system_charset();
    } else {
      parser_.error_expected("ascii, utf8 or sys");
    }
  }

  void parse_subsurface() {
    settings_.subsurface = true;
    settings_.subsurface_position = parser_.position();
    parser_.expect_open("subsurface");
    for (;;) {
      if (parser_.accept(Keyword::samples)) {
        settings_.subsurface_samples_diffuse = parser_.parse_int();
        parser_.accept_comma();
        settings_.subsurface_samples_single = parser_.parse_int();
      } else if (parser_.accept(Keyword::radiosity)) {
        settings_.subsurface_radiosity = parser_.parse_float() > 0;
      } else {
        break;
      }
    }
    parser_.expect_close("subsurface");
  }

  void parse_photons() {
    PhotonGlobals& photons = settings_.photons = PhotonGlobals{};
    photons.enabled = true;
    photons.position = parser_.position();
    parser_.expect_open("photons");
    for (;;) {
      if (parser_.accept(Keyword::spacing)) {
        photons.spacing = parser_.parse_float();
      } else if (parser_.accept(Keyword::count)) {
        photons.count = parser_.parse_int();
      } else if (parser_.accept(Keyword::gather)) {
        photons.gather_min = parser_.parse_int();
        parser_.accept_comma();
        photons.gather_max = parser_.parse_int();
      } else if (parser_.accept(Keyword::media)) {
        photons.media_max_steps = parser_.parse_int();
        parser_.accept_comma();
        photons.media_spacing_factor = parser_.parse_optional_float(1);
        require(photons.media_max_steps >= 0, "the steps of media photons must not be negative");
        require(photons.media_spacing_factor > 0, "the factor of media photons must be positive");
      } else if (parser_.accept(Keyword::jitter)) {
        photons.jitter = parser_.parse_float();
      } else if (parser_.accept(Keyword::max_trace_level)) {
        photons.max_trace_level = parser_.parse_int();
      } else if (parser_.accept(Keyword::adc_bailout)) {
        photons.adc_bailout = parser_.parse_float();
      } else if (parser_.accept(Keyword::autostop)) {
        photons.autostop = parser_.parse_float();
      } else if (parser_.accept(Keyword::expand_thresholds)) {
        photons.expand_increase = std::max(0.0, parser_.parse_float());
        parser_.accept_comma();
        photons.expand_min = std::max(0, parser_.parse_int());
      } else if (parser_.accept(Keyword::radius)) {
        photons.radius = {-1, 1, -1, 1};
        for (int i = 0; i < 4; ++i) {
          if (i > 0 && !parser_.accept_comma()) break;
          if (parser_.at_expression()) photons.radius[i] = parser_.parse_float();
        }
      } else if (parser_.accept(Keyword::save_file)) {
        photons.save_file = parser_.parse_path_string();
        photons.load_file.clear();
      } else if (parser_.accept(Keyword::load_file)) {
        photons.load_file = parser_.parse_path_string();
        photons.save_file.clear();
      } else {
        break;
      }
    }
    parser_.expect_close("photons");
    if (photons.gather_max <= 0) photons.enabled = false;
    if (photons.enabled) {
      require(photons.gather_min >= 0, "gather counts must not be negative");
      require(photons.gather_min <= photons.gather_max,
              "the first gather count must not exceed the second");
    }
  }

  void require(bool condition, const char* text) {
    if (!condition) parser_.error(text);
  }

  double positive(const char* what) {
    const double value = parser_.parse_float();
    if (!(value > 0)) parser_.error(std::string(what) + " must be positive");
    return value;
  }

  double within(double low, double high, const char* what) {
    const double value = parser_.parse_float();
    if (!(value >= low && value <= high)) {
      parser_.error(std::string(what) + " is out of its range");
    }
    return value;
  }

  void parse_radiosity() {
    RadiositySettings& radiosity = settings_.radiosity;
    radiosity.enabled = true;
    radiosity.position = parser_.position();
    parser_.expect_open("radiosity");
    bool minimum_given = false, maximum_given = false;
    for (;;) {
      if (parser_.accept(Keyword::adc_bailout)) {
        radiosity.adc_bailout = positive("adc_bailout");
      } else if (parser_.accept(Keyword::always_sample)) {
        radiosity.always_sample = parser_.parse_int() != 0;
      } else if (parser_.accept(Keyword::brightness)) {
        radiosity.brightness = positive("brightness");
      } else if (parser_.accept(Keyword::count)) {
        radiosity.count = parser_.parse_int();
        require(radiosity.count > 0, "count must be positive");
        radiosity.direction_pool = std::max(1600, radiosity.count);
        if (parser_.accept_comma() || parser_.at_expression()) {
          radiosity.direction_pool = parser_.parse_int();
          require(radiosity.direction_pool >= radiosity.count,
                  "the pool of directions must not be smaller than count");
        }
      } else if (parser_.accept(Keyword::error_bound)) {
        radiosity.error_bound = positive("error_bound");
      } else if (parser_.accept(Keyword::gray_threshold)) {
        radiosity.gray_threshold = within(0, 1, "gray_threshold");
      } else if (parser_.accept(Keyword::low_error_factor)) {
        radiosity.low_error_factor = positive("low_error_factor");
      } else if (parser_.accept(Keyword::max_sample)) {
        radiosity.max_sample = parser_.parse_float();
      } else if (parser_.accept(Keyword::maximum_reuse)) {
        radiosity.maximum_reuse = positive("maximum_reuse");
        maximum_given = true;
      } else if (parser_.accept(Keyword::minimum_reuse)) {
        radiosity.minimum_reuse = within(0, 1e300, "minimum_reuse");
        minimum_given = true;
      } else if (parser_.accept(Keyword::nearest_count)) {
        radiosity.nearest_count = static_cast<int>(within(1, 20, "nearest_count"));
        radiosity.adaptive_nearest_count = 0;
        if (parser_.accept_comma() || parser_.at_expression()) {
          radiosity.adaptive_nearest_count = parser_.parse_int();
          require(radiosity.adaptive_nearest_count >= 0 &&
                      radiosity.adaptive_nearest_count < radiosity.nearest_count,
                  "the second nearest_count must be less than the first");
        }
      } else if (parser_.accept(Keyword::pretrace_start)) {
        radiosity.pretrace_start = within(1e-300, 1, "pretrace_start");
      } else if (parser_.accept(Keyword::pretrace_end)) {
        radiosity.pretrace_end = within(1e-300, 1, "pretrace_end");
      } else if (parser_.accept(Keyword::recursion_limit)) {
        radiosity.recursion_limit = static_cast<int>(within(1, 20.999, "recursion_limit"));
      } else if (parser_.accept(Keyword::normal)) {
        radiosity.normal = parser_.parse_float() > 0;
      } else if (parser_.accept(Keyword::media)) {
        radiosity.media = parser_.parse_float() > 0;
      } else if (parser_.accept(Keyword::subsurface)) {
        radiosity.subsurface = parser_.parse_optional_switch();
      } else if (parser_.accept(Keyword::load_file) || parser_.accept(Keyword::save_file)) {
        parser_.parse_path_string();
        parser_.possible_error("files of radiosity are named by the render options");
      } else {
        break;
      }
    }
    parser_.expect_close("radiosity");
    require(radiosity.pretrace_end <= radiosity.pretrace_start,
            "pretrace_end must not be greater than pretrace_start");
    fit_reuse(radiosity, minimum_given, maximum_given);
  }

  void fit_reuse(RadiositySettings& radiosity, bool minimum_given, bool maximum_given) {
    if (radiosity.minimum_reuse <= radiosity.maximum_reuse / 2) return;
    if (!minimum_given) {
      radiosity.minimum_reuse = radiosity.maximum_reuse / 2;
      parser_.warning("minimum_reuse is lowered to half of maximum_reuse");
    } else if (!maximum_given) {
      radiosity.maximum_reuse = 2 * radiosity.minimum_reuse;
      parser_.warning("maximum_reuse is raised to twice minimum_reuse");
    } else {
      require(radiosity.minimum_reuse < radiosity.maximum_reuse,
              "minimum_reuse must be less than maximum_reuse");
      parser_.warning("minimum_reuse should be at most half of maximum_reuse");
    }
  }

  Parser& parser_;
  GlobalSettings& settings_;
};

}  // namespace

void parse_global_settings(Parser& parser) {
  parser.expect_open("global_settings");
  SettingsReader reader(parser);
  while (reader.accept_item()) {
  }
  parser.expect_close("global_settings");
}

}  // namespace durer
