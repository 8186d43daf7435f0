#include "measure/node_counts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "measure/ground_views.hpp"
#include "measure/studio.hpp"
#include "planet/node_mesh.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

View small() {
  View view;
  view.width = 160;
  view.height = 90;
  return view;
}

// The ground and the sea alone, as coarse as it can be.
Scene bare(double altitude) {
  Scene scene = seen_from({find_preset("blue")->scene, "blue"}, altitude);
  scene.clouds.model = scene.air.model = scene.stars.model = 0;
  scene.lights.density = scene.sun.intensity = 0.0;
  scene.quality.pixel_error = 16.0;
  return scene;
}

TEST(NodeCounts, AreThoseOfWhatTheRendererDraws) {
  test::Studio studio;
  for (const double altitude : {1e4, 1e7}) {
    for (const int water : {0, 1}) {
      Scene scene = bare(altitude);
      scene.water.model = water;
      const NodePicture picture(scene, small());
      const NodeCounts ground = node_counts(picture, NodeLayer::ground), sea = node_counts(picture, NodeLayer::sea);
      studio.renderer.draw(scene, small(), {Channel::color, Effort::complete, false});
      const std::int64_t counted = ground.triangles + ground.skirt_triangles + sea.triangles + sea.skirt_triangles;
      EXPECT_EQ(studio.renderer.stats().triangles, counted) << altitude << " " << water;
      EXPECT_EQ(sea.nodes > 0, water != 0);
    }
  }
}

TEST(NodeCounts, AreThoseOfWholeNodes) {
  Scene scene = bare(1e4);
  scene.water.model = 0;
  const NodePicture picture(scene, small());
  const NodeCounts counts = node_counts(picture, NodeLayer::ground);
  const std::int64_t whole = std::ssize(picture.patch().triangles) / 3;
  EXPECT_EQ(counts.nodes, static_cast<int>(picture.drawn().size()));
  // Where a neighbour is coarser, there are fewer, and a quarter where a node has its shape all over.
  EXPECT_LE(counts.triangles, whole * counts.nodes);
  EXPECT_GT(counts.triangles, whole * counts.nodes / 2);
  EXPECT_LE(counts.vertices, std::ssize(picture.patch().vertices) * counts.nodes);
  EXPECT_LE(counts.skirt_vertices, std::ssize(picture.patch().rim) * counts.nodes);
  EXPECT_EQ(2 * counts.skirt_vertices, counts.skirt_triangles);
}

TEST(SeenTriangles, AreAPartOfThoseDrawn) {
  const NodePicture picture(bare(10.0), small());
  const std::int64_t seen = seen_triangles(picture), drawn = node_counts(picture, NodeLayer::ground).triangles;
  EXPECT_GT(seen, drawn / 20);
  EXPECT_LT(seen, drawn);
}

// As far as the shape of the level above has been taken on, so far are triangles told of as coarse.
TEST(CoarseTriangles, AreThoseOfVerticesThatHaveWhollyPassed) {
  const NodePicture picture(bare(1e4), small());
  std::int64_t most = 0;
  for (const DrawnNode& drawn : picture.drawn()) {
    const std::vector<double> parts = picture.coarse_parts_of(drawn);
    const auto whole = std::count(parts.begin(), parts.end(), 1.0);
    EXPECT_EQ(parts.size(), picture.vertices_of(drawn).size());
    if (picture.shows(NodeLayer::ground, drawn)) most += 2 * whole;  // a vertex has at most as many of its own
  }
  const std::int64_t coarse = coarse_triangles(picture);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(coarse, most);
  EXPECT_LT(coarse, node_counts(picture, NodeLayer::ground).triangles);
}

// A narrower picture from the same place and of the same pixels shows fewer.
TEST(SeenTriangles, AreThoseInThePicture) {
  View narrow = small();
  narrow.width = 20;
  const std::int64_t all = seen_triangles(NodePicture(bare(1e4), small())),
                     few = seen_triangles(NodePicture(bare(1e4), narrow));
  EXPECT_LT(3 * few, all);
  EXPECT_GT(few, 0);
}

}  // namespace
}  // namespace terrella
