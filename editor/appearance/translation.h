// The editor's texts are translated to the language of the user.
#pragma once

#include <QString>

class QCoreApplication;

namespace editor {

/// Installs the translation to a language, such as `es`, of the editor's and Qt's texts; an empty language
/// means that of the system. Texts stay English without a translation. To be called before windows are
/// created. Returns whether there is a translation; the application owns it.
bool install_translation(QCoreApplication& application, const QString& language);

}  // namespace editor
