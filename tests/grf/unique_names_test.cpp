#include "grf/unique_names.h"

#include <gtest/gtest.h>

namespace grf {
namespace {

TEST(UniqueNames, NumberWhatWasTaken) {
  UniqueNames names;
  EXPECT_EQ(names.take("wall"), "wall");
  EXPECT_EQ(names.take("wall"), "wall_2");
  EXPECT_EQ(names.take("wall"), "wall_3");
  EXPECT_EQ(names.take("Wall"), "Wall");
  EXPECT_EQ(names.take("wall_2"), "wall_2_2");
  EXPECT_TRUE(names.add("floor"));
  EXPECT_FALSE(names.add("floor"));
  EXPECT_EQ(names.take("floor"), "floor_2");
  EXPECT_TRUE(names.add("wall_4"));
  EXPECT_EQ(names.take("wall"), "wall_5");
}

TEST(UniqueNames, PutTheNumberBeforeTheExtension) {
  UniqueNames names(UniqueNames::Case::Ignored);
  EXPECT_EQ(names.take("Wood", ".png"), "Wood.png");
  EXPECT_EQ(names.take("wood", ".png"), "wood_2.png");
  EXPECT_EQ(names.take("wood", ".jpg"), "wood.jpg");
  EXPECT_EQ(names.take("WOOD", ".PNG"), "WOOD_3.PNG");
}

}  // namespace
}  // namespace grf
