#include "meshalyzer/io/mesh_field.h"

#include "field_sample.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/io/obj.h"
#include "meshalyzer/io/ply.h"

#include <gtest/gtest.h>

#include <array>

namespace meshalyzer {
namespace {

constexpr std::array kFormats{FieldFormat::Ply, FieldFormat::Obj, FieldFormat::Vtp};

void expect_refused(const FieldSample& sample) {
  for (const FieldFormat format : kFormats) {
    EXPECT_THROW(static_cast<void>(sample.print(format)), InvalidArgument);
  }
}

TEST(FieldFormatOfName, GoesByTheEnding) {
  EXPECT_EQ(field_format_of_name("a.ply"), FieldFormat::Ply);
  EXPECT_EQ(field_format_of_name("ply/a.obj"), FieldFormat::Obj);
  EXPECT_EQ(field_format_of_name("a.ply.VTP"), FieldFormat::Vtp);
  EXPECT_EQ(field_format_of_name("a.off"), std::nullopt);
  EXPECT_EQ(field_format_of_name("ply"), std::nullopt);
  EXPECT_EQ(field_format_of_name(""), std::nullopt);
}

TEST(PrintMeshField, FormatDecidesWhatIsWritten) {
  const FieldSample sample;
  EXPECT_EQ(parse_ply(sample.print(FieldFormat::Ply), "a").triangles, sample.triangles);
  EXPECT_EQ(parse_obj(sample.print(FieldFormat::Obj), "a").triangles, sample.triangles);
  EXPECT_EQ(sample.print(FieldFormat::Vtp).rfind("<?xml", 0), 0U);
}

TEST(PrintMeshField, FieldOfOtherVerticesIsRefused) {
  FieldSample sample;
  sample.values.pop_back();
  expect_refused(sample);
  sample = FieldSample();
  sample.colours.pop_back();
  expect_refused(sample);
}

TEST(PrintMeshField, FieldOfOtherFacesIsRefused) {
  FieldSample sample = face_field_sample();
  sample.face_values.clear();
  expect_refused(sample);
  sample = face_field_sample();
  sample.face_colours.clear();
  expect_refused(sample);
}

TEST(PrintMeshField, CornerThatIsNoVertexIsRefused) {
  FieldSample sample;
  sample.triangles[1][2] = 4;
  expect_refused(sample);
  sample.triangles[1][2] = kNoIndex;
  expect_refused(sample);
}

}  // namespace
}  // namespace meshalyzer
