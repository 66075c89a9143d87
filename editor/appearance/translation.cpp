#include "editor/appearance/translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <memory>

namespace editor {
namespace {

bool install(QCoreApplication& application, const QLocale& locale, const QString& name,
             const QString& folder) {
  auto translator = std::make_unique<QTranslator>(&application);
  if (!translator->load(locale, name, "_", folder)) return false;
  return QCoreApplication::installTranslator(translator.release());
}

}  // namespace

bool install_translation(QCoreApplication& application, const QString& language) {
  const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
  if (!install(application, locale, "wannabe", ":/translations")) return false;
  install(application, locale, "qtbase", QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  return true;
}

}  // namespace editor
