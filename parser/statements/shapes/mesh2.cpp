// mesh2: a mesh as lists (spec/geometry.md 13.5). The lists can hold millions of numbers: they are
// read by Parser::parse_literal_vectors where they stand literally in the text.
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"
#include "parser/statements/textures.h"

namespace durer {
namespace {

size_t parse_count(Parser& parser, const char* what) {
  parser.expect_open(what);
  const double count = parser.parse_float();
  parser.accept_comma();
  if (!(count >= 0)) parser.error(std::string(what) + " cannot have a negative count");
  parser.check_limit(static_cast<uint64_t>(count), parser.options().limits.max_array_elements,
                     what);
  return static_cast<size_t>(count);
}

Vec3 parse_item(Parser& parser, const glm::vec3*) { return parser.parse_vector(); }
Vec2 parse_item(Parser& parser, const Vec2*) { return parser.parse_uv(); }

template <typename Item>
void parse_list(Parser& parser, const char* what, std::vector<Item>& out) {
  const size_t count = parse_count(parser, what);
  out.reserve(count);
  while (out.size() < count) {
    parser.parse_literal_vectors(out, count - out.size());
    if (out.size() == count) break;
    out.emplace_back(parse_item(parser, static_cast<const Item*>(nullptr)));
    parser.accept_comma();
  }
  parser.expect_close(what);
}

using Indices = std::vector<std::array<int32_t, 3>>;

void check_range(Parser& parser, const Indices& list, size_t size, const char* what) {
  for (const auto& face : list) {
    for (int32_t index : face) {
      if (index < 0 || static_cast<size_t>(index) >= size) {
        parser.error(std::string(what) + ": index " + std::to_string(index) +
                     " does not exist; there are " + std::to_string(size));
      }
    }
  }
}

std::array<int32_t, 3> parse_indices(Parser& parser) {
  const Vec3 v = parser.parse_vector();
  parser.accept_comma();
  std::array<int32_t, 3> indices;
  for (int i = 0; i < 3; ++i) {
    indices[i] = v[i] > -2e9 && v[i] < 2e9 ? static_cast<int32_t>(v[i]) : -1;
  }
  return indices;
}

void parse_index_list(Parser& parser, const char* what, Indices& out) {
  const size_t count = parse_count(parser, what);
  out.reserve(count);
  while (out.size() < count) {
    parser.parse_literal_vectors(out, count - out.size());
    if (out.size() == count) break;
    out.push_back(parse_indices(parser));
  }
  parser.expect_close(what);
}

// Faces may be followed by one or three texture numbers.
void parse_faces(Parser& parser, MeshNode& mesh) {
  const size_t count = parse_count(parser, "face_indices");
  mesh.face_vertices.reserve(count);
  const int32_t textures = static_cast<int32_t>(mesh.textures.size());
  while (mesh.face_vertices.size() < count) {
    if (textures == 0) {
      parser.parse_literal_vectors(mesh.face_vertices, count - mesh.face_vertices.size());
      if (mesh.face_vertices.size() == count) break;
    }
    const Vec3 v = parser.parse_vector();
    parser.accept_comma();
    mesh.face_vertices.push_back(
        {static_cast<int32_t>(v.x), static_cast<int32_t>(v.y), static_cast<int32_t>(v.z)});
    if (textures == 0) continue;
    std::array<int32_t, 3> list{-1, -1, -1};
    if (parser.at_expression() && !parser.at(Symbol::less)) {
      list[0] = parser.parse_int();
      list[1] = list[2] = list[0];
      parser.accept_comma();
      if (parser.at_expression() && !parser.at(Symbol::less)) {
        for (int i = 1; i < 3; ++i) {
          list[i] = parser.parse_int();
          parser.accept_comma();
        }
      }
      for (int32_t index : list) {
        if (index < 0 || index >= textures) parser.error("there is no such texture in the list");
      }
    }
    mesh.face_textures.resize(mesh.face_vertices.size() - 1, {-1, -1, -1});
    mesh.face_textures.push_back(list);
  }
  parser.expect_close("face_indices");
}

void parse_textures(Parser& parser, MeshNode& mesh) {
  const size_t count = parse_count(parser, "texture_list");
  for (size_t i = 0; i < count; ++i) {
    if (parser.accept(Keyword::texture)) {
      mesh.textures.push_back(parse_texture(parser));
    } else if (auto named = parser.accept_identifier<TextureNode>(ValueKind::texture)) {
      mesh.textures.push_back(std::move(named));
    } else {
      parser.error_expected("a texture");
    }
    parser.accept_comma();
  }
  parser.expect_close("texture_list");
}

}  // namespace

ShapeNode parse_mesh2(Parser& parser) {
  MeshNode mesh;
  if (!parser.accept(Keyword::vertex_vectors)) parser.error_expected("vertex_vectors");
  parse_list(parser, "vertex_vectors", mesh.vertices);
  for (;;) {
    if (parser.accept(Keyword::normal_vectors)) {
      parse_list(parser, "normal_vectors", mesh.normals);
      for (glm::vec3& n : mesh.normals) n = normalize_or_zero(Vec3(n));
    } else if (parser.accept(Keyword::uv_vectors)) {
      parse_list(parser, "uv_vectors", mesh.uv);
    } else if (parser.accept(Keyword::texture_list)) {
      parse_textures(parser, mesh);
    } else {
      break;
    }
  }
  if (!parser.accept(Keyword::face_indices)) parser.error_expected("face_indices");
  parse_faces(parser, mesh);
  check_range(parser, mesh.face_vertices, mesh.vertices.size(), "face_indices");

  for (;;) {
    if (parser.accept(Keyword::normal_indices)) {
      parse_index_list(parser, "normal_indices", mesh.face_normals);
    } else if (parser.accept(Keyword::uv_indices)) {
      parse_index_list(parser, "uv_indices", mesh.face_uv);
    } else if (parser.accept(Keyword::inside_vector)) {
      mesh.inside_vector = parser.parse_vector();
    } else {
      break;
    }
  }
  // Left out, the lists of normals and uv points go with the vertices.
  if (!mesh.normals.empty() && mesh.face_normals.empty()) {
    if (mesh.normals.size() == mesh.vertices.size()) mesh.face_normals = mesh.face_vertices;
  }
  if (!mesh.uv.empty() && mesh.face_uv.empty() && mesh.uv.size() == mesh.vertices.size()) {
    mesh.face_uv = mesh.face_vertices;
  }
  const size_t faces = mesh.face_vertices.size();
  if (mesh.face_normals.size() > faces || mesh.face_uv.size() > faces) {
    parser.error("there are more normal or uv indices than faces");
  }
  check_range(parser, mesh.face_normals, mesh.normals.size(), "normal_indices");
  check_range(parser, mesh.face_uv, mesh.uv.size(), "uv_indices");
  for (auto* list : {&mesh.face_normals, &mesh.face_uv, &mesh.face_textures}) {
    if (!list->empty()) list->resize(faces, {-1, -1, -1});
  }
  if (mesh.inside_vector && length(*mesh.inside_vector) == 0) mesh.inside_vector.reset();
  return mesh;
}

}  // namespace durer
