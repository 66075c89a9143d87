#pragma once

#include <QObject>

#include "editor/document/recovery.h"

namespace editor {

class Document;
class FileActions;
class JobList;
class NoticeBar;

/// Autosaves unsaved work, and offers to recover that of an earlier session.
class RecoveryController : public QObject {
  Q_OBJECT

 public:
  /// All of them outlive the controller. Unsaved work is stored in a folder of `sessions`; see Recovery.
  RecoveryController(Document& document, JobList& jobs, const QString& sessions, FileActions& files,
                     NoticeBar& notice, QObject* parent);

  /// Offers to recover the work of an earlier session that was not closed properly.
  void offer_lost_work();
  /// Sets the time from a change to its autosave, in milliseconds.
  void set_autosave_delay(int delay) { recovery_.set_delay(delay); }

 signals:
  void status_message(const QString& message);
  void failed(const QString& why);

 private:
  struct ReadWork;

  void recover(const LostWork& work);
  void take(const LostWork& work, ReadWork read);

  Document& document_;
  JobList& jobs_;
  FileActions& files_;
  NoticeBar& notice_;
  Recovery recovery_;
};

}  // namespace editor
