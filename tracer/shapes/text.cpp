#include "tracer/shapes/text.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H
#include FT_TRUETYPE_TAGS_H

#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>

#include "tracer/system/shared_library.h"

namespace durer {
namespace {

// A piece of an outline: straight from a to c, or a parabola with control point b.
struct Edge {
  Vec2 a, b, c;
  bool curved = false;

  Vec2 point(double u) const {
    if (!curved) return a + u * (c - a);
    return (bend() * u + 2.0 * (b - a)) * u + a;
  }
  // Of u squared in point(u) of a parabola: about 0 where its control point halves a to c.
  Vec2 bend() const { return a - 2.0 * b + c; }
  Vec2 tangent(double u) const { return curved ? 2.0 * (bend() * u + (b - a)) : c - a; }
};

// The box of an edge, and a hair more than rounding and the tolerances below can move a point.
class EdgeBox {
 public:
  explicit EdgeBox(const Edge& e) {
    const Vec2& control = e.curved ? e.b : e.a;
    const Vec2 low = glm::min(glm::min(e.a, e.c), control);
    const Vec2 high = glm::max(glm::max(e.a, e.c), control);
    corners_ = _mm_setr_ps(wide(-low.x), wide(-low.y), wide(high.x), wide(high.y));
  }
  // A box to be asked about, infinite perhaps.
  static __m128 question(const Vec2& low, const Vec2& high) {
    return _mm_setr_ps(static_cast<float>(-high.x), static_cast<float>(-high.y),
                       static_cast<float>(low.x), static_cast<float>(low.y));
  }
  bool overlaps(__m128 question) const {
    return _mm_movemask_ps(_mm_cmplt_ps(corners_, question)) == 0;
  }
  float low_y() const { return -at(1); }
  float high_y() const { return at(3); }

 private:
  float at(int i) const {
    alignas(16) float corners[4];
    _mm_store_ps(corners, corners_);
    return corners[i];
  }
  static float wide(double x) { return static_cast<float>(x + 1e-5 * (1 + std::abs(x))); }

  __m128 corners_;  // -low, high
};

// Which edges may be met at a height: lists for the rows that an outline is cut into.
class EdgeRows {
 public:
  // Of boxes that overlap [low, high].
  EdgeRows(const std::vector<EdgeBox>& boxes, double low, double high)
      : low_(low), rows_per_unit_(kRows / std::max(high - low, kGeometryEpsilon)) {
    uint32_t count = 0;
    for (int row = 0; row < kRows; ++row) {
      first_[row] = count;
      for (uint32_t i = 0; i < boxes.size(); ++i) {
        if (row_of(boxes[i].low_y()) > row || row_of(boxes[i].high_y()) < row) continue;
        edges_.push_back(i);
        ++count;
      }
    }
    first_[kRows] = count;
  }

  int row_of(double y) const {
    const double row = (y - low_) * rows_per_unit_;
    return row > 0 ? row < kRows ? static_cast<int>(row) : kRows - 1 : 0;
  }
  // Ascending.
  std::span<const uint32_t> edges_in(int row) const {
    return {edges_.data() + first_[row], edges_.data() + first_[row + 1]};
  }

 private:
  static constexpr int kRows = 32;

  double low_, rows_per_unit_;
  uint32_t first_[kRows + 1];
  std::vector<uint32_t> edges_;  // of one row after the other
};

// Roots in [0,1] of q[0] u^2 + q[1] u + q[2].
int solve_edge(const double* q, double* roots) {
  double found[2];
  int count = 0;
  // Straight but for rounding.
  if (std::abs(q[0]) < kGeometryEpsilon) {
    if (q[1] == 0) return 0;
    found[count++] = -q[2] / q[1];
  } else {
    const double discriminant = q[1] * q[1] - 4 * q[0] * q[2];
    if (discriminant < kGeometryEpsilon) return 0;
    const double root = std::sqrt(discriminant);
    found[count++] = (-q[1] + root) / (2 * q[0]);
    found[count++] = (-q[1] - root) / (2 * q[0]);
  }
  int kept = 0;
  for (int i = 0; i < count; ++i)
    if (found[i] >= 0 && found[i] <= 1) roots[kept++] = found[i];
  return kept;
}

// What a font says of a glyph, in em.
struct Frame {
  Vec2 low{0}, high{0};
  double left = 0;  // where the outline begins; composed glyphs may have another low.x
};

// Without edges, as a blank is, it is never met, but its origin counts in the text's extents.
class Glyph final : public Shape {
 public:
  // The frame is what the font says of the outline, which may be too much or too little.
  Glyph(std::vector<Edge> edges, const Frame& frame, double depth)
      : edges_(std::move(edges)),
        edge_boxes_(edges_.begin(), edges_.end()),
        depth_(depth),
        box_(box_of(edges_, frame, depth)),
        rows_(edge_boxes_, box_.min.y, box_.max.y) {}

  Bounds bounds() const override { return box_; }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const Vec3 p = ray.origin, d = ray.direction;
    if (d.z != 0) {
      face(p, d, 0, 0, out);
      face(p, d, depth_, 1, out);
    }
    // A ray along z meets no wall.
    if (d.x == 0 && d.y == 0) return;
    const auto [low, high] = way_between_faces(p, d);
    const __m128 way = EdgeBox::question(low, high);
    const auto meet_wall = [&](uint32_t i) {
      if (!edge_boxes_[i].overlaps(way)) return;
      const Edge& e = edges_[i];
      const auto side = [&](const Vec2& q) { return d.x * (q.y - p.y) - d.y * (q.x - p.x); };
      const double a = side(e.a), c = side(e.c);
      double u[2];
      int count = 0;
      if (e.curved) {
        const double b = side(e.b);
        if ((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0)) return;
        const Vec2 bend = e.bend(), start = e.b - e.a;
        const double q[3] = {d.x * bend.y - d.y * bend.x, 2 * (d.x * start.y - d.y * start.x), a};
        count = solve_edge(q, u);
      } else {
        if (std::abs(c - a) < kGeometryEpsilon) return;
        u[0] = -a / (c - a);
        if (u[0] >= 0 && u[0] <= 1) count = 1;
      }
      for (int k = 0; k < count; ++k) {
        const Vec2 at = e.point(u[k]);
        const double t = std::abs(d.x) > kGeometryEpsilon ? (at.x - p.x) / d.x : (at.y - p.y) / d.y;
        const double z = p.z + t * d.z;
        if (z >= 0 && z <= depth_ && t > 1e-6) out.push_with_parameter(t, i + 2, u[k]);
      }
    };
    const int row = rows_.row_of(low.y);
    if (row == rows_.row_of(high.y)) {
      for (const uint32_t i : rows_.edges_in(row)) meet_wall(i);
    } else {
      const uint32_t count = static_cast<uint32_t>(edges_.size());
      for (uint32_t i = 0; i < count; ++i) meet_wall(i);
    }
  }

  bool inside(const Vec3& p) const override {
    return p.z >= 0 && p.z <= depth_ && covers(p.x, p.y);
  }

  Vec3 normal(const Vec3&, const ShapeHit& hit) const override {
    if (hit.part < 2) return {0, 0, hit.part == 0 ? -1 : 1};
    const Vec2 tangent = edges_[hit.part - 2].tangent(hit.parameter());
    return {tangent.y, -tangent.x, 0};
  }

 private:
  void face(const Vec3& p, const Vec3& d, double z, uint32_t part, HitStack& out) const {
    const double t = (z - p.z) / d.z;
    if (t > 1e-6 && covers(p.x + t * d.x, p.y + t * d.y)) out.push(t, part);
  }

  static Bounds box_of(const std::vector<Edge>& edges, const Frame& frame, double depth) {
    Bounds box(Vec3(frame.low, -1e-6), Vec3(frame.high, depth + 1e-6));
    for (const Edge& e : edges) {
      for (const Vec2& p : {e.a, e.c, e.curved ? e.b : e.a}) {
        box.extend(Vec3(p.x, p.y, -1e-6));
        box.extend(Vec3(p.x, p.y, depth + 1e-6));
      }
    }
    return box;
  }

  // The corners of a box around the part of a ray that may meet walls.
  std::pair<Vec2, Vec2> way_between_faces(const Vec3& p, const Vec3& d) const {
    double first = 0, last = std::numeric_limits<double>::infinity();
    if (d.z != 0) {
      const double near = -p.z / d.z, far = (depth_ - p.z) / d.z;
      first = std::max(first, std::min(near, far));
      last = std::max(near, far);
    }
    const auto along = [](double from, double slope, double t) {
      return slope == 0 ? from : from + slope * t;
    };
    const Vec2 start(along(p.x, d.x, first), along(p.y, d.y, first));
    const Vec2 end(along(p.x, d.x, last), along(p.y, d.y, last));
    return {glm::min(start, end), glm::max(start, end)};
  }

  // Even-odd parity along +x.
  bool covers(double x, double y) const {
    if (x < box_.min.x || x > box_.max.x || y < box_.min.y || y > box_.max.y) return false;
    bool inside = false;
    const __m128 way =
        EdgeBox::question(Vec2(x, y), Vec2(std::numeric_limits<double>::infinity(), y));
    for (const uint32_t i : rows_.edges_in(rows_.row_of(y))) {
      if (!edge_boxes_[i].overlaps(way)) continue;
      const Edge& e = edges_[i];
      if (!e.curved) {
        if ((e.a.y < y) == (e.c.y < y)) continue;
        const double crossing = e.a.x + (y - e.a.y) * (e.c.x - e.a.x) / (e.c.y - e.a.y);
        if ((e.a.x > x && e.c.x > x) || crossing >= x - kGeometryEpsilon) inside = !inside;
        continue;
      }
      const double a = e.a.y - y, b = e.b.y - y, c = e.c.y - y;
      if ((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0)) continue;
      const double q[3] = {e.bend().y, 2 * (e.b.y - e.a.y), a};
      double u[2];
      for (int k = solve_edge(q, u); k-- > 0;) {
        // At an end the curve must cross there, so that neighbours do not both count.
        if (u[k] <= kGeometryEpsilon && !leaves(a, b, c)) continue;
        if (u[k] >= 1 - kGeometryEpsilon && !leaves(c, b, a)) continue;
        if (e.point(u[k]).x > x) inside = !inside;
      }
    }
    return inside;
  }

  // A piece that touches the height with an end counts if it comes from below, as straight ones do.
  static bool leaves(double at, double control, double other) {
    if (at < 0) return true;
    return control != at ? control < at : other < at;
  }

  std::vector<Edge> edges_;
  std::vector<EdgeBox> edge_boxes_;  // of the same
  double depth_;
  Bounds box_;
  EdgeRows rows_;
};

struct FreeType {
  SharedLibrary library{DURER_FREETYPE_LIBRARY};
  DURER_IMPORT(FT_Init_FreeType);
  DURER_IMPORT(FT_Done_FreeType);
  DURER_IMPORT(FT_New_Face);
  DURER_IMPORT(FT_Done_Face);
  DURER_IMPORT(FT_Get_CMap_Format);
  DURER_IMPORT(FT_Set_Charmap);
  DURER_IMPORT(FT_Get_Char_Index);
  DURER_IMPORT(FT_Load_Glyph);
  DURER_IMPORT(FT_Get_Kerning);
  DURER_IMPORT(FT_Outline_Decompose);
  DURER_IMPORT(FT_Get_Sfnt_Table);
  DURER_IMPORT(FT_Load_Sfnt_Table);
};

const FreeType& freetype() { return loaded<FreeType>(); }

// Collects what FreeType takes apart; coordinates in em.
struct OutlineBuilder {
  double scale;
  std::vector<Edge> edges;
  Vec2 start{0}, at{0};

  Vec2 scaled(const FT_Vector* p) const {
    return {static_cast<double>(p->x) * scale, static_cast<double>(p->y) * scale};
  }
  void line(const Vec2& to) {
    if (to != at) edges.push_back({at, at, to, false});
    at = to;
  }
};

std::vector<Edge> outline_of(FT_Outline& outline, double scale) {
  // In 64ths, so that the points implied between two control points are not rounded.
  constexpr int kShift = 6;
  OutlineBuilder builder{scale / (1 << kShift), {}, Vec2(0), Vec2(0)};
  FT_Outline_Funcs functions{};
  functions.shift = kShift;
  functions.move_to = [](const FT_Vector* to, void* user) {
    auto& b = *static_cast<OutlineBuilder*>(user);
    b.line(b.start);  // closes the contour before
    b.start = b.at = b.scaled(to);
    return 0;
  };
  functions.line_to = [](const FT_Vector* to, void* user) {
    auto& b = *static_cast<OutlineBuilder*>(user);
    b.line(b.scaled(to));
    return 0;
  };
  functions.conic_to = [](const FT_Vector* control, const FT_Vector* to, void* user) {
    auto& b = *static_cast<OutlineBuilder*>(user);
    b.edges.push_back({b.at, b.scaled(control), b.scaled(to), true});
    b.at = b.scaled(to);
    return 0;
  };
  // Cubics, of fonts that are not TrueType: eight parabolas each.
  functions.cubic_to = [](const FT_Vector* c1, const FT_Vector* c2, const FT_Vector* to,
                          void* user) {
    auto& b = *static_cast<OutlineBuilder*>(user);
    const Vec2 p0 = b.at, p1 = b.scaled(c1), p2 = b.scaled(c2), p3 = b.scaled(to);
    constexpr int kPieces = 8;
    const auto point = [&](double t) {
      const double s = 1 - t;
      return s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3;
    };
    for (int i = 0; i < kPieces; ++i) {
      const Vec2 from = b.at;
      const Vec2 end = i + 1 == kPieces ? p3 : point((i + 1.0) / kPieces);
      const Vec2 middle = point((i + 0.5) / kPieces);
      b.edges.push_back({from, 2.0 * middle - 0.5 * (from + end), end, true});
      b.at = end;
    }
    return 0;
  };
  freetype().FT_Outline_Decompose(&outline, &functions, &builder);
  builder.line(builder.start);
  return std::move(builder.edges);
}

class Font {
 public:
  explicit Font(const std::string& path) {
    if (freetype().FT_Init_FreeType(&library_)) throw std::runtime_error("cannot start FreeType");
    const bool is_font = freetype().FT_New_Face(library_, path.c_str(), 0, &face_) == 0;
    if (is_font && FT_IS_SCALABLE(face_)) return;
    if (is_font) freetype().FT_Done_Face(face_);
    freetype().FT_Done_FreeType(library_);
    throw std::runtime_error("the font '" + path +
                             (is_font ? "' has no outlines" : "' cannot be read"));
  }
  ~Font() {
    freetype().FT_Done_Face(face_);
    freetype().FT_Done_FreeType(library_);
  }
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  // The first table of the platforms preferred decides, even if it lacks the character.
  FT_UInt glyph_index(char16_t character, bool unicode) {
    const int ascii_order[] = {1, 3, 0}, unicode_order[] = {0, 3, 1};
    for (const int platform : unicode ? unicode_order : ascii_order) {
      for (int i = 0; i < face_->num_charmaps; ++i) {
        FT_CharMap map = face_->charmaps[i];
        const FT_Long format = freetype().FT_Get_CMap_Format(map);
        if (map->platform_id != platform || (format != 0 && format != 4 && format != 6)) continue;
        freetype().FT_Set_Charmap(face_, map);
        FT_UInt glyph = freetype().FT_Get_Char_Index(face_, character);
        if (!glyph && format == 4 && character < 256)
          glyph = freetype().FT_Get_Char_Index(face_, character + 0xF000u);
        return glyph;
      }
    }
    return 0;
  }

  FT_GlyphSlot load(FT_UInt glyph) {
    if (freetype().FT_Load_Glyph(face_, glyph, FT_LOAD_NO_SCALE)) return nullptr;
    return face_->glyph;
  }
  double unit() const { return 1.0 / face_->units_per_EM; }

  // What the file says of a glyph, which FreeType passes over; of other fonts than TrueType, where the
  // outline begins. Of composed glyphs povray takes no lower limits above 0, so that accented letters
  // stand a little to the right (measured on povray 3.7).
  Frame frame_of(FT_UInt glyph, const FT_Glyph_Metrics& outline) {
    const auto* head =
        static_cast<const TT_Header*>(freetype().FT_Get_Sfnt_Table(face_, FT_SFNT_HEAD));
    FT_Byte place[4], said[10];  // said: number of contours, least x and y, greatest x and y
    const FT_ULong place_size = head && head->Index_To_Loc_Format ? 4 : 2;
    if (head && read_table(TTAG_loca, glyph * place_size, place, place_size)) {
      const FT_ULong start =
          place_size == 2 ? 2 * word(place) : FT_ULong{word(place)} << 16 | word(place + 2);
      if (read_table(TTAG_glyf, start, said, sizeof said)) {
        const auto em = [&](int i) { return unit() * static_cast<int16_t>(word(said + i)); };
        Frame frame{{em(2), em(4)}, {em(6), em(8)}, em(2)};
        const bool is_composed = static_cast<int16_t>(word(said)) < 0;
        if (is_composed) frame.low = glm::min(frame.low, Vec2(0));
        return frame;
      }
    }
    const Vec2 top_left = unit() * Vec2(outline.horiBearingX, outline.horiBearingY);
    return {top_left, top_left, top_left.x};
  }

  Vec2 kerning(FT_UInt left, FT_UInt right) {
    FT_Vector kern{};
    if (FT_HAS_KERNING(face_)) freetype().FT_Get_Kerning(face_, left, right, FT_KERNING_UNSCALED, &kern);
    return unit() * Vec2(static_cast<double>(kern.x), static_cast<double>(kern.y));
  }

 private:
  static unsigned word(const FT_Byte* b) { return static_cast<unsigned>(b[0]) << 8 | b[1]; }

  bool read_table(FT_ULong tag, FT_ULong start, FT_Byte* to, FT_ULong size) {
    return !freetype().FT_Load_Sfnt_Table(face_, tag, static_cast<FT_Long>(start), to, &size);
  }

  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

// Most texts of a scene are in one font: it stays open.
Font& open_font(const std::string& path) {
  thread_local std::string open_path;
  thread_local std::unique_ptr<Font> font;
  if (!font || open_path != path) {
    font = std::make_unique<Font>(path);
    open_path = path;
  }
  return *font;
}

}  // namespace

void check_font(const std::string& path) { open_font(path); }

std::vector<PlacedGlyph> lay_out_text(const TextNode& node) {
  Font& font = open_font(node.font);
  std::vector<PlacedGlyph> glyphs;
  struct Known {
    std::shared_ptr<const Shape> shape;
    double left;
  };
  std::map<FT_UInt, Known> known;
  Vec2 pen(0);
  FT_UInt previous = 0;
  for (size_t i = 0; i < node.text.size(); ++i) {
    const char16_t character = node.text[i];
    const FT_UInt index = font.glyph_index(character, node.unicode);
    FT_GlyphSlot slot = font.load(index);
    if (!slot) continue;
    const double advance = static_cast<double>(slot->metrics.horiAdvance) * font.unit();
    auto there = known.find(index);
    if (there == known.end()) {
      std::vector<Edge> edges;
      if (character != u' ') edges = outline_of(slot->outline, font.unit());
      const Frame frame = edges.empty() ? Frame{} : font.frame_of(index, slot->metrics);
      auto shape = std::make_shared<Glyph>(std::move(edges), frame, node.depth);
      there = known.emplace(index, Known{std::move(shape), frame.left}).first;
    }
    const auto& [shape, left] = there->second;
    // The first character's frame starts at 0.
    const double least = shape->bounds().min.x;
    if (glyphs.empty()) {
      glyphs.push_back({shape, Vec3(-least, 0, 0)});
      pen.x = advance - left;
    } else {
      const Vec2 kern = font.kerning(previous, index);
      glyphs.push_back({shape, Vec3(pen.x + kern.x + left - least, pen.y + kern.y, 0)});
      pen.x += advance + kern.x;
    }
    pen += Vec2(node.offset.x, node.offset.y);
    previous = index;
  }
  return glyphs;
}

}  // namespace durer
