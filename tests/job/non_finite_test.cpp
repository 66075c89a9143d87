#include "renderer/job/non_finite.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/job/preview_helpers.h"

namespace {

std::optional<job::NonFiniteSearch> search(const std::string& text) {
  grf::Diagnostics diagnostics;
  job::PreviewRequest request = test::request(test::scene_of_text(text), 512, 384, 1);
  const auto found = job::search_non_finite(request, {}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.to_text();
  return found;
}

TEST(NonFiniteSearch, FindsNothingInASoundScene) {
  const auto found = search(test::Corner);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->samples, 256U * 192U * 64U);
  EXPECT_EQ(found->rejected, 0U);
  EXPECT_EQ(found->cause, "");
}

#ifdef NDEBUG
TEST(NonFiniteSearch, ExplainsTheFirstSampleThatIsNotFinite) {
  // The light's and the floor's values are finite, but not their product.
  const auto found = search(
      "light begin rgb (3e38,3e38,3e38) (-1,3,-1) (2,0,0) (0,0,2) end begin mesh rgb (99,99,99) "
      "brdf diffuse kd=0.7 begin vertexs (-3,0,3) (3,0,3) (3,0,-3) (-3,0,-3) end vertexs "
      "begin faces (0,1,2,3) end faces end mesh");
  ASSERT_TRUE(found);
  EXPECT_GT(found->rejected, 0U);
  EXPECT_LT(found->rejected, found->samples);
  EXPECT_EQ(found->cause, "a product of finite terms is too large");
}
#endif

TEST(NonFiniteSearch, StopsOnRequest) {
  std::stop_source stop;
  stop.request_stop();
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(job::search_non_finite(test::request(test::scene_of_text(test::Corner)), stop.get_token(),
                                      diagnostics));
}

}  // namespace
