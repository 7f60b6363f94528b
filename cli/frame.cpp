#include "cli/frame.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/interrupt.h"
#include "cli/method_comparison.h"
#include "cli/output_name.h"
#include "cli/picture_file.h"
#include "cli/progress.h"
#include "cli/render_watch.h"
#include "parser/parse_scene.h"
#include "tracer/sampling/render.h"
#include "tracer/scene/not_supported.h"
#include "tracer/shading/whitted.h"
#include "tracer/world/pattern_services.h"

namespace durer {
namespace {

// Wall seconds since the last call.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

ParseOptions parse_options(const Options& options, const FrameSettings& frame, Console& console) {
  ParseOptions parse;
  parse.remove_bounds = options.remove_bounds;
  parse.input_file = frame.scene_path;
  parse.input_name = options.input_file;
  parse.library_paths = options.library_paths;
  parse.include_header = options.include_header;
  parse.clock = frame.clock;
  parse.clock_given = frame.clock_given;
  parse.image_width = options.render.width;
  parse.image_height = options.render.height;
  const Animation& animation = options.animation;
  if (animation.on) {
    parse.frame_number = frame.number;
    parse.initial_frame = animation.first;
    parse.final_frame = animation.last;
    parse.initial_clock = animation.initial_clock;
    parse.final_clock = animation.final_clock;
    parse.clock_delta = animation.clock_delta;
  }
  parse.declares = options.declares;
  parse.version = options.language_version;
  parse.output_alpha = options.output_alpha;
  if (options.max_loop_turns > 0) {
    parse.limits.max_loop_turns = static_cast<uint64_t>(options.max_loop_turns);
  }
  if (options.max_array_elements > 0) {
    parse.limits.max_array_elements = static_cast<uint64_t>(options.max_array_elements);
  }
  if (options.max_objects > 0) {
    parse.limits.max_objects = static_cast<uint64_t>(options.max_objects);
  }
  if (options.max_macro_depth > 0) {
    parse.limits.max_symbol_tables = options.max_macro_depth;
    // Each macro has room for some loops and conditionals around the next call.
    parse.limits.max_nesting = std::max(parse.limits.max_nesting, 4 * options.max_macro_depth);
  }
  parse.writes.output_folder = folder_of(options.output_name);
  parse.writes.folders = options.writable_folders;
  parse.sink = &console;
  return parse;
}

std::string counted(int number, const char* what) {
  return std::to_string(number) + what + (number == 1 ? "" : "s");
}

bool exists_and_not_empty(const std::string& path) {
  struct stat status;
  return stat(path.c_str(), &status) == 0 && status.st_size > 0;
}

// All that a block's pixels depend on, as far as this command knows it.
std::string state_identity(const Options& options, const FrameSettings& frame) {
  const RenderOptions& r = options.render;
  struct stat scene {};
  stat(frame.scene_path.c_str(), &scene);
  char text[512];
  std::snprintf(text, sizeof text,
                "%dx%d window %d %d %d %d quality %d integrator %d antialiasing %d %d %.9g %d %.9g "
                "%.9g block %d alpha %d bits %d clock %.9g frame %d scene %lld %lld.%09ld",
                r.width, r.height, r.window.left, r.window.top, r.window.right, r.window.bottom,
                r.quality, static_cast<int>(r.integrator), static_cast<int>(r.supersampling),
                r.grid_samples, r.antialias_threshold, r.antialias_depth, r.jitter_amount,
                r.antialias_gamma, r.block_size, r.output_alpha ? 1 : 0, significant_bits(options),
                frame.clock, frame.number,
                static_cast<long long>(scene.st_size),
                static_cast<long long>(scene.st_mtim.tv_sec), scene.st_mtim.tv_nsec);
  return text;
}

// The scene made ready for one camera.
struct PreparedView {
  PreparedView(const Scene& from, std::vector<ObjectPtr> objects, const CameraNode& node,
               const Options& options)
      : PreparedView(from, std::move(objects), node, options,
                     {options.render.quality, options.output_alpha,
                      significant_bits(options)}) {}

  ShadingScene scene;
  Camera camera;

 private:
  PreparedView(const Scene& from, std::vector<ObjectPtr> objects, const CameraNode& node,
               const Options& options, const ShadingOptions& shading)
      : scene(from, std::move(objects),
              {options.bounding_threshold, options.remove_bounds, options.split_unions}, shading),
        camera(node, options.render.width, options.render.height,
               WorldPatternServices(texture_settings(from, shading), from.settings).settings()) {}
};

WhittedIntegrator make_integrator(const ShadingScene& scene, IntegratorKind kind) {
  return {scene, kind == IntegratorKind::raycast ? WhittedIntegrator::Depth::raycast
                                                 : WhittedIntegrator::Depth::recursive};
}

class FrameRenderer {
 public:
  FrameRenderer(const Options& options, const FrameSettings& frame, Console& console,
                RunStatistics& run)
      : options_(options), frame_(frame), console_(console), run_(run) {}

  FrameOutcome render() {
    const FrameOutcome outcome = read_and_render();
    if (!options_.animation.on) leave_to_exit();
    return outcome;
  }

 private:
  FrameOutcome read_and_render() {
    parse();
    if (options_.parse_only) {
      run_.frames.push_back(statistics_);
      report_reading();
      return FrameOutcome::done;
    }
    if (options_.compare_methods) return compare_methods();
    if (!options_.clockless_animation || scene_->cameras.size() < 2) {
      return render_camera(*scene_->camera, std::move(scene_->objects), frame_.suffix);
    }
    // One picture per camera, numbered like frames.
    const size_t digits = std::to_string(scene_->cameras.size()).size();
    FrameOutcome outcome = FrameOutcome::done;
    for (size_t i = 0; i < scene_->cameras.size() && outcome != FrameOutcome::stopped; ++i) {
      const std::string number = std::to_string(i + 1);
      outcome = render_camera(*scene_->cameras[i], scene_->objects,
                              std::string(digits - number.size(), '0') + number);
    }
    return outcome;
  }

  // The process ends after the only frame: taking hundreds of thousands of objects apart would be in
  // vain.
  void leave_to_exit() {
    [[maybe_unused]] static const void* volatile left[2];  // where leak checkers look
    left[0] = scene_.release();
    left[1] = view_.release();
  }

  [[noreturn]] void fail(const std::string& text) {
    console_.line(Stream::fatal, "durer: " + text);
    throw FrameFailure();
  }

  void parse() {
    Stopwatch watch;
    const int warnings_before = console_.warnings();
    ParseResult result = parse_scene(parse_options(options_, frame_, console_));
    if (!result.scene) {
      if (result.failure) console_.diagnostic(*result.failure);
      throw FrameFailure();
    }
    scene_ = std::move(result.scene);
    statistics_.frame = frame_.number;
    statistics_.objects = scene_->objects.size();
    statistics_.warnings = console_.warnings() - warnings_before;
    statistics_.parse_seconds = watch.lap();
  }

  void report_reading() {
    console_.line(Stream::render,
                  frame_.scene_path + ": no mistakes found, " +
                      counted(statistics_.warnings, " warning") + ", " +
                      counted(static_cast<int>(statistics_.objects), " object") + " (" +
                      duration_text(statistics_.parse_seconds) + ")");
  }

  // Fails before any work is done if the picture could not be written at its end.
  void check_output(const std::string& path) {
    struct stat status;
    if (stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) {
      fail("cannot write '" + path + "': it is a folder");
    }
    const std::string folder = folder_of(path);
    if (access(folder.empty() ? "." : folder.c_str(), W_OK) != 0) {
      fail("cannot write '" + path + "': " + std::strerror(errno));
    }
  }

  // Takes over the blocks of an interrupted run, or begins a new file.
  void open_state(StateFile& state, Picture& picture, const std::string& path) {
    if (options_.continue_trace) {
      if (state.load(picture) > 0) return;
      console_.line(Stream::render,
                    state.is_file_there()
                        ? "'" + state_path(path) + "' is of another scene, size or setting, or damaged: "
                              "the picture is rendered from its start"
                        : "nothing to continue: the picture is rendered from its start");
    }
    if (!state.create()) {
      fail("cannot write '" + state_path(path) + "': " + std::strerror(errno));
    }
  }

  const PreparedView& prepare(std::vector<ObjectPtr> objects, const CameraNode& camera) {
    view_.reset();
    view_ = std::make_unique<const PreparedView>(*scene_, std::move(objects), camera, options_);
    return *view_;
  }

  FrameOutcome render_camera(const CameraNode& camera_node, std::vector<ObjectPtr> objects,
                             const std::string& suffix) {
    Stopwatch watch;
    const bool to_stream = is_standard_stream(options_.output_name);
    const std::string path =
        to_stream ? options_.output_name
                  : output_path(options_.input_file, options_.output_name, options_.file_type, suffix);
    std::optional<StateFile> state;
    if (options_.output_to_file && !to_stream) {
      state.emplace(state_path(path), state_identity(options_, frame_));
      // A picture beside a state file is a preview of one that is not finished.
      if (options_.continue_trace && exists_and_not_empty(path) && !state->exists()) {
        console_.line(Stream::render, path + " is there already; nothing is rendered");
        return FrameOutcome::already_there;
      }
      check_output(path);
    }

    const PreparedView& view = prepare(std::move(objects), camera_node);
    const WhittedIntegrator integrator = make_integrator(view.scene, options_.render.integrator);
    statistics_.lights = view.scene.world->lights().size();
    statistics_.build_seconds = watch.lap();

    try {
      const std::unique_ptr<Picture> picture =
          make_picture(options_.render.width, options_.render.height,
                       options_.most_picture_bytes, folder_of(path));
      if (state) {
        open_state(*state, *picture, path);
        // No old picture stays under the name of one that is not finished.
        std::remove(path.c_str());
      }
      if (!render_blocks(view, integrator, options_.render, path, state ? &*state : nullptr,
                         *picture)) {
        return FrameOutcome::stopped;
      }
      statistics_.render_seconds = watch.lap();
      if (options_.output_to_file) {
        write_picture(path, *picture, options_, *scene_);
        statistics_.output = path;
        if (state) state->remove();
      }
    } catch (const std::runtime_error& error) {
      fail(error.what());
    }
    statistics_.write_seconds = watch.lap();
    report(path);
    run_.frames.push_back(statistics_);
    return FrameOutcome::done;
  }

  // The whole picture by every method, on one sheet.
  FrameOutcome compare_methods() {
    Stopwatch watch;
    const std::string path =
        is_standard_stream(options_.output_name)
            ? options_.output_name
            : output_path(options_.input_file, options_.output_name, options_.file_type,
                    (options_.output_name.empty() ? "-methods" : "") + frame_.suffix);
    if (options_.output_to_file && !is_standard_stream(path)) check_output(path);
    const PreparedView& view = prepare(std::move(scene_->objects), *scene_->camera);
    statistics_.lights = view.scene.world->lights().size();
    statistics_.build_seconds = watch.lap();

    std::vector<MethodResult> results;
    for (const Method& method : compared_methods(options_.render.grid_samples)) {
      RenderOptions render = options_.render;
      render.window = {0, 0, render.width, render.height};
      render.integrator = method.integrator;
      render.supersampling = method.supersampling;
      Framebuffer picture(render.width, render.height);
      const WhittedIntegrator integrator = make_integrator(view.scene, method.integrator);
      const double cpu_before = process_cpu_seconds();
      if (!render_blocks(view, integrator, render, path, nullptr, picture)) {
        return FrameOutcome::stopped;
      }
      results.push_back({method, std::move(picture), statistics_.render,
                         process_cpu_seconds() - cpu_before});
      statistics_.method = method.name;
      statistics_.render_seconds = watch.lap();
      statistics_.output = path;
      run_.frames.push_back(statistics_);
    }
    for (const std::string& line : method_table(results)) console_.line(Stream::render, line);
    if (!options_.output_to_file) return FrameOutcome::done;
    try {
      write_picture(path, method_sheet(results), options_, *scene_);
    } catch (const std::runtime_error& error) {
      fail(error.what());
    }
    console_.line(Stream::render, "Picture: " + path);
    return FrameOutcome::done;
  }

  // False: stopped by a signal.
  bool render_blocks(const PreparedView& view, const Integrator& integrator,
                     const RenderOptions& options, const std::string& path, StateFile* state,
                     Picture& picture) {
    const PixelWindow& window = options.window;
    const int64_t pixels = static_cast<int64_t>(std::max(window.width(), 0)) *
                           std::max(window.height(), 0);
    Progress progress(console_, pixels, options_.verbose);
    RenderWatch watch(progress, state, [&](const std::string& text) {
      console_.line(Stream::warning, "durer: warning: " + text);
    });
    if (options_.preview_interval > 0 && state) {
      watch.preview(picture, options.block_size, options_.preview_interval,
                    [&](const Picture& finished) {
                      write_picture(path, finished, options_, *scene_);
                    });
    }
    begin_stoppable();
    statistics_.render = durer::render(view.scene, view.camera, integrator, options, picture,
                                       watch, stop_requested());
    end_stoppable();
    progress.finish();
    if (!stop_requested()) return true;
    if (state) {
      // What the preview wrote is no finished picture.
      std::remove(path.c_str());
      console_.line(Stream::fatal, "stopped; the finished blocks are kept in " + state_path(path) +
                                       ", add +C to go on");
    }
    return false;
  }

  void report(const std::string& path) {
    const std::string times = "(" + duration_text(statistics_.parse_seconds) + " reading, " +
                              duration_text(statistics_.build_seconds) + " building, " +
                              duration_text(statistics_.render_seconds) + " rendering)";
    console_.line(Stream::statistic, statistics_text(statistics_));
    console_.line(Stream::render,
                  (statistics_.output.empty() ? "Rendered, not written" : "Picture: " + path) + " " +
                      times);
  }

  const Options& options_;
  const FrameSettings& frame_;
  Console& console_;
  RunStatistics& run_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<const PreparedView> view_;
  FrameStatistics statistics_;
};

}  // namespace

FrameOutcome render_frame(const Options& options, const FrameSettings& frame, Console& console,
                          RunStatistics& run) {
  return FrameRenderer(options, frame, console, run).render();
}

}  // namespace durer
