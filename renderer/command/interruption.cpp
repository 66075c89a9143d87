#include "renderer/command/interruption.h"

#include <cstdlib>
#include <ctime>

#include <pthread.h>

#include "grf/exit_code.h"

namespace command {

Interruption::Interruption() {
  sigemptyset(&set_);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&set_, signal);
  pthread_sigmask(SIG_BLOCK, &set_, &before_);
  sigdelset(&set_, SIGPIPE);
  thread_ = std::thread([this] { wait(); });
}

Interruption::~Interruption() {
  ended_ = true;
  thread_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interruption::wait() {
  const timespec timeout = {0, 20'000'000};
  while (!ended_) {
    if (sigtimedwait(&set_, nullptr, &timeout) <= 0) continue;
    const std::lock_guard lock(stop_lock_);
    if (!stop_ || has_come_) std::_Exit(static_cast<int>(grf::ExitCode::Interrupted));
    has_come_ = true;
    stop_();
  }
}

}  // namespace command
