#include "hand.hpp"

namespace terrella {
namespace {

class MapTest : public PanelTest {
 protected:
  MapTest() {
    click("camera");
    frames(2);
  }

  // To a share of its width and height.
  void point_at_map(float across, float down) {
    const WidgetPlace map = place_of("camera/map");
    ImGui::GetIO().AddMousePosEvent(map.left + across * (map.right - map.left),
                                    map.top + down * (map.bottom - map.top));
    frame();
  }
};

TEST_F(MapTest, IsThereWhereTheCamerasRowsAre) {
  EXPECT_TRUE(panel.shows_map());
  const WidgetPlace map = place_of("camera/map");
  EXPECT_NEAR((map.right - map.left) / (map.bottom - map.top), 2.0F, 0.02F);
  click("camera", 0.3F);
  EXPECT_FALSE(panel.shows_map());
}

TEST_F(MapTest, APressLeadsToThePlaceUnderIt) {
  for (const float across : {0.01F, 0.3F, 0.99F}) {
    for (const float down : {0.01F, 0.6F, 0.99F}) {
      point_at_map(across, down);
      EXPECT_EQ(press().go_to, std::nullopt);
      const std::optional<Destination> there = release().go_to;
      ASSERT_TRUE(there);
      EXPECT_NEAR(there->longitude, 360.0 * across - 180.0, 1.0);  // half a pixel and more
      EXPECT_NEAR(there->latitude, 90.0 - 180.0 * down, 1.0);
      EXPECT_EQ(there->altitude, std::nullopt);
    }
  }
  EXPECT_TRUE(document == SceneDocument{});
}

TEST_F(MapTest, ADragLeadsToWhereItEndsAndNowhereBesideTheMap) {
  point_at_map(0.1F, 0.1F);
  press();
  point_at_map(0.5F, 0.5F);
  const std::optional<Destination> there = release().go_to;
  ASSERT_TRUE(there);
  EXPECT_NEAR(there->longitude, 0.0, 1.0);
  point_at_map(0.1F, 0.1F);
  press();
  point_at_map(1.5F, 0.5F);
  EXPECT_EQ(release().go_to, std::nullopt);
}

class LowMapTest : public PanelTest {
 protected:
  LowMapTest() : PanelTest(900.0F, 400.0F) {}
};

TEST_F(LowMapTest, ALowWindowKeepsItsRoomForRows) {
  click("camera");
  frames(2);
  EXPECT_EQ(count_of("camera/map"), 0);
  EXPECT_FALSE(panel.shows_map());
}

}  // namespace
}  // namespace terrella
