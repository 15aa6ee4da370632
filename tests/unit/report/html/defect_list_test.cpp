#include "meshalyzer/report/html/defect_list.h"

#include "html/sample_scene.h"
#include "meshalyzer/defects/catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace meshalyzer {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string list_of(const DefectReport& defects, const Scene& scene) {
  const MeshName name = sample_name();
  const PageMesh mesh{name, defects, scene};
  const std::array meshes{TitledMesh{"", mesh}};
  HtmlWriter html;
  append_defects_section(html, meshes);
  return html.html();
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++n;
  return n;
}

TEST(AppendDefectsSection, SoundMeshIsSaidToBeSo) {
  const std::string html = list_of({}, {});
  EXPECT_THAT(html, HasSubstr("<p class=\"none\">Nothing is wrong.</p>"));
  EXPECT_THAT(html, Not(HasSubstr("<details")));
}

TEST(AppendDefectsSection, DefectThatIsLitUpIsAButtonForIt) {
  EXPECT_THAT(list_of(sample_defects(), sample_scene()),
              HasSubstr("<li><button type=\"button\" class=\"defect\" data-scene=\"0\" "
                        "data-highlight=\"0\"><span class=\"elements\">edge 10-20</span>"
                        "</button></li>"));
}

TEST(AppendDefectsSection, WhatARepairWouldMakeOfADefectIsSaidBelowIt) {
  const MeshName name = sample_name();
  const DefectReport defects = sample_defects();
  const Scene scene = sample_scene();
  const std::array patches{PagePatch{0, "mended by magic"}};
  const std::array meshes{TitledMesh{"", PageMesh{name, defects, scene, {}, patches}}};
  HtmlWriter html;
  append_defects_section(html, meshes);
  EXPECT_THAT(html.html(), HasSubstr("edge 10-20</span> <span class=\"measured\">"
                                     "A repair: mended by magic</span></button>"));
}

TEST(AppendDefectsSection, DefectThatIsNotDrawnIsTextAlone) {
  Scene scene = sample_scene();
  scene.highlights.clear();
  const std::string html = list_of(sample_defects(), scene);
  EXPECT_THAT(html, HasSubstr("<li><span class=\"elements\">edge 10-20</span></li>"));
  EXPECT_THAT(html, Not(HasSubstr("<button")));
}

TEST(AppendDefectsSection, ElementsStandApartFromPlaceAndMeasure) {
  DefectReport defects = sample_defects();
  Defect hole = defects.defects[0];
  hole.positions = {{1.0, 2.0, 0.5}};
  hole.value = 3.25;
  defects.defects = {hole};
  EXPECT_THAT(list_of(defects, sample_scene()),
              HasSubstr("<span class=\"elements\">edge 10-20</span> "
                        "<span class=\"measured\">at 1 2 0.5; length 3.25</span></button>"));
}

TEST(AppendDefectsSection, ReaderIsToldToPressWhereThereIsSomethingToPress) {
  EXPECT_THAT(list_of(sample_defects(), sample_scene()), HasSubstr("class=\"hint\""));
  EXPECT_THAT(list_of(sample_defects(), {}), Not(HasSubstr("class=\"hint\"")));
}

TEST(AppendDefectsSection, CodeIsShownWithCountColourAndMeaning) {
  const std::string html = list_of(sample_defects(), sample_scene());
  EXPECT_THAT(html, HasSubstr("<details class=\"code\" open=\"\" data-code=\"hole\">"));
  EXPECT_THAT(html, HasSubstr("<code>hole</code> <span class=\"count\">1</span> "
                              "<span class=\"meaning\">a border loop</span>"));
  EXPECT_THAT(html, testing::ContainsRegex("class=\"swatch\" style=\"background:#[0-9a-f]{6}\""));
}

TEST(AppendDefectsSection, WarningsComeAfterErrorsAndAreSaidToBeSuch) {
  DefectReport report;
  report.counts[static_cast<std::size_t>(DefectCode::Disjoint)] = 1;
  report.counts[static_cast<std::size_t>(DefectCode::Hole)] = 1;
  const std::string html = list_of(report, {});
  EXPECT_LT(html.find("data-code=\"hole\""), html.find("data-code=\"disjoint\""));
  EXPECT_EQ(count_of(html, "<span class=\"severity\">warning</span>"), 1U);
  EXPECT_LT(html.find("data-code=\"disjoint\""), html.find("class=\"severity\""));
}

TEST(AppendDefectsSection, DefectsThatWereOnlyCountedAreSaidNotToBeListed) {
  EXPECT_THAT(list_of(sample_defects(), sample_scene()),
              HasSubstr("<p class=\"cut\">3 more are not listed.</p>"));
}

TEST(AppendDefectsSection, LongListIsCut) {
  DefectReport report;
  for (std::size_t i = 0; i < kListedOfACode + 1; ++i) {
    report.defects.push_back(make_defect(DefectCode::OrphanVertex));
  }
  report.counts[static_cast<std::size_t>(DefectCode::OrphanVertex)] = kListedOfACode + 1;
  const std::string html = list_of(report, {});
  EXPECT_EQ(count_of(html, "<li>"), kListedOfACode);
  EXPECT_THAT(html, HasSubstr("1 more is not listed."));
}

TEST(AppendDefectsSection, CountsHaveTheirDigitsInGroups) {
  DefectReport report;
  report.counts[static_cast<std::size_t>(DefectCode::OrphanVertex)] = 12'345;
  const std::string html = list_of(report, {});
  EXPECT_THAT(html, HasSubstr("<span class=\"count\">12,345</span>"));
  EXPECT_THAT(html, HasSubstr("12,345 more are not listed."));
}

TEST(AppendDefectsSection, CutListDoesNotHideTheNextCode) {
  DefectReport report;
  for (std::size_t i = 0; i < kListedOfACode + 1; ++i) {
    report.defects.push_back(make_defect(DefectCode::OrphanVertex));
  }
  report.defects.push_back(make_defect(DefectCode::Numbering));
  report.counts[static_cast<std::size_t>(DefectCode::OrphanVertex)] = kListedOfACode + 1;
  report.counts[static_cast<std::size_t>(DefectCode::Numbering)] = 1;
  EXPECT_THAT(list_of(report, {}), HasSubstr("<li><span class=\"elements\">numbering</span></li>"));
}

TEST(AppendDefectsSection, SeveralMeshesHaveAHeadingEachAndButtonsForTheirScenes) {
  const MeshName name = sample_name();
  const DefectReport defects = sample_defects();
  const DefectReport none;
  const Scene scene = sample_scene();
  const Scene empty;
  const PageMesh before{name, none, empty};
  const PageMesh after{name, defects, scene};
  const std::array meshes{TitledMesh{"before", before}, TitledMesh{"after", after}};
  HtmlWriter html;
  append_defects_section(html, meshes);
  EXPECT_THAT(html.html(), HasSubstr("<h3>before</h3>"));
  EXPECT_THAT(html.html(), HasSubstr("<h3>after</h3>"));
  EXPECT_THAT(html.html(), HasSubstr("data-scene=\"1\" data-highlight=\"0\""));
}

}  // namespace
}  // namespace meshalyzer
