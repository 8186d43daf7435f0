// Scenes and pictures that limits and invariances are measured with.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measure/checks.hpp"
#include "measure/limits.hpp"

namespace terrella {

// Of every choice of a model the first.
inline constexpr int no_model = 0;

// 96x54 pixels.
View small_view(double seconds = 0.0);

// As fine as usual, but for the maps, which no distance shows.
Scene usual(Scene scene);

// A sea all over, without ice and clouds.
Scene bare_sea();

// The ground of a preset, without what lies on it and over it.
Scene bare_ground(const char* preset);

// A preset as coarse as it can be.
Scene cheap(const char* preset);

std::vector<float> light_of(Renderer& renderer, const Scene& scene, const View& view);

// How much there is to see in a picture: by how much its pixels differ from their mean, root of the mean square over
// all four channels, as mean_difference is.
double contrast_of(Pixels light);

// Root of the mean square difference of two pictures of one size.
double mean_difference(Pixels a, Pixels b);

using Change = std::function<void(Scene&, View&, double)>;
using Error = std::function<double(const Scene&, const View&)>;

// The limit with a point for each of the values that its parameter is changed to.
Limit follow(Limit limit, const Scene& start, const std::vector<double>& values, const Change& change,
             const Error& error);

}  // namespace terrella
