#include "meshalyzer/io/write.h"

#include "io_cases.h"
#include "meshalyzer/io/read.h"
#include "support/same_soup.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace meshalyzer {
namespace {

TEST(WriteMesh, EveryEndingReadsBackToTheLastBit) {
  const TemporaryFolder folder;
  const Soup soup = strip_of_hard_numbers(200);
  for (const char* name : {"a.mesh", "a.obj", "a.off", "a.stl", "a.PLY"}) {
    write_mesh(soup, folder.file(name));
    const Soup read = read_mesh(folder.file(name));
    EXPECT_TRUE(same_bits(read.positions, soup.positions)) << name;
    EXPECT_EQ(read.triangles, soup.triangles) << name;
  }
}

TEST(WriteMesh, BinaryIsReadAsBinary) {
  const TemporaryFolder folder;
  const Soup soup = strip_of_hard_numbers(200);
  write_mesh(soup, folder.file("a.ply"), Encoding::Binary);
  EXPECT_TRUE(same_bits(read_mesh(folder.file("a.ply")).positions, soup.positions));
}

TEST(WriteMesh, RefusesAnUnknownEnding) {
  EXPECT_THROW(write_mesh(strip_of_hard_numbers(3), "a.xyz"), InvalidArgument);
}

TEST(WriteMesh, WhatCannotBePrintedLeavesTheOldFile) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a.obj"), "old");
  Soup soup = strip_of_hard_numbers(3);
  soup.triangles[0][1] = kNoIndex;
  EXPECT_THROW(write_mesh(soup, folder.file("a.obj")), InvalidArgument);
  EXPECT_EQ(read_bytes(folder.file("a.obj")), "old");
}

TEST(WriteMesh, AFullDiskIsAnError) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/full", folder.file("a.obj"));
  EXPECT_THROW(write_mesh(strip_of_hard_numbers(3), folder.file("a.obj")), IoError);
}

TEST(PrintMesh, OnlyStlAndPlyHaveABinaryEncoding) {
  const Soup soup = strip_of_hard_numbers(3);
  for (const Format format : {Format::Mesh, Format::Inria, Format::Obj, Format::Off}) {
    EXPECT_THROW(static_cast<void>(print_mesh(soup, format, Encoding::Binary)), InvalidArgument);
  }
}

TEST(PrintMesh, EveryFormatRefusesAMissingVertex) {
  Soup soup = strip_of_hard_numbers(3);
  soup.triangles[0][1] = kNoIndex;
  for (const Format format :
       {Format::Mesh, Format::Inria, Format::Obj, Format::Off, Format::Stl, Format::Ply}) {
    EXPECT_THROW(static_cast<void>(print_mesh(soup, format)), InvalidArgument);
  }
}

}  // namespace
}  // namespace meshalyzer
