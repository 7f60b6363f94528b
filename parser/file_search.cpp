// Finding files (spec/language.md 16), and the second look that forgives case and backslashes.
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <strings.h>

#include "parser/parser_state.h"
#include "tracer/image/raster_file.h"

namespace durer {
namespace {

namespace fs = std::filesystem;

using Extensions = std::initializer_list<const char*>;

Extensions extensions_of(FileType type) {
  static constexpr Extensions kInclude = {".inc", ".INC"}, kFont = {".ttf", ".TTF"},
                              kDensity = {".df3", ".DF3"}, kNone = {};
  switch (type) {
    case FileType::include: return kInclude;
    case FileType::font: return kFont;
    case FileType::density: return kDensity;
    case FileType::user: break;
  }
  return kNone;
}

// An image of no kind is taken for a PNG where its name lacks an extension.
Extensions extensions_of(ImageFileType type) {
  static constexpr Extensions kPng = {".png", ".PNG"}, kTga = {".tga", ".TGA"},
                              kPpm = {".ppm", ".PPM"}, kPgm = {".pgm", ".PGM"},
                              kGif = {".gif", ".GIF"}, kIff = {".iff", ".IFF"},
                              kJpeg = {".jpg", ".JPG", ".jpeg", ".JPEG"},
                              kTiff = {".tif", ".TIF", ".tiff", ".TIFF"}, kBmp = {".bmp", ".BMP"},
                              kExr = {".exr", ".EXR"}, kHdr = {".hdr", ".HDR"},
                              kPot = {".gif", ".GIF", ".pot", ".POT"};
  switch (type) {
    case ImageFileType::tga: return kTga;
    case ImageFileType::ppm: return kPpm;
    case ImageFileType::pgm: return kPgm;
    case ImageFileType::gif: return kGif;
    case ImageFileType::iff: return kIff;
    case ImageFileType::jpeg: return kJpeg;
    case ImageFileType::tiff: return kTiff;
    case ImageFileType::bmp: return kBmp;
    case ImageFileType::exr: return kExr;
    case ImageFileType::hdr: return kHdr;
    case ImageFileType::pot: return kPot;
    default: return kPng;
  }
}

// Those that tell the kind of an image.
constexpr Extensions kImages = {".png", ".tga", ".ppm", ".pgm", ".gif", ".iff", ".jpg",
                                ".jpeg", ".tif", ".tiff", ".bmp", ".exr", ".hdr"};

bool is_file(const std::string& path) {
  struct stat status;
  return stat(path.c_str(), &status) == 0 && !S_ISDIR(status.st_mode);
}

// The names to try, in order.
std::vector<std::string> candidates_of(const std::string& name, Extensions extensions) {
  std::vector<std::string> candidates;
  bool has_extension = false;
  for (const char* extension : extensions) has_extension |= name.ends_with(extension);
  if (has_extension) candidates.push_back(name);
  for (const char* extension : extensions) candidates.push_back(name + extension);
  if (!has_extension) candidates.push_back(name);
  return candidates;
}

bool ends_ignoring_case(const std::string& name, const std::string& end) {
  return name.size() >= end.size() &&
         strcasecmp(name.c_str() + (name.size() - end.size()), end.c_str()) == 0;
}

// The path below `folder` whose components equal those of `name` but for case; empty: none.
std::string match_ignoring_case(const std::string& folder, const fs::path& name) {
  std::string path = folder;
  for (const fs::path& part : name) {
    if (part == "/" || part == ".") continue;
    std::string next = path.empty() ? part.string() : path + "/" + part.string();
    struct stat status;
    if (stat(next.c_str(), &status) != 0) {
      next.clear();
      std::error_code failed;
      // The least name in byte order, so that the choice does not depend on the folder's order.
      for (const auto& entry : fs::directory_iterator(path.empty() ? "." : path, failed)) {
        const std::string candidate = entry.path().filename().string();
        if (strcasecmp(candidate.c_str(), part.c_str()) != 0) continue;
        const std::string full = path.empty() ? candidate : path + "/" + candidate;
        if (next.empty() || full < next) next = full;
      }
      if (next.empty()) return {};
    }
    path = next;
  }
  return is_file(path) ? path : std::string();
}

}  // namespace

std::string Parser::State::find_file(const std::string& name, FileType type, bool forgiving) {
  const Extensions extensions = extensions_of(type);
  const std::string found = find_as_written(name, extensions);
  return found.empty() && forgiving ? find_forgivingly(name, extensions) : found;
}

std::string Parser::State::find_image(const std::string& name, ImageFileType type) {
  if (type == ImageFileType::by_name && fs::path(name).has_extension() &&
      std::none_of(kImages.begin(), kImages.end(),
                   [&](const char* end) { return ends_ignoring_case(name, end); })) {
    error("the name '" + name + "' does not tell what kind of image this is",
          "write the kind before it: png \"" + name + "\"");
  }
  std::string found = find_as_written(name, extensions_of(type));
  if (found.empty()) found = find_forgivingly(name, extensions_of(type));
  if (found.empty() && type == ImageFileType::by_name) found = find_forgivingly(name, kImages);
  return found;
}

std::string Parser::State::find_as_written(const std::string& name, Extensions extensions) const {
  if (name.empty()) return {};
  for (const std::string& candidate : candidates_of(name, extensions)) {
    if (is_file(candidate)) return candidate;
    if (candidate[0] == '/') continue;
    for (const std::string& folder : options.library_paths) {
      const std::string path = folder + (folder.ends_with('/') ? "" : "/") + candidate;
      if (is_file(path)) return path;
    }
  }
  return {};
}

std::string Parser::State::find_forgivingly(const std::string& name, Extensions extensions) {
  if (name.empty()) return {};
  std::string plain = name;
  std::replace(plain.begin(), plain.end(), '\\', '/');
  // Drive letters of other systems name nothing here.
  if (plain.size() > 2 && plain[1] == ':' && plain[2] == '/') plain = plain.substr(3);
  const bool absolute = plain.starts_with('/');
  for (const std::string& candidate : candidates_of(plain, extensions)) {
    std::string found = match_ignoring_case(absolute ? "/" : "", candidate);
    for (size_t i = 0; found.empty() && !absolute && i < options.library_paths.size(); ++i) {
      found = match_ignoring_case(options.library_paths[i], candidate);
    }
    if (!found.empty()) {
      message(Severity::warning, "there is no file '" + name + "'; '" + found + "' is used for it");
      return found;
    }
  }
  return {};
}

bool Parser::State::path_exists(const std::string& name) const {
  const auto exists = [](const std::string& path) {
    struct stat status;
    return stat(path.c_str(), &status) == 0;
  };
  return exists(name) ||
         (!name.starts_with('/') &&
          std::any_of(options.library_paths.begin(), options.library_paths.end(),
                      [&](const std::string& folder) { return exists(folder + "/" + name); }));
}

// The file's tokens are kept as long as its content is the same.
std::shared_ptr<SourceFile> Parser::State::load_source(const std::string& path) {
  std::shared_ptr<SourceFile>& known = sources[path];
  if (known && written_files.empty()) return known;
  std::string text;
  if (!read_file(path, std::min<uint64_t>(options.limits.max_file_bytes, 0xfffffff0u), text)) {
    error("cannot read the file '" + path + "', or it is too long");
  }
  if (known && known->text() == text) return known;
  known = std::make_shared<SourceFile>(path, std::move(text), names);
  all_files.push_back(known);
  return known;
}

std::shared_ptr<const RasterFile> Parser::read_image(const std::string& path, ImageFileType type) {
  std::weak_ptr<const RasterFile>& known = state_->images[{path, type}];
  if (auto image = known.lock()) return image;
  try {
    auto image = std::make_shared<const RasterFile>(read_raster(path, type));
    known = image;
    return image;
  } catch (const std::runtime_error& failure) {
    error(failure.what());
  }
}

}  // namespace durer
