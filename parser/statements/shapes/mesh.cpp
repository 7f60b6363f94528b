// mesh: triangles one by one (spec/geometry.md 13.5).
#include <map>

#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"
#include "parser/statements/textures.h"

namespace durer {
namespace {

class MeshReader {
 public:
  MeshReader(Parser& parser, MeshNode& mesh) : parser_(parser), mesh_(mesh) {}

  void triangle(bool smooth) {
    parser_.expect_open(smooth ? "smooth_triangle" : "triangle");
    const size_t face = mesh_.face_vertices.size();
    std::array<int32_t, 3> vertex, normal{-1, -1, -1};
    for (int i = 0; i < 3; ++i) {
      vertex[i] = static_cast<int32_t>(mesh_.vertices.size());
      mesh_.vertices.emplace_back(parser_.parse_vector());
      parser_.accept_comma();
      if (!smooth) continue;
      normal[i] = static_cast<int32_t>(mesh_.normals.size());
      mesh_.normals.emplace_back(normalize_or_zero(parser_.parse_vector()));
      parser_.accept_comma();
    }
    mesh_.face_vertices.push_back(vertex);
    if (smooth) set(mesh_.face_normals, face, normal);
    for (;;) {
      if (parser_.accept(Keyword::uv_vectors)) {
        std::array<int32_t, 3> uv;
        for (int32_t& index : uv) {
          index = static_cast<int32_t>(mesh_.uv.size());
          mesh_.uv.push_back(parser_.parse_uv());
          parser_.accept_comma();
        }
        set(mesh_.face_uv, face, uv);
      } else if (parser_.accept(Keyword::texture)) {
        const int32_t index = texture_index(parse_texture(parser_));
        set(mesh_.face_textures, face, {index, index, index});
      } else if (parser_.accept(Keyword::texture_list)) {
        parser_.expect_open("texture_list");
        std::array<int32_t, 3> list;
        for (int32_t& index : list) {
          if (auto named = parser_.accept_identifier<TextureNode>(ValueKind::texture)) {
            index = texture_index(named);
          } else if (parser_.accept(Keyword::texture)) {
            index = texture_index(parse_texture(parser_));
          } else {
            parser_.error_expected("a texture");
          }
          parser_.accept_comma();
        }
        parser_.expect_close("texture_list");
        set(mesh_.face_textures, face, list);
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
  int32_t texture_index(const TexturePtr& texture) {
    const auto [it, is_new] =
        index_.try_emplace(texture.get(), static_cast<int32_t>(mesh_.textures.size()));
    if (is_new) mesh_.textures.push_back(texture);
    return it->second;
  }

  Parser& parser_;
  MeshNode& mesh_;
  std::map<const TextureNode*, int32_t> index_;
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
