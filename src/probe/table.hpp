// What the table of the probe's functions is written with.
#pragma once

#include <functional>
#include <numbers>
#include <vector>

#include "probe/function.hpp"

namespace terrella::probe {

using Numbers = std::vector<double>;

inline constexpr double turn = 2.0 * std::numbers::pi;
inline constexpr double u = 0x1p-24;  // the most that rounding to single precision moves a number by, relative to it
inline constexpr double faint = 1.2e-38;   // single precision holds smaller numbers badly, and drivers not at all
inline constexpr double anything = 1e300;  // an error that is allowed where nothing can be decided

// What is read of arguments that are there and in range.
double number(const Json& args, const char* name);
bool has(const Json& args, const char* name);
double number_or(const Json& args, const char* name, double otherwise);
glm::dvec3 triple(const Json& value);
glm::dvec3 triple(const Json& args, const char* name);

void add(Numbers& numbers, const glm::dvec3& v);

// An unsigned integer as two halves of 16 bits, which a float holds.
void add_bits(Numbers& numbers, unsigned bits);

// The numbers of the arguments as they come.
std::function<Prepared(const Json&)> as_they_come(std::vector<const char*> names);

// As a float holds it.
double rounded(double x);
Json rounded(const glm::dvec3& v);

Json list(const glm::dvec3& v);

// Mostly spread over its orders of magnitude, now and then one of the ends.
double stretched(Random& random, double low, double high);

// m, 0 among them.
double altitude(Random& random);

// An error of so many u of each answer.
std::function<Numbers(const Case&)> relative(double on_cpu, double on_gpu);

// An error of so many u, whatever the answer.
std::function<Numbers(const Case&)> absolute(double on_cpu, double on_gpu);

// The error of a power: it grows with the exponent and with the logarithm. Drivers compute it by way of both.
double allowed_of_power(double x, double exponent, bool gpu);

// The functions, by subject, in the order of the manual.
std::vector<Function> geometry_functions();
std::vector<Function> wave_functions();
std::vector<Function> height_functions();
std::vector<Function> surface_functions();
std::vector<Function> air_functions();
std::vector<Function> noise_functions();
std::vector<Function> ground_functions();
std::vector<Function> light_functions();
std::vector<Function> water_functions();
std::vector<Function> cloud_functions();
std::vector<Function> sky_functions();

}  // namespace terrella::probe
