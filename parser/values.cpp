// Right-hand sides, arrays and splines (spec/language.md 12.3, 15, 21).
#include <algorithm>
#include <cmath>

#include "parser/parser_state.h"
#include "parser/statements/statements.h"
#include "tracer/math/spline.h"
#include "tracer/scene/function.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

}  // namespace

const char* kind_name(ValueKind kind) {
  static constexpr const char* kNames[] = {
      "value that was never set", "float", "uv vector", "vector", "4d vector", "colour", "string",
      "array", "spline", "function", "macro", "file", "object", "texture", "pigment", "normal",
      "finish", "material", "interior", "media", "density", "color_map", "pigment_map",
      "normal_map", "slope_map", "texture_map", "density_map", "transform", "camera", "fog",
      "rainbow", "sky_sphere"};
  return kNames[static_cast<int>(kind)];
}

Value Parser::State::to_value(const Terms& terms) {
  switch (terms.count) {
    case 1: return Value(terms.v[0]);
    case 2: return Value(Vec2(terms.v[0], terms.v[1]));
    case 3: return Value(Vec3(terms.v[0], terms.v[1], terms.v[2]));
    case 4: return Value(Vec4(terms.v[0], terms.v[1], terms.v[2], terms.v[3]));
    default:
      return Value(ColorRGBFT{static_cast<float>(terms.v[0]), static_cast<float>(terms.v[1]),
                              static_cast<float>(terms.v[2]), static_cast<float>(terms.v[3]),
                              static_cast<float>(terms.v[4])});
  }
}

// A number's name alone is what macros are called with most.
bool Parser::State::take_numeric_identifier(RightSide& result) {
  if (waiting_switches > 0 || !resolve_elements || language_version < 350) return false;
  const Token* const name = next_raw();
  if (!name || name->kind != TokenKind::identifier || frames.back().page_end - name < 2) {
    return false;
  }
  if (!name[1].is(Symbol::comma) && !name[1].is(Symbol::paren_close) &&
      !name[1].is(Symbol::semicolon)) {
    return false;
  }
  const Value* value = plain_value(name->name);
  if (!value || !value->is_numeric()) return false;
  Entry* const entry = symbols.find(name->name);
  if (entry->alias) {
    result.reference = *entry->alias;
  } else {
    result.reference.entry = entry;
  }
  result.value = *value;
  result.is_reference = true;
  result.numeric = true;
  pass_tokens(name, 1);
  return true;
}

// The caller has switched directives off; operands and blocks switch them on for themselves.
void Parser::State::parse_right_side(RightSide& result, const char* what) {
  const NestingScope deeper(*this);
  if (take_numeric_identifier(result)) return;
  if (language_version >= 350) {
    Terms terms;
    if (evaluate_compiled(terms, 1, ExpressionLevel::sum, Alone::reference)) {
      result.value = to_value(terms);
      result.numeric = true;
      return;
    }
  }
  // The first token is read live: a macro or directive may come before the value.
  {
    const FlagScope on(directives_live, true);
    peek();
  }
  const TokenKind first = look.token.kind;
  if (first == TokenKind::identifier) {
    if (!look.value) {
      error_undeclared(look.token.name);
    }
    const Value& value = *look.value;
    if (!value.is_set()) {
      error("this array element was never set");
    }
    const ValueKind kind = value.kind();
    const bool callable = kind == ValueKind::function || kind == ValueKind::spline;
    if (callable && !raw_peek().is(Symbol::paren_open)) {
      result.value = value;
      // Functions are always copied; a spline is passed by reference.
      if (kind == ValueKind::spline) {
        result.is_reference = true;
        result.reference = look.is_element ? look.reference : Reference{look.entry, 0, {}};
        if (!look.is_element && look.entry->alias) result.reference = *look.entry->alias;
      }
      result.numeric = true;
      consume();
      return;
    }
    if (value.is_numeric() || callable) {
      const bool color_rules = kind == ValueKind::color && language_version < 350;
      Reference reference;
      if (look.is_element) {
        reference = look.reference;
      } else if (look.entry->alias) {
        reference = *look.entry->alias;
      } else {
        reference.entry = look.entry;
      }
      SymbolTable::hold(*reference.entry);
      const uint64_t before = consumed;
      Terms terms;
      if (color_rules) {
        parse_color(terms, true);
      } else {
        parse_parameter(terms, 1);
      }
      peek();
      // Exactly one token was used and its scope has not ended while we looked for an operator.
      const bool alone = consumed == before + 1 && !callable;
      if (alone && reference.entry->live) {
        result.is_reference = true;
        result.reference = reference;
      }
      symbols.drop(*reference.entry);
      result.value = to_value(terms);
      result.numeric = true;
      return;
    }
    if (kind == ValueKind::string) {
      const Reference reference = look.is_element      ? look.reference
                                  : look.entry->alias ? *look.entry->alias
                                                      : Reference{look.entry, 0, {}};
      result.value = value;
      result.is_reference = true;
      result.reference = reference;
      consume();
      return;
    }
    if (kind == ValueKind::macro || kind == ValueKind::file) {
      error_expected(what);
    }
    // A bare identifier of a scene kind or an array.
    result.value = value;
    result.is_reference = true;
    result.reference = look.is_element      ? look.reference
                       : look.entry->alias ? *look.entry->alias
                                           : Reference{look.entry, 0, {}};
    consume();
    return;
  }
  if (starts_color()) {
    Terms terms;
    parse_color(terms, true);
    result.value = to_value(terms);
    result.numeric = true;
    return;
  }
  if (starts_string()) {
    const FlagScope on(directives_live, true);
    result.value = Value(parse_string());
    return;
  }
  if (first == TokenKind::keyword) {
    switch (look.token.keyword) {
      case Keyword::array: {
        consume();
        result.value = parse_array();
        // What follows is looked at before the array has its name.
        peek();
        return;
      }
      case Keyword::function: {
        consume();
        const FlagScope on(directives_live, true);
        result.value = Value(ValueKind::function, parse_function(FunctionParameters::xyz, FunctionBodies::any));
        return;
      }
      case Keyword::spline: {
        consume();
        const FlagScope on(directives_live, true);
        result.value = Value(ValueKind::spline, parse_spline());
        return;
      }
      case Keyword::t:
        error_expected(what);
      default:
        break;
    }
  }
  if (starts_expression()) {
    Terms terms;
    parse_parameter(terms, 1);
    result.value = to_value(terms);
    result.numeric = true;
    return;
  }
  {
    const FlagScope on(directives_live, true);
    result.value = parse_rvalue_block(parser);
  }
  if (!result.value.is_set()) error_expected(what);
}

int64_t Parser::State::parse_flat_index(const ArrayShape& shape) {
  int64_t flat = 0;
  for (int d = 0; d < shape.dimensions; ++d) {
    expect(Symbol::bracket_open);
    const double subscript = parse_float();
    if (subscript < -kEpsilon) error("negative subscript " + std::to_string(subscript));
    const double whole = std::trunc(subscript + kEpsilon);
    if (!(whole < static_cast<double>(shape.sizes[d]))) {
      error("subscript " + std::to_string(static_cast<long long>(whole)) +
            " is outside the array, which has " + std::to_string(shape.sizes[d]) +
            " elements in this dimension");
    }
    flat = flat * shape.sizes[d] + static_cast<int64_t>(whole);
    if (!peek().is(Symbol::bracket_close)) error_expected("']' after the subscript");
    consume();
  }
  return flat;
}

Reference Parser::State::parse_element(Entry& array) {
  Reference reference;
  if (array.alias) {
    reference = *array.alias;
  } else {
    reference.entry = &array;
  }
  const FlagScope elements(resolve_elements, true);
  parse_subscripts(reference);
  return reference;
}

void Parser::State::parse_subscripts(Reference& reference) {
  const NestingScope deeper(*this);
  // The brackets are looked for in the text itself: the element's kind decides what comes next.
  do {
    const Value* value = readable(reference);
    if (!value || value->kind() != ValueKind::array) break;
    if (reference.levels == Reference::kMostLevels) {
      error("arrays inside arrays are nested more than " +
            std::to_string(Reference::kMostLevels) + " deep");
    }
    const ArrayShape shape = value->as<Array>().shape;
    reference.path[reference.levels] = parse_flat_index(shape);
    ++reference.levels;
  } while (raw_peek().is(Symbol::bracket_open));
  if (!readable(reference)) error("the array changed while its subscripts were read");
}

Value* Parser::State::writable(const Reference& reference) {
  if (!reference.entry->live) return nullptr;
  Value* value = &reference.entry->value;
  for (int level = 0; level < reference.levels; ++level) {
    if (value->kind() != ValueKind::array) return nullptr;
    // Copy on write: `#declare B=A` shares until one of them changes.
    if (value->is_shared()) {
      *value = Value(ValueKind::array, std::make_shared<Array>(value->as<Array>()));
    }
    Array& array = value->mutable_as<Array>();
    const int64_t index = reference.path[level];
    if (index < 0 || index >= static_cast<int64_t>(array.elements.size())) return nullptr;
    value = &array.elements[index];
  }
  return value;
}

void Parser::State::store(const Reference& reference, Value value) {
  Value* slot = writable(reference);
  if (!slot) error("the variable that this name stands for is gone");
  if (reference.levels > 0) {
    Reference holder = reference;
    --holder.levels;
    Array& array = writable(holder)->mutable_as<Array>();
    if (array.element_kind == ValueKind::unset) {
      array.element_kind = value.kind();
    } else if (array.element_kind != value.kind()) {
      error(std::string("this array holds elements of the kind ") + kind_name(array.element_kind) +
            ", not " + kind_name(value.kind()));
    }
  }
  const bool is_array = value.kind() == ValueKind::array;
  const int inner = is_array ? value.as<Array>().depth : 0;
  *slot = std::move(value);
  if (!is_array) return;
  // The arrays on the way to the element are at least one level deeper each.
  for (Reference holder = reference; holder.levels > 0;) {
    --holder.levels;
    Array& array = writable(holder)->mutable_as<Array>();
    array.depth = std::max(array.depth, inner + reference.levels - holder.levels);
    check_depth(array);
  }
}

void Parser::State::check_depth(const Array& array) {
  if (array.depth > Array::kMostDepth) {
    error("arrays stand in each other more than " + std::to_string(Array::kMostDepth) +
          " levels deep, which is the limit");
  }
}

// After `array`: sizes and the initialiser, read with directives off between operands.
Value Parser::State::parse_array() {
  const FlagScope off(directives_live, false);
  auto array = std::make_shared<Array>();
  ArrayShape& shape = array->shape;
  double total = 1;
  while (accept(Symbol::bracket_open)) {
    if (shape.dimensions == ArrayShape::kMostDimensions) {
      error("an array has at most " + std::to_string(ArrayShape::kMostDimensions) + " dimensions");
    }
    const double size = std::trunc(parse_float() + kEpsilon);
    total *= size;
    if (std::fabs(total) > static_cast<double>(options.limits.max_array_elements)) {
      error("the array would have more than " +
                std::to_string(options.limits.max_array_elements) + " elements, which is the limit",
            "--max-array-elements N raises it");
    }
    shape.sizes[shape.dimensions++] = static_cast<int64_t>(size);
    if (!accept(Symbol::bracket_close)) error_expected("']' after the size of the array");
  }
  if (shape.dimensions == 0) error_expected("'[' and the size of the array");
  if (!(total > 0)) error("the size of an array must be positive");
  for (int d = 0; d < shape.dimensions; ++d) {
    if (shape.sizes[d] <= 0) error("the size of an array must be positive");
  }
  array->elements.resize(static_cast<size_t>(total));
  if (peek().is(Symbol::brace_open)) {
    int64_t index = 0;
    parse_array_level(*array, 0, index);
  }
  return Value(ValueKind::array, std::move(array));
}

void Parser::State::parse_array_level(Array& array, int dimension, int64_t& index) {
  if (!accept(Symbol::brace_open)) error_expected("'{' of the array's elements");
  const bool innermost = dimension == array.shape.dimensions - 1;
  for (int64_t i = 0; i < array.shape.sizes[dimension]; ++i) {
    peek();
    if (ahead == kDeferred) {
      error("an element of an array cannot begin with a macro or a directive",
            "put the value into parentheses");
    }
    if (look.token.is(Symbol::brace_close)) {
      error("the array's size is " + std::to_string(array.shape.sizes[dimension]) +
            " here, but only " + std::to_string(i) + " elements are given");
    }
    if (innermost) {
      RightSide element;
      parse_right_side(element, "an array element");
      if (element.is_reference) element.value = *readable(element.reference);
      if (array.element_kind == ValueKind::unset) array.element_kind = element.value.kind();
      if (array.element_kind != element.value.kind()) {
        error(std::string("the elements of an array have one kind: expected ") +
              kind_name(array.element_kind) + ", found " + kind_name(element.value.kind()));
      }
      if (element.value.kind() == ValueKind::array) {
        array.depth = std::max(array.depth, element.value.as<Array>().depth + 1);
        check_depth(array);
      }
      array.elements[index++] = std::move(element.value);
    } else {
      parse_array_level(array, dimension + 1, index);
    }
    accept_comma();
  }
  if (!accept(Symbol::brace_close)) error_expected("'}' after the array's last element");
}

std::shared_ptr<const Spline> Parser::State::parse_spline() {
  parser.note_experimental("spline");
  if (!accept(Symbol::brace_open)) error_expected("'{' after 'spline'");
  auto spline = std::make_shared<Spline>();
  if (peek().kind == TokenKind::identifier && look.value && look.value->kind() == ValueKind::spline) {
    *spline = look.value->as<Spline>();
    consume();
  }
  for (;;) {
    if (accept(Keyword::linear_spline)) {
      spline->kind = SplineInterpolation::linear;
    } else if (accept(Keyword::quadratic_spline)) {
      spline->kind = SplineInterpolation::quadratic;
    } else if (accept(Keyword::cubic_spline)) {
      spline->kind = SplineInterpolation::cubic;
    } else if (accept(Keyword::natural_spline)) {
      spline->kind = SplineInterpolation::natural;
    } else {
      break;
    }
    accept_comma();
  }
  if (spline->empty() && !starts_expression()) error_expected("at least one point of the spline");
  Terms value;  // what a shorter point does not say is left from the point before
  while (starts_expression()) {
    const double parameter = parse_float();
    accept_comma();
    parse_express(value, 1);
    if (value.count == 1) value.v[1] = value.v[0];
    spline->add(parameter, std::to_array(value.v), value.count);
    accept_comma();
  }
  if (!accept(Symbol::brace_close)) error_expected("'}' after the spline's points");
  spline->complete();
  return spline;
}

}  // namespace durer
