// Built-in constants, float functions and vector functions (spec/language.md 7-9, 11).
#include <chrono>
#include <cmath>

#include "parser/builtin_formulas.h"
#include "parser/parser_state.h"
#include "tracer/scene/object.h"

namespace durer {
namespace {

double days_since_2000() {
  using std::chrono::microseconds;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const double seconds =
      static_cast<double>(std::chrono::duration_cast<microseconds>(now).count()) * 1e-6;
  return seconds / 86400.0 - 10957.0;
}

}  // namespace

bool Parser::State::is_builtin(Keyword keyword) {
  switch (keyword) {
    case Keyword::abs: case Keyword::acos: case Keyword::acosh: case Keyword::asc:
    case Keyword::asin: case Keyword::asinh: case Keyword::atan: case Keyword::atan2:
    case Keyword::atanh: case Keyword::bitwise_and: case Keyword::bitwise_or:
    case Keyword::bitwise_xor: case Keyword::ceil: case Keyword::cos: case Keyword::cosh:
    case Keyword::defined: case Keyword::degrees: case Keyword::dimension_size:
    case Keyword::dimensions: case Keyword::div: case Keyword::exp: case Keyword::file_exists:
    case Keyword::floor: case Keyword::inside: case Keyword::int_: case Keyword::ln:
    case Keyword::log: case Keyword::max: case Keyword::min: case Keyword::mod: case Keyword::pow:
    case Keyword::radians: case Keyword::rand: case Keyword::seed: case Keyword::select:
    case Keyword::sin: case Keyword::sinh: case Keyword::sqrt: case Keyword::strcmp:
    case Keyword::strlen: case Keyword::tan: case Keyword::tanh: case Keyword::val:
    case Keyword::vdot: case Keyword::vlength: case Keyword::clock: case Keyword::clock_on:
    case Keyword::false_: case Keyword::no: case Keyword::now: case Keyword::off: case Keyword::on:
    case Keyword::pi: case Keyword::true_: case Keyword::version: case Keyword::yes:
    case Keyword::max_extent: case Keyword::min_extent: case Keyword::trace:
    case Keyword::vaxis_rotate: case Keyword::vcross: case Keyword::vnormalize:
    case Keyword::vrotate: case Keyword::vturbulence: case Keyword::t: case Keyword::u:
    case Keyword::v: case Keyword::x: case Keyword::y: case Keyword::z:
      return true;
    default:
      return false;
  }
}

double Parser::State::new_random_stream(double seed) {
  random_streams.push_back(static_cast<uint32_t>(to_int(seed)));
  return static_cast<double>(random_streams.size() - 1);
}

double Parser::State::next_random(double stream) {
  const int32_t index = to_int(stream);
  if (index < 0 || static_cast<size_t>(index) >= random_streams.size()) {
    error("rand() needs a stream that seed() has made");
  }
  uint32_t& state = random_streams[static_cast<size_t>(index)];
  state = state * 1812433253u + 12345u;
  return state / 4294967295.0;
}

bool Parser::State::parse_builtin(Keyword keyword, Terms& out, int width) {
  const NestingScope deeper(*this);
  const auto number = [&](double value) {
    out.set_float(value, width);
    return true;
  };
  const auto vector = [&](const Vec3& value) {
    out.v[0] = value.x, out.v[1] = value.y, out.v[2] = value.z;
    out.count = 3;
    out.promote(width);
    return true;
  };
  // ( express )
  const auto one = [&] {
    consume();
    expect(Symbol::paren_open);
    const double value = parse_float_express();
    expect(Symbol::paren_close);
    return value;
  };
  const auto open = [&] {
    consume();
    expect(Symbol::paren_open);
  };
  // ( sum , sum )
  double first = 0, second = 0;
  const auto two = [&] {
    open();
    first = parse_float();
    accept_comma();
    second = parse_float();
    expect(Symbol::paren_close);
  };
  Vec3 a{0}, b{0};
  const auto two_vectors = [&] {
    open();
    a = parse_vector();
    accept_comma();
    b = parse_vector();
    expect(Symbol::paren_close);
  };
  // ( sum {, sum} ): the commas are required here.
  const auto fold = [&](auto combine, auto convert) {
    open();
    auto result = convert(parse_float());
    while (accept_comma()) result = combine(result, convert(parse_float()));
    expect(Symbol::paren_close);
    return static_cast<double>(result);
  };
  const auto same = [](double value) { return value; };

  switch (keyword) {
    // Values
    case Keyword::x: consume(); return vector({1, 0, 0});
    case Keyword::y: consume(); return vector({0, 1, 0});
    case Keyword::z: consume(); return vector({0, 0, 1});
    case Keyword::u: consume(); out.v[0] = 1, out.v[1] = 0, out.count = 2; return true;
    case Keyword::v: consume(); out.v[0] = 0, out.v[1] = 1, out.count = 2; return true;
    case Keyword::t:
      consume();
      out.v[0] = out.v[1] = out.v[2] = 0, out.v[3] = 1, out.count = 4;
      return true;
    case Keyword::pi: consume(); return number(kPi);
    case Keyword::true_: case Keyword::yes: case Keyword::on: consume(); return number(1);
    case Keyword::false_: case Keyword::no: case Keyword::off: consume(); return number(0);
    case Keyword::clock: consume(); return number(static_cast<float>(options.clock));
    case Keyword::clock_on: consume(); return number(options.clock_given ? 1 : 0);
    case Keyword::version: consume(); return number(language_version / 100.0);
    case Keyword::now: consume(); return number(days_since_2000());

    // Float functions of one number
#define DURER_FUNCTION(name, formula) \
  case Keyword::name: {               \
    const double p = one();           \
    return number(formula);           \
  }
    DURER_FLOAT_FUNCTIONS(DURER_FUNCTION)
#undef DURER_FUNCTION
    case Keyword::acos:
    case Keyword::asin: {
      double value = one();
      if (!builtin::has_arc(value)) {
        message(Severity::warning, std::string("the argument of ") +
                                       (keyword == Keyword::acos ? "acos" : "asin") +
                                       " is outside -1..1 and was clamped");
        value = value > 1 ? 1 : -1;
      }
      return number(keyword == Keyword::acos ? std::acos(value) : std::asin(value));
    }
    case Keyword::sqrt: {
      const double value = one();
      if (!builtin::has_root(value)) error("sqrt of a negative number, " + std::to_string(value));
      return number(std::sqrt(value));
    }
    case Keyword::ln:
    case Keyword::log: {
      const double value = one();
      if (!builtin::has_logarithm(value)) {
        error(std::string(keyword == Keyword::ln ? "ln" : "log") + " of " + std::to_string(value) +
              ", which is not positive");
      }
      return number(keyword == Keyword::ln ? std::log(value) : std::log10(value));
    }
    case Keyword::rand: return number(next_random(one()));
    case Keyword::seed: return number(new_random_stream(one()));

    // Float functions of several numbers
    case Keyword::atan2:
      two();
      if (!builtin::has_direction(first, second)) {
        error("atan2(0, 0) is not defined");
      }
      return number(std::atan2(first, second));
    case Keyword::pow:
      two();
      if (!builtin::has_power(first, second)) error("pow(0, 0) is not defined");
      return number(std::pow(first, second));
#define DURER_FUNCTION(name, formula)         \
  case Keyword::name: {                       \
    two();                                    \
    const double p = first, q = second;       \
    return number(formula);                   \
  }
    DURER_FLOAT_PAIR_FUNCTIONS(DURER_FUNCTION)
#undef DURER_FUNCTION
#define DURER_FUNCTION(name, formula) \
  case Keyword::name:                 \
    return number(fold([](double p, double q) { return formula; }, same));
    DURER_FLOAT_FOLDS(DURER_FUNCTION)
#undef DURER_FUNCTION
    case Keyword::bitwise_and:
      return number(fold([](int32_t p, int32_t q) { return p & q; }, to_int));
    case Keyword::bitwise_or:
      return number(fold([](int32_t p, int32_t q) { return p | q; }, to_int));
    case Keyword::bitwise_xor:
      return number(fold([](int32_t p, int32_t q) { return p ^ q; }, to_int));
    case Keyword::select: {
      open();
      double argument[4];
      int count = 0;
      bool comma = true;
      while (count < 3 || (count == 3 && comma)) {
        argument[count++] = parse_float();
        if (count < 4) comma = accept_comma();
      }
      expect(Symbol::paren_close);
      return number(argument[builtin::selected(argument[0], count)]);
    }

    // About identifiers, arrays, strings
    case Keyword::defined:
      consume();
      return number(parse_defined() ? 1 : 0);
    case Keyword::dimensions:
    case Keyword::dimension_size: {
      open();
      peek();
      if (look.token.kind != TokenKind::identifier || !look.value ||
          look.value->kind() != ValueKind::array) {
        error_expected("the name of an array");
      }
      const ArrayShape shape = look.value->as<Array>().shape;
      consume();
      double result = shape.dimensions;
      if (keyword == Keyword::dimension_size) {
        accept_comma();
        result = builtin::dimension_size(shape, parse_float());
      }
      expect(Symbol::paren_close);
      return number(result);
    }
    case Keyword::strlen: {
      open();
      const double length = static_cast<double>(parse_string().size());
      expect(Symbol::paren_close);
      return number(length);
    }
    case Keyword::asc: {
      open();
      const std::u16string text = parse_string();
      expect(Symbol::paren_close);
      return number(text.empty() ? 0 : text[0]);
    }
    case Keyword::val: {
      open();
      const std::string text = to_bytes(parse_string());
      expect(Symbol::paren_close);
      return number(std::atof(text.c_str()));
    }
    case Keyword::strcmp: {
      open();
      const std::u16string left = parse_string();
      accept_comma();
      const std::u16string right = parse_string();
      expect(Symbol::paren_close);
      size_t i = 0;
      while (i < left.size() && i < right.size() && left[i] == right[i]) ++i;
      const int l = i < left.size() ? left[i] : 0, r = i < right.size() ? right[i] : 0;
      return number(l - r);
    }
    case Keyword::file_exists: {
      open();
      const std::string name = to_bytes(parse_string());
      expect(Symbol::paren_close);
      return number(path_exists(name) ? 1 : 0);
    }

    // Vectors
    case Keyword::vdot: two_vectors(); return number(dot(a, b));
    case Keyword::vlength: {
      open();
      a = parse_vector();
      expect(Symbol::paren_close);
      return number(builtin::vlength(a));
    }
    case Keyword::vcross: two_vectors(); return vector(cross(a, b));
    case Keyword::vnormalize: {
      open();
      a = parse_vector();
      expect(Symbol::paren_close);
      if (a == Vec3(0)) {
        if (language_version >= 350) {
          message(Severity::possible_error, "vnormalize of a vector of length zero");
        }
        return vector({0, 0, 0});
      }
      return vector(builtin::vnormalize(a));
    }
    case Keyword::vrotate: {
      two_vectors();
      return vector(builtin::vrotate(a, b));
    }
    case Keyword::vaxis_rotate: {
      open();
      a = parse_vector();
      accept_comma();
      b = parse_vector();
      accept_comma();
      const double degrees = parse_float();
      expect(Symbol::paren_close);
      return vector(builtin::vaxis_rotate(a, b, degrees));
    }
    case Keyword::vturbulence: {
      open();
      const double lambda = parse_float();
      accept_comma();
      const double omega = parse_float();
      accept_comma();
      const int octaves = std::min(10, std::max(1, to_int(parse_float())));
      accept_comma();
      a = parse_vector();
      expect(Symbol::paren_close);
      return vector(parser.queries().turbulence(a, lambda, omega, octaves,
                                                scene.settings.noise_generator));
    }

    // About objects
    case Keyword::inside: {
      open();
      const ObjectPtr object = parser.accept_identifier<ObjectNode>(ValueKind::object);
      if (!object) error_expected("the name of an object");
      const auto* csg = std::get_if<CsgNode>(&shape_of(*object));
      if (!(csg && csg->is_light_group) && !parser.queries().has_inside(object)) {
        error("inside() needs an object that has an inside");
      }
      accept_comma();
      a = parse_vector();
      expect(Symbol::paren_close);
      return number(parser.queries().inside(object, a) ? 1 : 0);
    }
    case Keyword::min_extent:
    case Keyword::max_extent: {
      open();
      // Without an argument it is no error, and says nothing.
      if (accept(Symbol::paren_close)) return vector({0, 0, 0});
      if (keyword == Keyword::max_extent && parser.at_identifier(ValueKind::pigment)) {
        const auto pigment = parser.accept_identifier<PigmentNode>(ValueKind::pigment);
        Vec2 size{0};
        if (!parser.queries().image_size(*pigment, size)) {
          error("max_extent of a pigment needs one that is an image_map");
        }
        expect(Symbol::paren_close);
        return vector({size.x, size.y, 0});
      }
      const ObjectPtr object = parser.accept_identifier<ObjectNode>(ValueKind::object);
      if (!object) error_expected("the name of an object");
      expect(Symbol::paren_close);
      const Bounds box = parser.queries().extents(object);
      return vector(keyword == Keyword::min_extent ? box.min : box.max);
    }
    case Keyword::trace: {
      open();
      const ObjectPtr object = parser.accept_identifier<ObjectNode>(ValueKind::object);
      if (!object) error_expected("the name of an object");
      accept_comma();
      a = parse_vector();
      accept_comma();
      b = parse_vector();
      Reference normal_at;
      if (accept_comma() || !peek().is(Symbol::paren_close)) {
        peek();
        if (look.token.kind != TokenKind::identifier || !look.value ||
            look.value->kind() != ValueKind::vector) {
          error_expected("the name of a vector that receives the normal");
        }
        normal_at = look.is_element      ? look.reference
                    : look.entry->alias ? *look.entry->alias
                                        : Reference{look.entry, 0, {}};
        consume();
      }
      expect(Symbol::paren_close);
      Vec3 point{0}, normal{0};
      const double length = std::sqrt(dot(b, b));
      if (length == 0 || !parser.queries().trace(object, a, b * (1 / length), point, normal)) {
        point = normal = Vec3(0);
      }
      if (normal_at.entry) {
        if (Value* slot = writable(normal_at)) *slot = Value(normal);
      }
      return vector(point);
    }
    default:
      return false;
  }
}

}  // namespace durer
