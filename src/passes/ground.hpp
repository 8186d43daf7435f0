// What the ways of drawing a ground have in common.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "passes/frame.hpp"
#include "passes/sphere_meshes.hpp"

namespace terrella {

class NodeMeshes;

class GroundPass {
 public:
  virtual ~GroundPass() = default;

  // Work for a scene that can be done while programs compile.
  virtual void begin(const Scene&, const Needs&) {}

  // Starts to compile the programs that the needs call for.
  virtual void want(const Needs&) {}
  // True once drawing will not wait for them.
  virtual bool ready() = 0;

  // Brings what is drawn up to date, as far as the frame's effort allows. Needs the scene's uniform block.
  virtual void update(const Frame& frame) = 0;

  // Distance of the texels of its map, rad; 0: it has none.
  [[nodiscard]] virtual double map_texel_angle() const { return 0.0; }
  // Makes the map readable by all passes. level: of its mipmap that they read.
  virtual void bind_map(double) {}

  virtual void draw(const Frame& frame) = 0;
  // How steeply, at the most, an eye as far below the water as the true one is above looks up to any of it: the sine; 0
  // where there is nothing to look up to.
  [[nodiscard]] virtual double mirrored_climb() const { return 1.0; }

  // Where the surface lies that is drawn, over each group of the icosphere; empty where that is not known.
  [[nodiscard]] virtual std::span<const RadiusRange> ranges() const { return {}; }
  // Nodes that the sea is to be drawn with as well, or nothing.
  [[nodiscard]] virtual const NodeMeshes* nodes(GroundShown) const { return nullptr; }
  // While one way of dividing it gives way to the next, pictures of both are blended: the part, 0..1, that the one
  // before has in that of the last update. Where it is not 0, each update makes it less, for as many pictures more.
  [[nodiscard]] virtual double part_before() const { return 0.0; }

  // Whether it is drawn as the last update's needs ask.
  [[nodiscard]] virtual bool settled() const = 0;
  // Whether a coarse mesh is drawn, of which parts may lie higher than the ground.
  [[nodiscard]] virtual bool is_coarse() const { return false; }
  // Noise evaluated by the last update.
  [[nodiscard]] virtual std::int64_t noise_evaluations() const = 0;
};

// technique: not none.
std::unique_ptr<GroundPass> make_ground(Ground technique, SphereMeshes& spheres);

}  // namespace terrella
