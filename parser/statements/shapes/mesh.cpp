// mesh: triangles one by one (spec/geometry.md 13.5).
#include <map>

#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"
#include "tracer/shapes/triangle.h"

namespace durer {
namespace {

class MeshReader {
 public:
  MeshReader(Parser& parser, MeshNode& mesh) : parser_(parser), mesh_(mesh) {}

  void triangle(bool smooth) {
    parser_.expect_open(smooth ? "smooth_triangle" : "triangle");
    std::array<Vec3, 3> vertex, normal;
    for (int i = 0; i < 3; ++i) {
      vertex[i] = parser_.parse_vector();
      if (smooth) {
        parser_.accept_comma();
        normal[i] = unit_normal(parser_.parse_vector());
      }
      if (i < 2) parser_.accept_comma();
    }
    // A triangle without area is left out; its items are read all the same.
    const bool keep = length(cross(vertex[2] - vertex[0], vertex[1] - vertex[0])) > 0;
    const size_t face = mesh_.face_vertices.size();
    if (keep) {
      mesh_.face_vertices.push_back(append(mesh_.vertices, vertex));
      mesh_.face_planes.push_back(mesh_plane_of(vertex[0], vertex[1], vertex[2]));
      if (smooth) {
        set(mesh_.face_normals, face, append(mesh_.normals, normal));
        mesh_.face_altitudes.resize(face);
        mesh_.face_altitudes.push_back(mesh_altitude_of(vertex[0], vertex[1], vertex[2]));
      }
    }
    bool textured = false;
    for (;;) {
      if (!textured && parser_.accept(Keyword::uv_vectors)) {
        std::array<int32_t, 3> uv;
        for (int32_t& index : uv) {
          index = static_cast<int32_t>(mesh_.uv.size());
          mesh_.uv.push_back(parser_.parse_uv());
          if (&index != &uv.back()) parser_.accept_comma();
        }
        if (keep) set(mesh_.face_uv, face, uv);
      } else if (parser_.accept(Keyword::texture)) {
        parser_.expect_open("texture");
        const int32_t index = parse_texture_index();
        parser_.expect_close("texture");
        textured = true;
        if (keep) set(mesh_.face_textures, face, {index, -1, -1});
      } else if (parser_.accept(Keyword::texture_list)) {
        parser_.expect_open("texture_list");
        std::array<int32_t, 3> list;
        for (int32_t& index : list) {
          index = parse_texture_index();
          if (&index != &list.back()) parser_.accept_comma();
        }
        parser_.expect_close("texture_list");
        textured = true;
        if (keep) set(mesh_.face_textures, face, list);
      } else {
        break;
      }
    }
    parser_.expect_close(smooth ? "smooth_triangle" : "triangle");
  }

  // Brings the optional arrays to the length of the faces.
  void finish() {
    const size_t count = mesh_.face_vertices.size();
    for (auto* list : {&mesh_.face_normals, &mesh_.face_uv, &mesh_.face_textures}) {
      if (!list->empty()) list->resize(count, {-1, -1, -1});
    }
  }

 private:
  static void set(std::vector<std::array<int32_t, 3>>& list, size_t face,
                  const std::array<int32_t, 3>& value) {
    list.resize(face, {-1, -1, -1});
    list.push_back(value);
  }
  Vec3 unit_normal(const Vec3& given) {
    if (length(given) > 0) return normalize_or_zero(given);
    if (!warned_) parser_.warning("a normal of this mesh is the zero vector; <1,0,0> is used");
    warned_ = true;
    return {1, 0, 0};
  }
  static std::array<int32_t, 3> append(std::vector<glm::vec3>& list,
                                       const std::array<Vec3, 3>& items) {
    const auto first = static_cast<int32_t>(list.size());
    for (const Vec3& item : items) list.emplace_back(item);
    return {first, first + 1, first + 2};
  }
  // A mesh's triangles take declared textures only, so that they can share them.
  int32_t parse_texture_index() {
    const auto texture = parser_.accept_identifier<TextureNode>(ValueKind::texture);
    if (!texture) parser_.error_expected("the name of a declared texture");
    const auto [it, is_new] =
        index_.try_emplace(texture.get(), static_cast<int32_t>(mesh_.textures.size()));
    if (is_new) mesh_.textures.push_back(texture);
    return it->second;
  }

  Parser& parser_;
  MeshNode& mesh_;
  std::map<const TextureNode*, int32_t> index_;
  bool warned_ = false;
};

}  // namespace

ShapeNode parse_mesh(Parser& parser) {
  MeshNode mesh;
  MeshReader reader(parser, mesh);
  for (;;) {
    if (parser.accept(Keyword::triangle)) {
      reader.triangle(false);
    } else if (parser.accept(Keyword::smooth_triangle)) {
      reader.triangle(true);
    } else if (parser.accept(Keyword::inside_vector)) {
      mesh.inside_vector = parser.parse_vector();
    } else {
      break;
    }
  }
  reader.finish();
  if (mesh.face_vertices.empty()) parser.error("a mesh needs at least one triangle");
  if (mesh.inside_vector && length(*mesh.inside_vector) == 0) mesh.inside_vector.reset();
  return mesh;
}

}  // namespace durer
