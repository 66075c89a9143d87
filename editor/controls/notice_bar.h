#pragma once

#include <QFrame>
#include <QString>
#include <functional>
#include <vector>

class QLabel;
class QHBoxLayout;

namespace editor {

/// A line over the view that says something and offers what to do about it, without stopping anybody: work
/// that can be recovered, a file that could not be read. Hidden while there is nothing to say.
class NoticeBar : public QFrame {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  enum class Kind { Information, Error };
  struct Choice {
    QString text;
    QString tip;
    std::function<void()> action;  ///< the bar is hidden first
  };
  /// In place of what it said before. The last choice is always to close it.
  void show_notice(Kind kind, const QString& text, const std::vector<Choice>& choices = {});
  QString text() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Kind kind_ = Kind::Information;
  QLabel* text_;
  QHBoxLayout* choices_;
};

}  // namespace editor
