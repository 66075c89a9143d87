#include "renderer/command/signal_handler.h"

#include <cstdlib>
#include <ctime>

#include <pthread.h>

#include "grf/exit_code.h"

namespace command {

SignalHandler::SignalHandler() {
  sigemptyset(&set_);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&set_, signal);
  pthread_sigmask(SIG_BLOCK, &set_, &before_);
  sigdelset(&set_, SIGPIPE);
  thread_ = std::thread([this] { wait(); });
}

SignalHandler::~SignalHandler() {
  ended_ = true;
  thread_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void SignalHandler::wait() {
  const timespec timeout = {0, 20'000'000};
  while (!ended_) {
    if (sigtimedwait(&set_, nullptr, &timeout) <= 0) continue;
    const std::lock_guard lock(stop_lock_);
    if (!stop_ || was_signalled_) std::_Exit(static_cast<int>(grf::ExitCode::Interrupted));
    was_signalled_ = true;
    stop_();
  }
}

}  // namespace command
