// TIFF and OpenEXR, read directly, against OpenImageIO; broken files.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tracer/image/raster_file.h"

namespace durer {
namespace {

const std::string kFolder = std::string(DURER_SOURCE_DIR) + "/scenes/gallery/images/";

std::vector<char> content_of(const std::string& name) {
  std::ifstream stream(kFolder + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::vector<char>& content)
      : path_(std::filesystem::temp_directory_path() /
              ("durer_image_files_test_" + std::to_string(getpid()))) {
    std::ofstream(path_, std::ios::binary)
        .write(content.data(), static_cast<std::streamsize>(content.size()));
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

// The same picture through OpenImageIO.
void expect_as_openimageio(RasterFile (&read)(const std::string&), const char* name) {
  SCOPED_TRACE(name);
  const RasterFile ours = read(kFolder + name);
  const RasterFile theirs = read_with_openimageio(kFolder + name);
  EXPECT_EQ(ours.width, theirs.width);
  EXPECT_EQ(ours.height, theirs.height);
  EXPECT_EQ(ours.channels, theirs.channels);
  EXPECT_EQ(ours.bits, theirs.bits);
  EXPECT_EQ(ours.bytes, theirs.bytes);
  EXPECT_EQ(ours.floats, theirs.floats);
}

TEST(ImageFiles, TiffsOfBytesAreAsOpenImageIoReadsThem) {
  for (const char* name : {"grey.tif", "grey_white.tif", "grey_associated.tif", "rgb.tif",
                           "packbits.tif", "associated.tif"}) {
    expect_as_openimageio(read_tiff, name);
  }
}

TEST(ImageFiles, WordsOfTiffsAreRoundedToBytes) {
  const RasterFile ours = read_tiff(kFolder + "deflate16.tif");
  const RasterFile theirs = read_with_openimageio(kFolder + "deflate16.tif");
  ASSERT_EQ(ours.bytes.size(), theirs.words.size());
  for (size_t i = 0; i < ours.bytes.size(); ++i)
    ASSERT_EQ(ours.bytes[i], (theirs.words[i] + 128) / 257) << i;
}

TEST(ImageFiles, PalettesOfTiffsKeepIndicesAndWords) {
  const RasterFile ours = read_tiff(kFolder + "palette.tif");
  ASSERT_TRUE(ours.is_palette());
  EXPECT_EQ(ours.palette[1], (std::array<uint16_t, 4>{255, 49858, 129, 65535}));
  EXPECT_EQ((std::vector<uint8_t>(ours.bytes.begin(), ours.bytes.begin() + 6)),
            (std::vector<uint8_t>{0, 0, 1, 1, 2, 2}));
  EXPECT_EQ(read_tiff(kFolder + "palette_bytes.tif").palette[1],
            (std::array<uint16_t, 4>{0, 194 * 257, 0, 65535}));
}

TEST(ImageFiles, HalfFloatsOfExrsAreAsOpenImageIoReadsThem) {
  for (const char* name : {"none.exr", "zips.exr", "floats.exr", "grey.exr", "grey_alpha.exr",
                           "negative.exr", "window.exr"}) {
    expect_as_openimageio(read_exr, name);
  }
}

TEST(ImageFiles, CutOffFilesAreErrors) {
  for (const char* name : {"rgba.tif", "deflate16.tif", "none.exr", "zip_float.exr"}) {
    const std::vector<char> whole = content_of(name);
    const bool is_exr = std::string(name).ends_with("exr");
    ASSERT_FALSE(whole.empty()) << name;
    for (size_t length = 0; length < whole.size() - 8; length += 1 + whole.size() / 50) {
      const TemporaryFile file({whole.begin(), whole.begin() + static_cast<long>(length)});
      EXPECT_THROW(is_exr ? read_exr(file.path()) : read_tiff(file.path()), std::runtime_error)
          << name << " cut at " << length;
    }
  }
}

TEST(ImageFiles, SizesBeyondTheFileAreErrors) {
  const TemporaryFile file(content_of("grey.tif"));
  EXPECT_NO_THROW(check_size(file.path(), 20, 14));
  EXPECT_THROW(check_size(file.path(), 60000, 60000), std::runtime_error);
  EXPECT_THROW(check_size(file.path(), int64_t{1} << 40, int64_t{1} << 40), std::runtime_error);
  EXPECT_THROW(check_size(file.path(), 0, 14), std::runtime_error);
}

}  // namespace
}  // namespace durer
