// Figures 5.13 and 5.14 show the same image by several techniques.
#pragma once

#include <string>
#include <vector>

#include "samples/studies/thesis/measure.h"

namespace study {

struct PictureRow {
  std::string scene;
  std::vector<std::string> techniques;  ///< in the order of the picture
  int samples_root = 10;                ///< square root of the number of secondary rays of `naive`
  bool is_stacked = false;              ///< vertically; else side by side
  float exposure = 0;                   ///< stops
};

// Figure 5.13 and figure 5.14.
PictureRow dragon_pictures();
PictureRow pottery_pictures();

/// Renders the images and writes them as one PNG. Throws on errors.
void write_pictures(const PictureRow& row, const std::vector<Group>& groups, const Programs& programs,
                    const std::string& work, const std::string& path);

}  // namespace study
