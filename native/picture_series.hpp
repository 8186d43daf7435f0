// The files of an animation: NAME-0001.png, NAME-0002.png, … and beside them NAME.series.json, which tells what they
// show, so that a series that was interrupted is gone on with and none is mixed with another.
#pragma once

#include <optional>
#include <string>

#include "base/issues.hpp"
#include "base/result.hpp"
#include "native/picture.hpp"

namespace terrella {

class PictureSeries {
 public:
  // out: NAME.png or NAME.pfm. count: of pictures, >= 1. about: JSON with one member a line, all that the pictures
  // depend on; two texts that differ are of two series.
  PictureSeries(const std::string& out, int count, std::string about);

  // The name of a picture's file; index: from 0. Numbers have as many digits as the last one, four at least.
  [[nodiscard]] std::string file(int index) const;

  // Whether pictures of another series, or nobody knows of which, are in the way. Writes nothing.
  [[nodiscard]] std::optional<Issue> in_the_way() const;

  // Writes what tells of the series, if that is not there yet.
  [[nodiscard]] Result<Done> begin() const;

  // Whether a picture is there already, and whole.
  [[nodiscard]] bool has(int index, const PictureTask& task) const;

 private:
  [[nodiscard]] std::string about_file() const { return name_ + ".series.json"; }

  std::string name_, extension_;  // ".png" or ".pfm"
  int count_;
  std::string about_;
};

}  // namespace terrella
