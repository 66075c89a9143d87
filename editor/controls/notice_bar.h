#pragma once

#include <QFrame>
#include <QString>
#include <functional>
#include <vector>

class QLabel;
class QHBoxLayout;

namespace editor {

/// A notification bar over the view with actions, which is not modal: for work that can be recovered, or a
/// file that could not be read. Hidden while there is no notice.
class NoticeBar : public QFrame {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  enum class Kind { Information, Error };
  struct Choice {
    QString text;
    QString tip;
    std::function<void()> action;  ///< the bar is hidden before it runs
  };
  /// Replaces the shown notice. The last choice always closes the bar.
  void show_notice(Kind kind, const QString& text, const std::vector<Choice>& choices = {});
  const QString& text() const { return text_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Kind kind_ = Kind::Information;
  QString text_;
  QLabel* label_;
  QHBoxLayout* choices_;
};

}  // namespace editor
