// The grammar of switches, INI lines and long options. Expected values were read from the installed
// povray's Create_INI (+GI).
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "cli/help.h"
#include "cli/option_reader.h"
#include "cli/options.h"
#include "cli/output_name.h"
#include "cli/shell.h"

namespace durer {
namespace {

std::string ini_of(const std::vector<std::string>& arguments) {
  OptionValues values;
  OptionReader reader(values);
  reader.read_arguments(arguments);
  return values.to_ini();
}

void expect_error(const std::vector<std::string>& arguments) {
  EXPECT_THROW(ini_of(arguments), OptionError) << arguments[0];
}

Options options_of(const std::vector<std::string>& arguments) {
  OptionValues values;
  OptionReader reader(values);
  reader.read_arguments(arguments);
  return resolve_options(values);
}

// A file of this test, removed at its end.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& extension, const std::string& content) {
    static int count = 0;
    path_ = ::testing::TempDir() + "durer_cli_" + std::to_string(getpid()) + "_" +
            std::to_string(count++) + extension;
    std::FILE* file = std::fopen(path_.c_str(), "wb");
    std::fwrite(content.data(), 1, content.size(), file);
    std::fclose(file);
  }
  ~TemporaryFile() { std::remove(path_.c_str()); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

TEST(CliSwitches, PlainValues) {
  EXPECT_EQ(ini_of({"+W640", "+H480"}), "Height=480\nWidth=640\n");
  EXPECT_EQ(ini_of({"-W7"}), "Width=7\n");
  EXPECT_EQ(ini_of({"+w8", "+h5x"}), "Height=5\nWidth=8\n");
  EXPECT_EQ(ini_of({"+W8 +H3"}), "Height=3\nWidth=8\n");
  EXPECT_EQ(ini_of({"Width=7 Height=8"}), "Height=8\nWidth=7\n");
  EXPECT_EQ(ini_of({"width=5x"}), "Width=5\n");
  EXPECT_EQ(ini_of({"+I\"a b.pov\""}), "Input_File_Name=\"a b.pov\"\n");
  EXPECT_EQ(ini_of({"some/scene.pov"}), "Input_File_Name=\"some/scene.pov\"\n");
  EXPECT_EQ(ini_of({"S.POV"}), "Input_File_Name=\"S.POV\"\n");
  EXPECT_EQ(ini_of({"sub/"}), "Library_Path=\"sub/\"\n");
  EXPECT_EQ(ini_of({"+L/a", "+Lb", "+L/a"}), "Library_Path=\"/a\"\nLibrary_Path=\"b\"\n");
}

TEST(CliSwitches, LongestNameWins) {
  EXPECT_EQ(ini_of({"+K.5"}), "Clock=0.5\n");
  EXPECT_EQ(ini_of({"+KC"}), "Cyclic_Animation=On\n");
  EXPECT_EQ(ini_of({"+KF2"}), "Final_Clock=2\n");
  EXPECT_EQ(ini_of({"+KFF9"}), "Final_Frame=9\n");
  EXPECT_EQ(ini_of({"+KFI3"}), "Initial_Frame=3\n");
  EXPECT_EQ(ini_of({"+KI1"}), "Initial_Clock=1\n");
  EXPECT_EQ(ini_of({"+KLA"}), "Clockless_Animation=On\n");
  EXPECT_EQ(ini_of({"+R4"}), "Antialias_Depth=4\n");
  EXPECT_EQ(ini_of({"+RP3"}), "Render_Pattern=3\n");
  EXPECT_EQ(ini_of({"+RFfoo"}), "Radiosity_File_Name=\"foo\"\n");
  EXPECT_EQ(ini_of({"+RFI"}), "Radiosity_From_File=On\n");
  EXPECT_EQ(ini_of({"+MB"}), "Bounding=On\n");
  EXPECT_EQ(ini_of({"-B"}), "Bounding=Off\n");
}

TEST(CliSwitches, SignOfAValueSwitch) {
  EXPECT_EQ(ini_of({"+A0.3"}), "Antialias=On\nAntialias_Threshold=0.3\n");
  EXPECT_EQ(ini_of({"-A0.2"}), "Antialias=Off\nAntialias_Threshold=0.2\n");
  EXPECT_EQ(ini_of({"+A05"}), "Antialias=On\nAntialias_Threshold=5\n");
  EXPECT_EQ(ini_of({"-J0.5"}), "Jitter_Amount=0.5\nJitter=Off\n");
  EXPECT_EQ(ini_of({"+J"}), "Jitter=On\n");
  EXPECT_EQ(ini_of({"-MB7"}), "Bounding=Off\nBounding_Threshold=7\n");
  EXPECT_EQ(ini_of({"+X5"}), "Test_Abort_Count=5\nTest_Abort=On\n");
  EXPECT_EQ(ini_of({"-GAfile"}), "All_Console=Off\nAll_File=\"file\"\n");
  EXPECT_EQ(ini_of({"+GDx.txt"}), "Debug_Console=On\nDebug_File=\"x.txt\"\n");
  EXPECT_EQ(ini_of({"+D0"}), "Display=On\nVideo_Mode=0\n");
}

TEST(CliSwitches, FileType) {
  EXPECT_EQ(ini_of({"+F"}), "Output_To_File=On\n");
  EXPECT_EQ(ini_of({"-F"}), "Output_To_File=Off\n");
  EXPECT_EQ(ini_of({"+FN16"}), "Bits_Per_Color=16\nOutput_File_Type=N\nOutput_To_File=On\n");
  EXPECT_EQ(ini_of({"+fj"}), "Output_File_Type=J\nOutput_To_File=On\n");
  EXPECT_EQ(ini_of({"+FNg"}), "Grayscale_Output=On\nOutput_File_Type=N\nOutput_To_File=On\n");
  EXPECT_EQ(ini_of({"Output_File_Type=N16"}), "Output_File_Type=N\n");
  expect_error({"+FN16g"});
  expect_error({"+FNg16"});
  expect_error({"+FTg"});
  expect_error({"+FX"});
  expect_error({"Output_File_Type=X"});
}

TEST(CliSwitches, SubsetFrames) {
  EXPECT_EQ(ini_of({"+SF1.5"}), "Subset_Start_Frame=1\n");
  EXPECT_EQ(ini_of({"+SF0.3"}), "Subset_Start_Frame=0.3\n");
  EXPECT_EQ(ini_of({"+EF0.25"}), "Subset_End_Frame=0.25\n");
  EXPECT_EQ(ini_of({"Subset_End_Frame=2.5"}), "Subset_End_Frame=2.5\n");
}

TEST(CliSwitches, WhatPovrayRefuses) {
  for (const char* argument :
       {"+ZZ", "+A1.0", "+A.3", "+A1", "+B5", "+P1", "+T", "+S5", "+E3", "+QR", "+GPx", "+K", "+AG",
        "+SF", "+HI", "+SRx", "+Kabc", "+CC", "+X-", "+VV", "+V5", "+UAx", "+RF", "+THX", "+HTx",
        "+W8;+H3", "Width=7;Height=8", "Width=abc", "Foo=3", "Clock=x", "Sampling_Method=x",
        "Display_Gamma=abc", "File_Gamma=0", "Dither_Method=xx", "Buffer_Output=on",
        "no_such_file"}) {
    expect_error({argument});
  }
  expect_error({"+W", "20"});
}

TEST(CliSwitches, BooleansCompareTheShorter) {
  for (const char* text : {"", "on", "true", "yes", "1", "o", "t", "YES", "1x", "only"}) {
    if (std::string(text) == "only") continue;
    EXPECT_TRUE(read_toggle(text)) << text;
  }
  for (const char* text : {"off", "no", "0", "false", "maybe"}) {
    EXPECT_FALSE(read_toggle(text)) << text;
  }
}

TEST(CliSwitches, Declarations) {
  const Options options = options_of({"Declare=foo=3", "Declare='bar=\"a b\"'"});
  ASSERT_EQ(options.declares.size(), 2u);
  EXPECT_EQ(options.declares[0], std::make_pair(std::string("foo"), std::string("3")));
  EXPECT_EQ(options.declares[1], std::make_pair(std::string("bar"), std::string("\"a b\"")));
  EXPECT_TRUE(options_of({"Declare=foo", "Declare=foo=", "Declare==3"}).declares.empty());
  expect_error({"Declare=foo=\"abc\""});
}

TEST(CliLongOptions, StandBesideTheSwitches) {
  EXPECT_EQ(ini_of({"--width", "640", "--height=480"}), "Height=480\nWidth=640\n");
  EXPECT_EQ(ini_of({"--antialias", "--no-jitter"}), "Antialias=On\nJitter=Off\n");
  EXPECT_EQ(ini_of({"--antialias-threshold", "0.1"}), "Antialias=On\nAntialias_Threshold=0.1\n");
  EXPECT_EQ(ini_of({"--output", "a b.png"}), "Output_File_Name=\"a b.png\"\n");
  expect_error({"--width"});
  expect_error({"--no-width"});
  expect_error({"--nonsense"});
}

// What an OptionError says; empty: there was none.
std::string error_of(const std::vector<std::string>& arguments) {
  try {
    ini_of(arguments);
  } catch (const OptionError& error) {
    return error.what();
  }
  return "";
}

TEST(CliLongOptions, TakeWholeWordsOnly) {
  EXPECT_NE(error_of({"--width", "12abc"}).find("'12abc'"), std::string::npos);
  EXPECT_NE(error_of({"--max-memory=2GB"}).find("a number"), std::string::npos);
  EXPECT_NE(error_of({"--type", "webp"}).find("tiff"), std::string::npos);
  EXPECT_NE(error_of({"--declare", "size"}).find("NAME=VALUE"), std::string::npos);
  EXPECT_NE(error_of({"--dither=maybe"}).find("on or off"), std::string::npos);
  EXPECT_EQ(ini_of({"--dither=off", "--clock=-1e2", "--type=jpg"}),
            "Clock=-100\nDither=Off\nOutput_File_Type=J\nOutput_To_File=On\n");
}

TEST(CliLongOptions, SlipsAreAnsweredWithTheNearestName) {
  EXPECT_NE(error_of({"--heigth", "20"}).find("did you mean --height?"), std::string::npos);
  EXPECT_NE(error_of({"+W", "20"}).find("+WN"), std::string::npos);
}

TEST(CliSwitches, WhatIsReadInPartIsNoted) {
  const auto notes_of = [](const std::vector<std::string>& arguments) {
    OptionValues values;
    OptionReader reader(values);
    reader.read_arguments(arguments);
    return reader.notes();
  };
  EXPECT_EQ(notes_of({"+W20x"}),
            std::vector<std::string>{"command line: Width: '20x' is read as 20"});
  EXPECT_EQ(notes_of({"Antialias=maybe"}),
            std::vector<std::string>{"command line: Antialias: 'maybe' is read as off"});
  EXPECT_EQ(notes_of({"Width=3.7"}).size(), 1u);
  const TemporaryFile blanks(".ini", "Width=20 ; behind blanks\nAntialias=on  \n; the end\n");
  EXPECT_TRUE(notes_of({blanks.path()}).empty());
  EXPECT_TRUE(notes_of({"+W20", "+A0.3", "Antialias=On", "+K-1.5e1", "+FN16", "+THB2"}).empty());
}

TEST(CliIni, SectionsCommentsAndLists) {
  const TemporaryFile file(".ini",
                           "; a comment\r\n"
                           "Width = 320 ; and another\n"
                           "Height=240 Quality=3\n"
                           "Library_Path=\"/a\", \"/b\"\r"
                           "+A0.2 -J scene.pov\n"
                           "[small]\nWidth=32\n[LARGE]\nWidth=3200\n[small] Height=24\n");
  EXPECT_EQ(ini_of({file.path()}),
            "Antialias=On\nAntialias_Threshold=0.2\nHeight=240\nInput_File_Name=\"scene.pov\"\n"
            "Jitter=Off\nLibrary_Path=\"/a\"\nLibrary_Path=\"/b\"\nWidth=320\n");
  EXPECT_NE(ini_of({file.path() + "[Small]"}).find("Height=24\n"), std::string::npos);
  EXPECT_NE(ini_of({file.path() + "[large]"}).find("Width=3200\n"), std::string::npos);
  EXPECT_NE(ini_of({file.path() + "[none]"}).find("Width=320\n"), std::string::npos);
  EXPECT_NE(ini_of({file.path() + "[\"small\"]"}).find("Height=24\n"), std::string::npos);
  expect_error({file.path() + "[small"});
  // Later settings win, on whichever side of the file they stand.
  EXPECT_NE(ini_of({"+W5", file.path()}).find("Width=320\n"), std::string::npos);
  EXPECT_NE(ini_of({file.path(), "+W5"}).find("Width=5\n"), std::string::npos);
}

TEST(CliIni, ValuesOfSeveralWords) {
  const TemporaryFile file(".ini", "Output_File_Name=my picture.png ; name\nWidth=3 Height=4\n");
  OptionValues values;
  OptionReader reader(values);
  reader.read_ini(file.path());
  EXPECT_EQ(values.to_ini(), "Output_File_Name=\"my picture.png \"\nWidth=3\n");
  EXPECT_EQ(reader.notes().size(), 2u);
}

TEST(CliIni, CommandsAreTakenRaw) {
  const TemporaryFile file(".ini", "Post_Frame_Command=echo \"%s; x\" done ; comment\n");
  EXPECT_EQ(ini_of({file.path()}), "Post_Frame_Command=\"echo \"%s; x\" done\"\n");
}

TEST(CliIni, ErrorsNameTheLine) {
  const TemporaryFile file(".ini", "Width=3\nNonsense=4\n");
  try {
    ini_of({file.path()});
    FAIL() << "an unknown name was accepted";
  } catch (const OptionError& error) {
    EXPECT_NE(std::string(error.what()).find(file.path() + ":2: "), std::string::npos);
  }
}

TEST(CliIni, ObsoleteNamesAreNoted) {
  const TemporaryFile file(".ini", "Buffer_Output=on\nWidth=3\n");
  OptionValues values;
  OptionReader reader(values);
  reader.read_ini(file.path());
  EXPECT_EQ(values.to_ini(), "Width=3\n");
  EXPECT_EQ(reader.notes().size(), 1u);
}

TEST(CliIni, EndlessInclusionStops) {
  const TemporaryFile file(".ini", "");
  std::FILE* again = std::fopen(file.path().c_str(), "wb");
  std::fprintf(again, "Include_INI=\"%s\"\n", file.path().c_str());
  std::fclose(again);
  expect_error({file.path()});
}

TEST(CliOptions, Clamping) {
  EXPECT_EQ(options_of({"+Q99"}).render.quality, 9);
  EXPECT_EQ(options_of({"+Q-3"}).render.quality, 0);
  EXPECT_EQ(options_of({"+R12"}).render.antialias_depth, 9);
  EXPECT_EQ(options_of({"+FN4"}).bits, 5);
  EXPECT_EQ(options_of({"+FN99"}).bits, 16);
  EXPECT_EQ(options_of({"+A05"}).render.antialias_threshold, 1.0);
  EXPECT_EQ(options_of({"-J0.5"}).render.jitter_amount, 0.0);
  EXPECT_EQ(options_of({"+MV9"}).language_version, 900);
  EXPECT_EQ(options_of({"+A", "+AM2"}).render.supersampling, Supersampling::method2);
  EXPECT_EQ(options_of({"+A", "+AM0"}).render.supersampling, Supersampling::none);
  EXPECT_EQ(options_of({"+AM2"}).render.supersampling, Supersampling::none);
  EXPECT_EQ(options_of({"--supersampling", "adaptive"}).render.supersampling,
            Supersampling::method2);
  const RenderOptions grid = options_of({"--supersampling", "grid", "5", "+W40"}).render;
  EXPECT_EQ(grid.supersampling, Supersampling::grid);
  EXPECT_EQ(grid.grid_samples, 5);
  EXPECT_EQ(grid.width, 40);
  EXPECT_EQ(options_of({"--supersampling=jitter", "2"}).render.grid_samples, 2);
  EXPECT_EQ(options_of({"--supersampling", "jitter"}).render.grid_samples, 3);
  EXPECT_THROW(options_of({"--supersampling", "randomly"}), OptionError);
  EXPECT_THROW(options_of({"+BS2"}), OptionError);
  EXPECT_THROW(options_of({"+H0"}), OptionError);
  EXPECT_THROW(options_of({"+W-5"}), OptionError);
}

TEST(CliOptions, StandardOutputTakesOneThing) {
  EXPECT_THROW(options_of({"-O-", "--stats", "-"}), OptionError);
  EXPECT_THROW(options_of({"--stats", "-", "+Ostdout"}), OptionError);
  EXPECT_EQ(options_of({"-O-", "--stats", "file"}).stats_file, "file");
  EXPECT_EQ(options_of({"+Ostderr", "--stats", "-"}).stats_file, "-");
  EXPECT_EQ(options_of({"-O-", "-F", "--stats", "-"}).stats_file, "-");
}

TEST(CliOptions, Streams) {
  const Options silent = options_of({"-GA"});
  for (const StreamOptions& stream : silent.streams) EXPECT_FALSE(stream.console);
  const Options some = options_of({"-GS", "+GWwarn.txt", "Debug_File=true"});
  EXPECT_FALSE(some.streams[static_cast<size_t>(Stream::statistic)].console);
  EXPECT_EQ(some.streams[static_cast<size_t>(Stream::warning)].file, "warn.txt");
  EXPECT_EQ(some.streams[static_cast<size_t>(Stream::debug)].file, "debug.out");
  EXPECT_THROW(options_of({"All_File=/tmp/x"}), OptionError);
}

// The cases of spec/language.md 34, measured with povray on 10 by 8 pixels.
TEST(CliOptions, Windows) {
  auto window = [](const std::vector<std::string>& arguments) {
    OptionValues values;
    OptionReader(values).read_arguments(arguments);
    const PixelWindow w = resolve_window(values, 10, 8);
    return std::vector<int>{w.left, w.top, w.right, w.bottom};
  };
  EXPECT_EQ(window({}), (std::vector<int>{0, 0, 10, 8}));
  EXPECT_EQ(window({"+SC3", "+EC5", "+SR2", "+ER4"}), (std::vector<int>{2, 1, 5, 4}));
  EXPECT_EQ(window({"+SR0.25", "+ER0.75"}), (std::vector<int>{0, 2, 10, 6}));
  EXPECT_EQ(window({"+ER4.9"}), (std::vector<int>{0, 0, 10, 4}));
  EXPECT_EQ(window({"+SC0.5"}), (std::vector<int>{5, 0, 10, 8}));
  EXPECT_EQ(window({"+SC0.7"}), (std::vector<int>{6, 0, 10, 8}));
  EXPECT_EQ(window({"+EC0.7"}), (std::vector<int>{0, 0, 6, 8}));
  EXPECT_EQ(window({"+EC1", "+ER1"}), (std::vector<int>{0, 0, 10, 8}));
  EXPECT_THROW(window({"+ER0"}), OptionError);
  EXPECT_THROW(window({"+EC11"}), OptionError);
  EXPECT_THROW(window({"+SC11"}), OptionError);
  EXPECT_THROW(window({"+SR-1"}), OptionError);
}

// The cases of spec/language.md 33.
TEST(CliAnimation, FramesAndClocks) {
  const Animation four = options_of({"+KFF4"}).animation;
  ASSERT_TRUE(four.on);
  EXPECT_EQ(four.clock(1), 0.0);
  EXPECT_EQ(four.clock(2), static_cast<double>(1.0f / 3));
  EXPECT_EQ(four.clock(4), 1.0);
  EXPECT_EQ(four.frame_suffix(3), "3");

  const Animation cyclic = options_of({"+KFF4", "+KC"}).animation;
  EXPECT_EQ(cyclic.clock(2), 0.25);
  EXPECT_EQ(cyclic.clock(4), 0.75);
  EXPECT_EQ(cyclic.last, 5);
  EXPECT_EQ(cyclic.end, 4);
  EXPECT_EQ(options_of({"+KFF9", "+KC"}).animation.frame_suffix(3), "03");

  EXPECT_FALSE(options_of({"+KFF1", "+KFI1"}).animation.on);
  EXPECT_FALSE(options_of({"+KFF0"}).animation.on);
  EXPECT_FALSE(options_of({"+KI1"}).animation.on);
  const Animation one = options_of({"+KFI1"}).animation;
  EXPECT_TRUE(one.on);
  EXPECT_TRUE(std::isnan(one.clock(1)));
}

TEST(CliAnimation, Subsets) {
  auto subset = [](const std::vector<std::string>& arguments) {
    const Animation animation = options_of(arguments).animation;
    return std::make_pair(animation.start, animation.end);
  };
  EXPECT_EQ(subset({"+KFF10", "+SF9"}), std::make_pair(9, 10));
  EXPECT_EQ(subset({"+KFF100", "+SF0.29"}), std::make_pair(29, 100));
  EXPECT_EQ(subset({"+KFF4", "+EF6"}), std::make_pair(1, 6));
  EXPECT_EQ(subset({"+KFF4", "+SF3", "+EF2"}), std::make_pair(3, 3));
  EXPECT_EQ(options_of({"+KFF10", "+SF9"}).animation.frame_suffix(9), "09");
}

// The cases of spec/language.md 32.
// povray tests objects in the order of the scene then: it shows where surfaces coincide.
TEST(CliOutput, NoBoundingIsNoThreshold) {
  EXPECT_EQ(options_of({}).bounding_threshold, 3);
  EXPECT_EQ(options_of({"+MB7"}).bounding_threshold, 7);
  EXPECT_GT(options_of({"-MB"}).bounding_threshold, 1000000);
  EXPECT_GT(options_of({"+MB7", "Bounding=off"}).bounding_threshold, 1000000);
}

TEST(CliOutput, Names) {
  EXPECT_EQ(output_path("sub/q.pov", "", 'N', ""), "sub/q.png");
  EXPECT_EQ(output_path("q", "", 'N', ""), "q.png");
  EXPECT_EQ(output_path("sub/q.pov", "out/", 'N', ""), "out/q.png");
  EXPECT_EQ(output_path("sub/q.pov", ".png", 'N', ""), "sub/q.png");
  EXPECT_EQ(output_path("sub/q.pov", "out/.png", 'N', ""), "out/q.png");
  EXPECT_EQ(output_path("q.pov", "foo.tga", 'N', ""), "foo.tga.png");
  EXPECT_EQ(output_path("q.pov", "foo.PNG", 'N', ""), "foo.PNG.png");
  EXPECT_EQ(output_path("q.pov", "foo.png", 'N', ""), "foo.png");
  EXPECT_EQ(output_path("q.pov", "foo.", 'J', ""), "foo.jpg");
  EXPECT_EQ(output_path("a.b.pov", "", 'T', "07"), "a.b07.tga");
  EXPECT_EQ(state_path("sub/q07.png"), "sub/q07.pov-state");
  EXPECT_TRUE(is_standard_stream("-"));
}

TEST(CliShell, Commands) {
  const ShellContext context{"out.png", "in.pov", 7, 320, 240, 0.5};
  EXPECT_EQ(expand_command("%o %o %s %n %k %h %w %% %x", context),
            "%o out.png in.pov 7 0.500000 240 320 % %x");
  EXPECT_EQ(shell_outcome({"x", 'F', false}, 1), ShellOutcome::fatal);
  EXPECT_EQ(shell_outcome({"x", 'F', false}, 0), ShellOutcome::go_on);
  EXPECT_EQ(shell_outcome({"x", 'Q', true}, 0), ShellOutcome::quit);
  std::string refusal;
  EXPECT_EQ(run_shell_command({"true", 'F', false}, context, false, refusal), ShellOutcome::fatal);
  EXPECT_FALSE(refusal.empty());
  refusal.clear();
  EXPECT_EQ(run_shell_command({"exit 3", 'S', false}, context, true, refusal), ShellOutcome::skip);
  EXPECT_EQ(run_shell_command({"true", 'S', false}, context, true, refusal), ShellOutcome::go_on);
}

TEST(CliHelp, ManPageNamesEverySetting) {
  std::FILE* file = std::fopen(DURER_SOURCE_DIR "/docs/durer.1", "rb");
  ASSERT_NE(file, nullptr);
  std::string page(200000, '\0');
  page.resize(std::fread(page.data(), 1, page.size(), file));
  std::fclose(file);
  for (int i = 0; i < kOptionCount; ++i) {
    const OptionEntry& entry = option_entry(i);
    EXPECT_NE(page.find(entry.ini_name), std::string::npos) << entry.ini_name;
    if (*entry.long_name) {
      EXPECT_NE(page.find(entry.long_name), std::string::npos) << entry.long_name;
    }
  }
}

TEST(CliHelp, FitsTheTerminal) {
  const std::string text = help_text();
  size_t begin = 0;
  while (begin < text.size()) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    EXPECT_LE(end - begin, 100u) << text.substr(begin, end - begin);
    begin = end + 1;
  }
}

}  // namespace
}  // namespace durer
