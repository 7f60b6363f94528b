// Settings that are obeyed in another way than their words say are answered with one line each.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/option_reader.h"
#include "cli/options.h"
#include "cli/setting_notes.h"

namespace durer {
namespace {

std::vector<std::string> notes_of(const std::vector<std::string>& arguments, bool compare = false) {
  OptionValues values;
  OptionReader(values).read_arguments(arguments);
  Options options = resolve_options(values);
  options.compare_methods = compare;
  return setting_notes(values, options);
}

// One note, which begins with the setting's name.
void expect_note(const std::vector<std::string>& arguments, const std::string& name,
                 bool compare = false) {
  const std::vector<std::string> notes = notes_of(arguments, compare);
  ASSERT_EQ(notes.size(), 1u) << arguments.back();
  EXPECT_EQ(notes[0].substr(0, name.size() + 1), name + ":");
}

TEST(CliSettingNotes, NumbersOutOfRange) {
  EXPECT_EQ(notes_of({"--bits", "32"}),
            std::vector<std::string>{"Bits_Per_Color: 32 is out of range and taken as 16"});
  expect_note({"+WT0"}, "Work_Threads");
  expect_note({"+A0.3", "+R12"}, "Antialias_Depth");
  expect_note({"--supersampling", "grid", "100"}, "Supersampling_Grid");
  expect_note({"+Q12"}, "Quality");
  EXPECT_TRUE(notes_of({"+Q11", "+FN16", "+WT512", "+A0.9", "+R9"}).empty());
}

TEST(CliSettingNotes, DeclarationsThatAreNotWhatTheySeem) {
  expect_note({"Declare=size=3"}, "Declare=size=3");  // a reserved word
  expect_note({"Declare=a-b=3"}, "Declare=a-b=3");
  expect_note({"Declare=a=1", "Declare=a=2"}, "Declare=a=2");
  EXPECT_EQ(notes_of({"Declare=Count=1+2"}),
            std::vector<std::string>{"Declare=Count=1+2: read as the number 1 (a string: "
                                     "--declare 'Count=\"1+2\"')"});
  EXPECT_TRUE(notes_of({"Declare=Count=-1.5e2", "Declare='word=\"two words\"'"}).empty());
}

TEST(CliSettingNotes, WhatTheFileTypeCannotHold) {
  expect_note({"+UA", "+FJ"}, "Output_Alpha");
  expect_note({"+UA", "+FP"}, "Output_Alpha");
  expect_note({"+FJ", "--bits", "16"}, "Bits_Per_Color");
  expect_note({"+FE", "+TH"}, "Dither");
  expect_note({"+FB", "--compression", "9"}, "Compression");
  expect_note({"--output", "a/picture.jpg"}, "Output_File_Name");
  expect_note({"--output", "picture.JPG", "--type", "jpeg"}, "Output_File_Name");
  EXPECT_TRUE(notes_of({"+UA", "+FN16", "+TH", "--compression", "9", "+Oa.png"}).empty());
  EXPECT_TRUE(notes_of({"+FJ", "--compression", "90", "+Opicture.v2"}).empty());
  EXPECT_TRUE(notes_of({"-F", "+Opicture.jpg"}).empty());
}

TEST(CliSettingNotes, SettingsWithoutTheOneThatTheyServe) {
  expect_note({"+AM2"}, "Sampling_Method");
  expect_note({"+R4"}, "Antialias_Depth");
  expect_note({"--supersampling-grid", "4"}, "Supersampling_Grid");
  expect_note({"+KFF3", "+K0.5"}, "Clock");
  expect_note({"+KF2"}, "Final_Clock");
  expect_note({"+KC"}, "Cyclic_Animation");
  EXPECT_TRUE(notes_of({"+A", "+AM2", "+R4", "+KFF3", "+KF2", "+KC"}).empty());
  EXPECT_TRUE(notes_of({"--supersampling", "adaptive", "+R4"}).empty());
  EXPECT_TRUE(notes_of({"Initial_Frame=1", "Final_Frame=1", "Final_Clock=1"}).empty());
}

TEST(CliSettingNotes, CompareMethodsRendersTheWholePicture) {
  expect_note({"--integrator", "raycast"}, "Integrator", true);
  expect_note({"+SC0.5"}, "Start_Column", true);
  EXPECT_TRUE(notes_of({"+R2", "+AM2", "--supersampling-grid", "4"}, true).empty());
}

}  // namespace
}  // namespace durer
