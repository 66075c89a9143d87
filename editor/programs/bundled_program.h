// Finds the other programs of the project, which the editor runs as child processes.
#pragma once

#include <QString>

namespace editor {

/// The path of `bpt` or `grfconvert`: in the folder of this program, as they are built and installed, else in
/// PATH. Empty if it is not found.
QString bundled_program(const QString& name);

}  // namespace editor
