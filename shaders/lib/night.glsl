// The night side.

// Sine of the sun's height over the horizon at which the first lights come on.
const float lights_on = 0.06;

// Part of the lights' brightness at a place, 0..1. climb: sine of the sun's height.
float night_share(float climb) {
  return 1.0 - smoothstep(-0.12, lights_on, climb);
}
