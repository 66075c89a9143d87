#include "editor/document/brdf_mime.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/write.h"
#include "renderer/reflectance/brdf.h"
#include "tests/editor/scene_of.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::HasSubstr;

std::optional<grf::BrdfModel> read_back(const QMimeData& mime, grf::Diagnostics& diagnostics) {
  return brdf_of(mime, reflectance::brdf_infos(), diagnostics);
}

TEST(BrdfMime, CarriesGrfText) {
  const grf::BrdfModel ward = brdf_model("ward sx=0.1");
  const auto mime = mime_of(ward, "paint");
  EXPECT_EQ(mime->text(), "ward sx=0.1");
  EXPECT_EQ(mime->data(BrdfNameMimeType), "paint");
  EXPECT_FALSE(mime_of(ward)->hasFormat(BrdfNameMimeType));
  grf::Diagnostics diagnostics;
  EXPECT_EQ(read_back(*mime, diagnostics), ward);
  EXPECT_EQ(diagnostics.to_text(), "");
}

TEST(BrdfMime, SaysWhatIsNoBrdf) {
  QMimeData mime;
  for (const auto& [text, reason] : {std::pair("phnog", "did you mean 'phong'"), {"ward sx=", "BRDF:1"}}) {
    mime.setData(BrdfMimeType, text);
    grf::Diagnostics diagnostics;
    EXPECT_FALSE(read_back(mime, diagnostics)) << text;
    EXPECT_THAT(diagnostics.to_text(), HasSubstr(reason));
  }
}

TEST(BrdfMime, CarriesWhatOtherFilesHold) {
  const test::TemporaryFolder folder;
  folder.add("parts/clay.brdf", "oren s=0.4\n");
  const std::string path = folder.add("scene.grf",
                                      "def clay = brdf \"parts/clay.brdf\"\n"
                                      "def felt = brdf measured \"felt.astm\"\n"
                                      "begin end\n");
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(path, diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  const auto& scope = std::get<grf::DefinitionScope>(scene->contents.blocks.front().content);
  const auto text = [&scope](std::size_t i) {
    return mime_of(std::get<grf::BrdfModel>(scope.definitions[i].body))->text().toStdString();
  };
  EXPECT_EQ(text(0), "oren s=0.4");
  EXPECT_EQ(text(1), "measured \"" + folder.path("felt.astm") + "\"");
}

}  // namespace
}  // namespace editor
