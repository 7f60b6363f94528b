// No scene of the gallery allocates memory per ray: four times as many rays, as many allocations.
//
// Each scene is read and made ready once. A first picture, which is not counted, fills the tables that
// a thread keeps; then what the rendering thread allocates for 4 rows of pixels and for 16 must be the
// same number. Both are one block, and what a block allocates for its columns is the same, too.
// Reading is not counted: OpenImageIO shares its work among threads of its own and the caller's, so
// what that allocates varies from run to run by hundreds.
//
//     allocations_per_ray FOLDER [PART OF A NAME]
#include <sys/types.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "parser/parse_scene.h"
#include "tracer/sampling/render.h"
#include "tracer/scene/not_supported.h"
#include "tracer/shading/whitted.h"
#include "tracer/world/pattern_services.h"

namespace {
// Of this thread, while it counts. operator new calls malloc.
thread_local bool counting = false;
thread_local unsigned long allocations = 0;

void count_one() {
  if (counting) ++allocations;
}
}  // namespace

// glibc's own functions under the names that every library calls.
extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* block, size_t size);
void* __libc_memalign(size_t alignment, size_t size);

void* malloc(size_t size) {
  count_one();
  return __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
  count_one();
  return __libc_calloc(count, size);
}
void* realloc(void* block, size_t size) {
  count_one();
  return __libc_realloc(block, size);
}
void* memalign(size_t alignment, size_t size) {
  count_one();
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  count_one();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, size_t alignment, size_t size) {
  count_one();
  *block = __libc_memalign(alignment, size);
  return *block ? 0 : 12;  // ENOMEM
}
}

namespace durer {
namespace {

namespace fs = std::filesystem;

constexpr int kColumns = 16, kFewRows = 4, kManyRows = 16;
constexpr int kLeastScenes = 370;

struct Way {
  const char* name;
  Supersampling supersampling;
};
constexpr Way kWays[] = {{"without antialiasing", Supersampling::none},
                         {"+AM1", Supersampling::method1},
                         {"+AM2", Supersampling::method2}};

class NoObserver : public RenderObserver {
 public:
  void block_done(const Framebuffer&) override {}
};

// Allocations of one picture.
unsigned long count(const ShadingScene& scene, const CameraNode& node, Supersampling supersampling,
                    int rows) {
  RenderOptions options;
  options.width = kColumns;
  options.height = rows;
  options.window = {0, 0, kColumns, rows};
  options.supersampling = supersampling;
  const Camera camera(node, kColumns, rows,
                      WorldPatternServices(texture_settings(scene.scene, scene.options),
                                           scene.scene.settings)
                          .settings());
  const WhittedIntegrator integrator(scene, WhittedIntegrator::Depth::recursive);
  Framebuffer picture(kColumns, rows);
  NoObserver observer;
  const std::atomic<bool> stop = false;
  allocations = 0;
  counting = true;
  render(scene, camera, integrator, options, picture, observer, stop);
  counting = false;
  return allocations;
}

// The scene's ways of rendering that allocate per ray.
int failures_of(const fs::path& path) {
  fs::current_path(path.parent_path());
  ParseOptions parse;
  parse.input_file = path.filename();
  parse.library_paths = {"/usr/share/povray-3.7/include"};
  parse.image_width = parse.image_height = kManyRows;
  const ParseResult result = parse_scene(parse);
  if (!result.scene) throw std::runtime_error("it cannot be read");
  Scene& scene = *result.scene;
  const ShadingScene shading(scene, std::move(scene.objects), {}, {});
  int failures = 0;
  for (const Way& way : kWays) {
    count(shading, *scene.camera, way.supersampling, kManyRows);
    const unsigned long few = count(shading, *scene.camera, way.supersampling, kFewRows);
    const unsigned long many = count(shading, *scene.camera, way.supersampling, kManyRows);
    if (few == many) continue;
    ++failures;
    std::printf("%s %s: %lu allocations for %d pixels, %lu for %d\n", path.c_str(), way.name, few,
                kColumns * kFewRows, many, kColumns * kManyRows);
  }
  return failures;
}

int check_all(const fs::path& folder, const std::string& part) {
  std::vector<fs::path> scenes;
  for (const auto& entry : fs::recursive_directory_iterator(fs::absolute(folder))) {
    const fs::path& path = entry.path();
    if (path.extension() == ".pov" && path.string().find(part) != std::string::npos) {
      scenes.push_back(path);
    }
  }
  std::sort(scenes.begin(), scenes.end());
  int counted = 0, failures = 0;
  for (const fs::path& path : scenes) {
    try {
      failures += failures_of(path);
      ++counted;
    } catch (const NotSupported&) {
    } catch (const std::exception& error) {
      ++failures;
      std::printf("%s: %s\n", path.c_str(), error.what());
    }
  }
  std::printf("%d scenes, %d failures\n", counted, failures);
  return failures || (part.empty() && counted < kLeastScenes) ? 1 : 0;
}

}  // namespace
}  // namespace durer

int main(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(stderr, "allocations_per_ray FOLDER [PART OF A NAME]\n");
    return 2;
  }
  return durer::check_all(arguments[1], count > 2 ? arguments[2] : "");
}
