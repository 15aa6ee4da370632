#include "meshalyzer/io/read.h"

#include "io_cases.h"
#include "meshalyzer/io/gzip.h"
#include "meshalyzer/io/plain_content.h"
#include "meshalyzer/io/write.h"
#include "support/same_soup.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

const std::string kNativeMesh = "Vertex 1 0 0 0\n";
const std::string kInriaMesh = "MeshVersionFormatted 1\nDimension 3\nVertices 1\n0 0 0 0\nEnd\n";

/// The regular files of a folder of the corpus; none where there is no corpus.
std::vector<std::string> corpus_files(const std::string& folder) {
  std::vector<std::string> files;
  const std::filesystem::path path = std::filesystem::path(MESHALYZER_CORPUS) / folder;
  if (std::filesystem::is_directory(path)) {
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      files.push_back(entry.path().string());
    }
  }
  return files;
}

TEST(ParseMesh, TheNameDecidesTheFormat) {
  EXPECT_EQ(parse_mesh("v 0 0 0\n", "a.obj").format, Format::Obj);
  EXPECT_EQ(error_of([] { return parse_mesh("hello\n", "a.mesh"); }),
            "a.mesh:1: \"hello\" is neither Vertex nor Face");
}

TEST(ParseMesh, ThoseOfInriaAreKnownByTheirContent) {
  EXPECT_EQ(parse_mesh(kInriaMesh, "a.mesh").format, Format::Inria);
  EXPECT_EQ(parse_mesh(kNativeMesh, "a.mesh").format, Format::Mesh);
}

TEST(ParseMesh, WithoutAKnownEndingTheContentDecides) {
  EXPECT_EQ(parse_mesh(kNativeMesh, "-").format, Format::Mesh);
  EXPECT_EQ(parse_mesh(kInriaMesh, "-").format, Format::Inria);
  EXPECT_EQ(parse_mesh("OFF 1 0 0\n0 0 0\n", "a.txt").format, Format::Off);
  EXPECT_EQ(error_of([] { return parse_mesh("hello\n", "-"); }),
            "-:1: neither the name nor the content is that of a known mesh format (.mesh .obj .off "
            ".stl .ply, each also with .gz)");
}

TEST(ParseMesh, AWrongEndingIsNotBelieved) {
  EXPECT_TRUE(same_soup(parse_mesh("OFF\n1 0 0\n0 0 0\n", "a.stl"),
                        parse_mesh("OFF\n1 0 0\n0 0 0\n", "a.off")));
}

/// The same mesh in every format.
std::vector<std::pair<std::string, std::string>> every_format() {
  Soup soup = strip_of_hard_numbers(5);
  return {{"a.mesh", print_mesh(soup, Format::Mesh)},
          {"b.mesh", print_mesh(soup, Format::Inria)},
          {"a.obj", print_mesh(soup, Format::Obj)},
          {"a.off", print_mesh(soup, Format::Off)},
          {"a.stl", print_mesh(soup, Format::Stl)},
          {"b.stl", print_mesh(parse_mesh("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off"),
                               Format::Stl, Encoding::Binary)},
          {"a.ply", print_mesh(soup, Format::Ply)},
          {"b.ply", print_mesh(soup, Format::Ply, Encoding::Binary)}};
}

TEST(ParseMesh, GzippedIsTheSameMeshInEveryFormat) {
  for (const auto& [name, content] : every_format()) {
    const Soup plain = parse_mesh(content, name);
    EXPECT_TRUE(same_soup(parse_mesh(pack_gzip(content), name + ".gz"), plain)) << name;
    EXPECT_TRUE(same_soup(parse_mesh(pack_gzip(content), name), plain)) << name;
    EXPECT_TRUE(same_soup(parse_mesh(content, name + ".gz"), plain)) << name;
    EXPECT_EQ(parse_mesh(pack_gzip(content), "-").format, plain.format) << name;
  }
}

TEST(ParseMesh, AByteOrderMarkMeansNothing) {
  const std::string mark(kByteOrderMark);
  for (const auto& [name, content] : every_format()) {
    EXPECT_TRUE(same_soup(parse_mesh(mark + content, name), parse_mesh(content, name))) << name;
    EXPECT_TRUE(same_soup(parse_mesh(pack_gzip(mark + content), name), parse_mesh(content, name)))
        << name;
  }
  EXPECT_EQ(parse_mesh(mark + "Vertex 7 0 0 0\n", "a.mesh").vertex_lines.front(), 1U);
}

std::string with_returns(std::string text) {
  std::replace(text.begin(), text.end(), '\n', '\r');
  return text;
}

TEST(ParseMesh, LinesMayAllEndWithCarriageReturnAlone) {
  const std::string mark(kByteOrderMark);
  int n_texts = 0;
  for (const auto& [name, content] : every_format()) {
    if (content.find('\0') != std::string::npos) continue;
    ++n_texts;
    const Soup expected = parse_mesh(content, name);
    const std::string returns = with_returns(content);
    EXPECT_TRUE(same_soup(parse_mesh(returns, name), expected)) << name;
    EXPECT_TRUE(same_soup(parse_mesh(mark + returns, name), expected)) << name;
    EXPECT_TRUE(same_soup(parse_mesh(pack_gzip(mark + returns), name), expected)) << name;
  }
  EXPECT_GE(n_texts, 6);
  EXPECT_EQ(error_of([] { return parse_mesh("# by hand\rv 0 0 0\rv 0 0\r", "a.obj"); }),
            "a.obj:3: the line ends where a number should stand");
}

/// A binary PLY file with one triangle. Its coordinates contain the bytes of CR, LF and of both.
std::string ply_with_line_ends_in_records() {
  Soup soup = parse_mesh("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off");
  constexpr std::array<std::string_view, 3> kHeights = {"abc\rdef\x40", "\nbc\rdef\x40",
                                                        "ab\r\ncde\x40"};
  for (std::size_t v = 0; v < kHeights.size(); ++v) {
    std::memcpy(&soup.positions[v].z(), kHeights[v].data(), sizeof(double));
  }
  return print_mesh(soup, Format::Ply, Encoding::Binary);
}

TEST(ParseMesh, TheHeaderOfBinaryPlyMayHaveCarriageReturnsAlone) {
  const std::string content = ply_with_line_ends_in_records();
  const std::size_t n_header = content.find("end_header\n") + std::string("end_header\n").size();
  const std::string returns = with_returns(content.substr(0, n_header)) + content.substr(n_header);
  EXPECT_TRUE(same_soup(parse_mesh(returns, "a.ply"), parse_mesh(content, "a.ply")));
}

TEST(ParseMesh, TextInUtf16IsSaidToBeThat) {
  for (const std::string& text :
       {std::string("\xff\xfev\0 \0", 6), std::string("\xfe\xff\0v\0 ", 6)}) {
    EXPECT_EQ(error_of([&] { return parse_mesh(text, "a.obj"); }),
              "a.obj:1: is text in UTF-16: only UTF-8 is read");
  }
}

TEST(ParseMesh, ABinaryFileMayBeginWithTheMarkOfUtf16) {
  std::string content =
      print_mesh(parse_mesh("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off"), Format::Stl,
                 Encoding::Binary);
  content.replace(0, 2, "\xff\xfe");
  EXPECT_EQ(parse_mesh(content, "a.stl").n_faces(), 1U);
}

TEST(ParseMesh, WhatIsWrongInGzippedContentIsToldByTheLineInIt) {
  EXPECT_EQ(error_of([] { return parse_mesh(pack_gzip("v 0 0 0\nv 0 0\n"), "a.obj.gz"); }),
            "a.obj.gz:2: the line ends where a number should stand");
  EXPECT_EQ(error_of([] { return parse_mesh(pack_gzip(""), "a.obj.gz"); }),
            "a.obj.gz:1: the file is empty");
  EXPECT_EQ(error_of([] { return parse_mesh(pack_gzip(pack_gzip("v 0 0 0\n")), "a.obj.gz"); }),
            "a.obj.gz:byte 0: is gzipped twice");
}

TEST(ParseMesh, WithoutAnyRecordThereIsNoMesh) {
  for (const char* name : {"a.mesh", "a.obj", "a.off", "a.stl", "a.ply", "-"}) {
    EXPECT_EQ(error_of([&] { return parse_mesh("", name); }),
              std::string(name) + ":1: the file is empty");
  }
  for (const char* content : {"# nothing\n", "\n", "12 13\n"}) {
    const std::string begin = "a.mesh:1: no mesh in it";
    EXPECT_EQ(begin_like(error_of([&] { return parse_mesh(content, "a.mesh"); }), begin), begin);
  }
  EXPECT_EQ(
      begin_like(error_of([] { return parse_mesh("OFF\n0 0 0\n", "a.off"); }), "a.off:1: no mesh"),
      "a.off:1: no mesh");
  EXPECT_EQ(begin_like(error_of([] { return parse_mesh("solid a\nendsolid a\n", "a.stl"); }),
                       "a.stl:1: no mesh"),
            "a.stl:1: no mesh");
}

TEST(ParseMesh, VerticesWithoutFacesAreAMesh) {
  EXPECT_EQ(parse_mesh(kNativeMesh, "a.mesh").n_faces(), 0U);
}

TEST(ReadMesh, ReadsAFile) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a.mesh"), kNativeMesh);
  EXPECT_EQ(read_mesh(folder.file("a.mesh")).n_vertices(), 1U);
}

TEST(ReadMesh, AMessageBeginsWithThePath) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.mesh");
  write_bytes(path, kNativeMesh + "Vertex 2 0 0\n");
  EXPECT_EQ(begin_like(error_of([&] { return read_mesh(path); }), path + ":2: "), path + ":2: ");
}

TEST(ReadMesh, WhatIsNoFileIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of([&] { return read_mesh(folder.path()); }), folder.path() + ": is a directory");
  EXPECT_EQ(error_of([&] { return read_mesh(folder.file("no.mesh")); }),
            folder.file("no.mesh") + ": cannot be opened: No such file or directory");
}

TEST(ReadMesh, ReadsTheRealMeshesOfTheCorpus) {
  std::size_t n_read = 0;
  for (const char* folder : {"lab", "models", "neuropil", "neuropil_set", "printing"}) {
    for (const std::string& path : corpus_files(folder)) {
      EXPECT_EQ(error_of([&] { return read_mesh(path); }), "accepted");
      ++n_read;
    }
  }
  if (n_read == 0) {
    GTEST_SKIP() << "no corpus at " << MESHALYZER_CORPUS;
  }
}

TEST(ReadMesh, RefusesTheCorpusFilesThatAreNoMesh) {
  const std::vector<std::string> paths = corpus_files("unreadable");
  for (const std::string& path : paths) {
    EXPECT_EQ(begin_like(error_of([&] { return read_mesh(path); }), path + ":"), path + ":");
  }
  if (paths.empty()) {
    GTEST_SKIP() << "no corpus at " << MESHALYZER_CORPUS;
  }
}

}  // namespace
}  // namespace meshalyzer
