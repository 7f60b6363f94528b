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
Vec3 parse_item(Parser& parser, const Vec3*) {
  return parser.parse_vector();
}
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
    mesh.face_vertices.push_back(parse_indices(parser));
    if (textures == 0) continue;
    std::array<int32_t, 3> list{-1, -1, -1};
    if (parser.at_expression() && !parser.at(Symbol::less)) {
      list[0] = parser.parse_int();
      parser.accept_comma();
      const bool is_one = !parser.at_expression() || parser.at(Symbol::less);
      if (!is_one) {
        for (int i = 1; i < 3; ++i) {
          list[i] = parser.parse_int();
          parser.accept_comma();
        }
      }
      for (int i = 0; i < (is_one ? 1 : 3); ++i) {
        if (list[i] < 0 || list[i] >= textures) {
          parser.error("there is no such texture in the list");
        }
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
    if (!parser.accept(Keyword::texture)) parser.error_expected("texture");
    mesh.textures.push_back(parse_texture(parser));
    parser.accept_comma();
  }
  parser.expect_close("texture_list");
}

// Single precision comes after they have been brought to length 1.
void parse_normals(Parser& parser, MeshNode& mesh) {
  std::vector<Vec3> given;
  parse_list(parser, "normal_vectors", given);
  mesh.normals.clear();
  mesh.normals.reserve(given.size());
  bool has_zero = false;
  for (const Vec3& normal : given) {
    const bool is_zero = length(normal) == 0;
    has_zero |= is_zero;
    mesh.normals.emplace_back(is_zero ? Vec3(1, 0, 0) : normalize_or_zero(normal));
  }
  if (has_zero) parser.warning("a normal of this mesh2 is the zero vector; <1,0,0> is used");
}

// The points' lists, in any order; the list of textures ends them.
void parse_point_lists(Parser& parser, MeshNode& mesh) {
  bool has_vertices = false;
  const auto fresh = [&](bool is_again, const char* what) {
    if (is_again) {
      parser.warning(std::string("this mesh2 has a second list of ") + what +
                     "; the first is forgotten");
    }
  };
  for (;;) {
    if (parser.accept(Keyword::vertex_vectors)) {
      fresh(has_vertices, "vertex_vectors");
      mesh.vertices.clear();
      parse_list(parser, "vertex_vectors", mesh.vertices);
      has_vertices = true;
    } else if (parser.accept(Keyword::normal_vectors)) {
      fresh(!mesh.normals.empty(), "normal_vectors");
      parse_normals(parser, mesh);
    } else if (parser.accept(Keyword::uv_vectors)) {
      fresh(!mesh.uv.empty(), "uv_vectors");
      mesh.uv.clear();
      parse_list(parser, "uv_vectors", mesh.uv);
    } else {
      break;
    }
  }
  if (mesh.vertices.empty()) parser.error("a mesh2 needs vertex_vectors");
  if (parser.accept(Keyword::texture_list)) parse_textures(parser, mesh);
}

// Lists of indices that were left out go with the vertices.
void complete_indices(Parser& parser, MeshNode& mesh) {
  if (!mesh.normals.empty() && mesh.face_normals.empty()) {
    if (mesh.normals.size() != mesh.vertices.size()) {
      parser.error("this mesh2 needs normal_indices: it has not as many normals as vertices");
    }
    mesh.face_normals = mesh.face_vertices;
  }
  if (!mesh.uv.empty() && mesh.face_uv.empty()) {
    if (mesh.uv.size() == mesh.vertices.size()) {
      mesh.face_uv = mesh.face_vertices;
    } else if (mesh.uv.size() == 1) {
      mesh.face_uv.assign(mesh.face_vertices.size(), {0, 0, 0});
    } else {
      parser.error("this mesh2 needs uv_indices: it has not as many uv_vectors as vertices");
    }
  }
}

}  // namespace

ShapeNode parse_mesh2(Parser& parser) {
  MeshNode mesh;
  parse_point_lists(parser, mesh);
  if (!parser.accept(Keyword::face_indices)) parser.error_expected("face_indices");
  parse_faces(parser, mesh);
  if (mesh.face_vertices.empty()) parser.error("a mesh2 needs at least one face");
  check_range(parser, mesh.face_vertices, mesh.vertices.size(), "face_indices");

  for (;;) {
    if (parser.accept(Keyword::normal_indices)) {
      mesh.face_normals.clear();
      parse_index_list(parser, "normal_indices", mesh.face_normals);
    } else if (parser.accept(Keyword::uv_indices)) {
      mesh.face_uv.clear();
      parse_index_list(parser, "uv_indices", mesh.face_uv);
    } else {
      break;
    }
  }
  if (parser.accept(Keyword::inside_vector)) mesh.inside_vector = parser.parse_vector();
  complete_indices(parser, mesh);
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
