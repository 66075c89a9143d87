// Where the editor finds the other programs of the project, which it runs as processes of their own.
#pragma once

#include <QString>

namespace editor {

/// The path of `bpt` or `grfconvert`: that in the folder of this program, as they are built and installed,
/// else that in PATH. Empty: there is none.
QString bundled_program(const QString& name);

}  // namespace editor
