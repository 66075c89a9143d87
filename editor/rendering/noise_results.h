// The results of `bpt noise` as the editor reads them.
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>
#include <vector>

namespace editor {

/// A part of an image's light, and of its noise.
struct NoiseShareRow {
  enum class Kind { AreaLight, Mesh, Surroundings, Bounces, Brdf, SeenLight };
  Kind kind = Kind::Surroundings;
  QString name;
  double noise = 0;
  double light = 0;
  int number = 0;  ///< of a lamp: see transport::Lamp; else of bounces
  QString brdf;    ///< and its scheme, as written in the scene
  QString scheme;
};

/// A change of settings, see job::NoiseChange, and what it does if it was tried.
struct NoiseTrial {
  struct Ratio {
    double value = 1;
    double low = 1;  ///< of the 95 % interval
    double high = 1;
  };
  QString word;    ///< of `bpt noise --change`
  QString option;  ///< key; empty for a scheme of the faces with a BRDF
  QString value;
  QString before;
  QString brdf;
  bool is_tried = false;
  bool pays = false;
  Ratio variance, time, cost;
};

struct NoiseResult {
  double error = 0;
  int samples = 0;
  int width = 0;
  int height = 0;
  std::vector<NoiseShareRow> lamps, bounces, brdfs;
  std::vector<NoiseTrial> changes;
};

/// Reads the line of `bpt noise --progress json` with the shares; empty if it is another one.
std::optional<NoiseResult> noise_result_of(const QByteArray& line);
/// Reads a line with a change that was tried, likewise.
std::optional<NoiseTrial> noise_trial_of(const QByteArray& line);

}  // namespace editor
