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

TEST(CheckOfAModel, KnowsWholeNumbers) {
  ModelInfo info;
  info.keyword = "counted";
  ParameterInfo count = parameter("count", ParameterKind::Number, 10);
  count.minimum = 1;
  count.is_whole = true;
  info.parameters = {count};
  Diagnostics diagnostics;
  for (const auto& [text, is_valid] : {std::pair("counted count=10", true),
                                       {"counted count=2.5", false},
                                       {"counted count=10.5", false},
                                       {"counted count=(1, 2, 3)", false}})
    EXPECT_EQ(check(*read_brdf(text, "argument", diagnostics), {info}, "BRDF", diagnostics), is_valid)
        << text;
  EXPECT_EQ(
      diagnostics.to_text(),
      "argument:1:9: error: 'count' of 'counted': 2.5 is not whole, expected a whole number from 1 to 10\n"
      "argument:1:9: error: 'count' of 'counted': 10.5 is out of range, expected a whole number from 1 to "
      "10\n"
      "argument:1:9: error: 'count' of 'counted': expected a whole number from 1 to 10\n");
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
