// TIFF and OpenEXR, read directly, against OpenImageIO; palettes of Targa, BMP and GIF; broken files.
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

struct Source {
  RasterFile (*read)(const std::string&);
  const char* name;
};

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

TEST(ImageFiles, TargaAndBmpKeepIndices) {
  // What make_mapped.py writes: the index is (x + 2 y) mod 13; runs begin with two of the first.
  for (const auto& [read, name] :
       {Source{read_tga, "mapped.tga"}, {read_tga, "mapped_runs.tga"}, {read_bmp, "nibbles.bmp"},
        {read_bmp, "short_entries.bmp"}, {read_bmp, "runs.bmp"}}) {
    const RasterFile file = read(kFolder + name);
    ASSERT_TRUE(file.is_palette()) << name;
    ASSERT_EQ(file.bytes.size(), 18u * 17u) << name;
    const bool has_runs = std::string(name).find("runs") != std::string::npos;
    for (size_t i = 0; i < file.bytes.size(); ++i) {
      const size_t x = has_runs && i % 18 == 1 ? 0 : i % 18;
      ASSERT_EQ(file.bytes[i], (x + 2 * (i / 18)) % 13) << name << " pixel " << i;
    }
  }
}

TEST(ImageFiles, WordsOfTargasAreTimesEightAndTheirTopBitIsAlpha) {
  const RasterFile file = read_tga(kFolder + "words.tga");
  ASSERT_EQ(file.channels, 4);
  for (size_t i = 0; i < 18; ++i) {
    EXPECT_EQ(file.bytes[4 * i] % 8, 0);
    EXPECT_EQ(file.bytes[4 * i + 3], i % 13 % 3 > 0 ? 255 : 0) << i;
  }
  EXPECT_EQ(read_tga(kFolder + "words15.tga").channels, 3);
}

TEST(ImageFiles, RowsOfInterlacedGifsStayInTheOrderOfTheFile) {
  const RasterFile file = read_gif(kFolder + "interlaced.gif");
  const size_t order[] = {0, 8, 16, 4, 12, 2, 6, 10, 14, 1, 3, 5, 7, 9, 11, 13, 15};
  for (size_t y = 0; y < 17; ++y) EXPECT_EQ(file.bytes[18 * y], 2 * order[y] % 13) << y;
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

TEST(ImageFiles, CutOffTargasAndBmpsAreErrors) {
  for (const auto& [read, name] :
       {Source{read_tga, "mapped.tga"}, {read_tga, "mapped_runs.tga"}, {read_tga, "rgb.tga"},
        {read_bmp, "nibbles.bmp"}, {read_bmp, "runs.bmp"}, {read_bmp, "rgb.bmp"}}) {
    const std::vector<char> whole = content_of(name);
    for (size_t length = 0; length + 28 < whole.size(); ++length) {
      const TemporaryFile file({whole.begin(), whole.begin() + static_cast<long>(length)});
      EXPECT_THROW(read(file.path()), std::runtime_error) << name << " cut at " << length;
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
