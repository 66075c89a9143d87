// The sample scenes that come with the program.
#pragma once

#include <QString>
#include <vector>

namespace editor {

/// A sample scene and the picture that its render options make of it.
struct SampleScene {
  QString title;
  QString file;
  QString picture;
};

/// Returns the folder of the installed samples, beside the program's own folder. It need not exist: the
/// samples are a package of their own.
QString samples_folder();

/// Returns the scenes in the sub-folders of a folder that have render options and a picture under their
/// name, and all files that they name in quotes, sorted by title.
std::vector<SampleScene> sample_scenes(const QString& folder);

}  // namespace editor
