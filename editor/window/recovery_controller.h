#pragma once

#include <QObject>

#include "editor/document/recovery.h"

namespace editor {

class Document;
class FileActions;
class JobList;
class NoticeBar;

/// Keeps unsaved work, and offers what an earlier session left.
class RecoveryController : public QObject {
  Q_OBJECT

 public:
  /// All of them outlive the controller. Unsaved work is kept in a folder of `sessions`; see Recovery.
  RecoveryController(Document& document, JobList& jobs, const QString& sessions, FileActions& files,
                     NoticeBar& notice, QObject* parent);

  /// Says so if an earlier session was not closed as it should be, and offers its work.
  void offer_lost_work();

 signals:
  void told(const QString& message);
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
