#include "editor/controls/counted.h"

#include <QLocale>

namespace editor {

QString count_text(std::size_t number) {
  constexpr std::size_t FirstInGroups = 10000;
  if (number < FirstInGroups) return QString::number(number);
  constexpr QChar Space(0x00A0);  // non-breaking
  QLocale locale = QLocale::c();
  locale.setNumberOptions(QLocale::DefaultNumberOptions);  // the C locale omits group separators by default
  return locale.toString(static_cast<qulonglong>(number)).replace(',', Space);
}

QString counted(std::size_t number, const QString& one, const QString& many) {
  return number == 1 ? one : many.arg(count_text(number));
}

}  // namespace editor
