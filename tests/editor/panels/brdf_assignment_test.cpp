#include "editor/panels/brdf_assignment.h"

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/brdf_mime.h"
#include "editor/document/scene_places.h"
#include "grf/read.h"
#include "grf/write.h"
#include "renderer/reflectance/scheme.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using testing::HasSubstr;

/// `gold` is one BRDF for the outer mesh, and another for the inner one.
const std::string Text = R"(def gold = brdf ward sx=0.2
def sum = brdf combine 0.5 gold
begin
  begin mesh "outer"
    begin vertexs
      (0, 0, 0) (1, 0, 0) (0, 1, 0)
    end vertexs
    begin faces
      (0, 1, 2)
      (1, 0, 2)
    end faces
  end mesh
  def gold = brdf phong n=20
  begin
    begin mesh "inner"
      begin vertexs
        (0, 0, 0) (1, 0, 0) (0, 1, 0)
      end vertexs
      begin faces
        (0, 1, 2)
      end faces
    end mesh
  end
end
)";

class BrdfAssignments : public testing::Test {
 protected:
  BrdfAssignments() : catalogue_(reflectance::catalogue()) { document_.take(scene_of(Text), {}, {}); }

  void select(std::initializer_list<FaceId> faces) {
    FaceSelection selection(document_.objects());
    for (const FaceId& face : faces) selection.set(face);
    document_.select(selection);
  }
  /// The data of a drag of the outer definition of that name.
  std::unique_ptr<QMimeData> definition(const std::string& name) const {
    for (const PlacedDefinition& each :
         definitions_at(document_.scene(), document_.objects().meshes[0].path)) {
      if (each.definition->name == name) {
        return mime_of(std::get<grf::BrdfModel>(each.definition->body), QString::fromStdString(name));
      }
    }
    throw std::runtime_error("no definition is called " + name);
  }
  static std::unique_ptr<QMimeData> written(const char* text) {
    auto mime = std::make_unique<QMimeData>();
    mime->setData(BrdfMimeType, text);
    return mime;
  }
  bool assign(const QMimeData& mime) {
    diagnostics_ = {};
    return assign_brdf(document_, catalogue_, mime, diagnostics_);
  }
  /// The BRDF of a face as written; empty for none.
  std::string brdf(const FaceId& face) const {
    const auto& brdf = document_.objects().meshes[face.mesh].mesh->surface(face.face).brdf;
    if (!brdf) return {};
    const auto* reference = std::get_if<grf::Reference>(&*brdf);
    return reference != nullptr ? reference->name : grf::to_text(std::get<grf::BrdfModel>(*brdf));
  }

  const grf::Catalogue catalogue_;
  Document document_;
  grf::Diagnostics diagnostics_;
};

TEST_F(BrdfAssignments, ShareADefinitionByItsName) {
  select({{0, 1}});
  ASSERT_TRUE(assign(*definition("gold"))) << diagnostics_.to_text();
  EXPECT_EQ(brdf({0, 1}), "gold");
  EXPECT_EQ(brdf({0, 0}), "");
  ASSERT_TRUE(assign(*definition("sum"))) << diagnostics_.to_text();
  EXPECT_EQ(brdf({0, 1}), "sum");
  EXPECT_EQ(document_.undo_stack().count(), 2);
  EXPECT_EQ(document_.undo_stack().undoText(), "Assign sum");
}

TEST_F(BrdfAssignments, WriteOutADefinitionWhereItsNameMeansSomethingElse) {
  select({{0, 0}, {1, 0}});
  ASSERT_TRUE(assign(*definition("gold"))) << diagnostics_.to_text();
  EXPECT_EQ(brdf({0, 0}), "ward sx=0.2");
  EXPECT_EQ(brdf({1, 0}), "ward sx=0.2");
  grf::BrdfModel other;
  other.keyword = "diffuse";
  ASSERT_TRUE(assign(*mime_of(other, "of_another_scene"))) << diagnostics_.to_text();
  EXPECT_EQ(brdf({1, 0}), "diffuse");
}

TEST_F(BrdfAssignments, TakeABrdfWithoutAName) {
  select({{1, 0}});
  ASSERT_TRUE(assign(*written("phong n=30")));
  EXPECT_EQ(brdf({1, 0}), "phong n=30");
  document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(Text));
}

TEST_F(BrdfAssignments, SayWhyNothingIsAssigned) {
  EXPECT_FALSE(assign(*written("phong n=30")));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("no selected face"));
  select({{1, 0}});
  EXPECT_FALSE(assign(*written("phong n=-1")));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("'n' of 'phong'"));
  EXPECT_FALSE(assign(*written("phnog")));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("did you mean 'phong'"));
  EXPECT_FALSE(assign(*written("combine 1 brass")));
  EXPECT_TRUE(diagnostics_.has_errors());
  EXPECT_EQ(document_.undo_stack().count(), 0);
}

}  // namespace
}  // namespace editor
