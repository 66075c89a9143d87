#pragma once

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

namespace test {

/// Answers the next message box.
inline void answer(QMessageBox::StandardButton button) {
  QTimer::singleShot(0, [button] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (question == nullptr) return answer(button);
    question->button(button)->click();
  });
}

}  // namespace test
