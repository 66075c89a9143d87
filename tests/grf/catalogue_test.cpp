#include "grf/catalogue.h"

#include <gtest/gtest.h>

#include "grf/read.h"
#include "tests/grf/small_catalogue.h"

namespace grf {
namespace {

TEST(CheckOfAModel, NeedsNoScene) {
  Diagnostics diagnostics;
  EXPECT_TRUE(
      check(*read_brdf("glossy m=1", "argument", diagnostics), catalogue().brdfs, "BRDF", diagnostics));
  EXPECT_FALSE(check(*read_brdf("glosy", "argument", diagnostics), catalogue().brdfs, "BRDF", diagnostics));
  EXPECT_EQ(diagnostics.entries().at(0).message, "unknown BRDF 'glosy': did you mean 'glossy'?");
}

TEST(CheckOfAModel, KnowsSchemes) {
  Diagnostics diagnostics;
  EXPECT_TRUE(
      check(*read_pdf("cosine mode=Warp", "argument", diagnostics), catalogue().pdfs, "PDF", diagnostics));
  EXPECT_FALSE(
      check(*read_pdf("cosine mode=2\n n=1", "argument", diagnostics), catalogue().pdfs, "PDF", diagnostics));
  EXPECT_FALSE(check(*read_pdf("glossy", "argument", diagnostics), catalogue().pdfs, "PDF", diagnostics));
  EXPECT_EQ(diagnostics.to_text(),
            "argument:1:8: error: 'mode' of 'cosine': expected one of reject, warp\n"
            "argument:1:1: error: unknown PDF 'glossy'\n");
}

TEST(FindArgument, KnowsAliases) {
  Diagnostics diagnostics;
  const auto model = read_brdf("glossy kd=1 SIGMA=2", "argument", diagnostics);
  const ModelInfo* info = find_model(catalogue().brdfs, "Glossy");
  ASSERT_TRUE(model && info != nullptr);
  EXPECT_EQ(find_argument(*model, *info->find("m"))->value, Value(2.0F));
  EXPECT_EQ(find_argument(*model, *info->find("fast")), nullptr);
  EXPECT_EQ(find_model(catalogue().brdfs, "cosine"), nullptr);
}

}  // namespace
}  // namespace grf
