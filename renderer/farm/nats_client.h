// NATS JetStream, through types that own what its C library allocates.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct __jsCtx;
struct __natsConnection;
struct __natsMsg;
struct __natsSubscription;

namespace farm {

/// How to reach a server. Empty: not given.
struct Access {
  std::string url = "nats://127.0.0.1:4222";
  std::string token;
  std::string tls_authority;    ///< file of the certificates that the server's is signed by
  std::string tls_certificate;  ///< file of the own certificate, for servers that ask for one
  std::string tls_key;

  bool has_tls() const { return !tls_authority.empty() || !tls_certificate.empty(); }
};

/// A message that was fetched. It returns to its queue unless it is acknowledged in time.
class Message {
 public:
  explicit Message(__natsMsg* message) : message_(message) {}

  std::string_view subject() const;
  std::string_view data() const;
  /// Removes it from its queue.
  void acknowledge() const;
  /// Returns it to its queue at once.
  void give_back() const;
  /// Begins the time until it returns anew.
  void extend() const;

 private:
  struct Destroy {
    void operator()(__natsMsg* message) const;
  };
  std::unique_ptr<__natsMsg, Destroy> message_;
};

/// How a stream keeps messages.
struct StreamSettings {
  std::string name;
  std::string subjects;
  bool is_queue = false;        ///< messages are removed once acknowledged; else the last per subject is kept
  bool is_in_memory = false;    ///< and lost when the server ends
  std::chrono::seconds age{0};  ///< after which messages are removed; 0: never
};

/// The state of a queue.
struct QueueState {
  std::uint64_t waiting = 0;  ///< messages that nobody has
  std::uint64_t given = 0;    ///< messages that somebody has not acknowledged yet
};

/// Fetches messages of a queue.
class Subscription {
 public:
  explicit Subscription(__natsSubscription* subscription) : subscription_(subscription) {}

  /// Waits until there are messages, and returns at most this many; none after the time, or an error.
  std::vector<Message> fetch(int most, std::chrono::milliseconds time) const;

 private:
  struct Destroy {
    void operator()(__natsSubscription* subscription) const;
  };
  std::unique_ptr<__natsSubscription, Destroy> subscription_;
};

/// A connection to a server. It connects again, for as long as that takes, when the server was away;
/// functions return nothing, or false, after some seconds without one. They may be called by several threads.
class Connection {
 public:
  /// Returns nothing, and sets `problem`, if there is no connection. The name is for the server's log.
  static std::optional<Connection> open(const Access& access, const std::string& name, std::string& problem);

  std::size_t largest_message() const;
  /// Whether it was closed for good, as by a server that refuses the token.
  bool is_closed() const;

  /// Makes sure that a stream exists.
  bool add_stream(const StreamSettings& settings) const;
  /// Appends a message to the stream of its subject; true once the server has it.
  bool publish(const std::string& subject, std::string_view bytes) const;
  /// Appends messages to one subject, and waits once for all of them.
  bool publish(const std::string& subject, const std::vector<std::string>& messages) const;
  std::optional<std::string> last_message(const std::string& stream, const std::string& subject) const;
  /// Lists the subjects, which may have wildcards, of which a stream has messages.
  std::optional<std::vector<std::string>> subjects(const std::string& stream,
                                                   const std::string& wanted) const;
  /// Removes all messages of a subject.
  bool purge(const std::string& stream, const std::string& subject) const;

  /// Makes sure that the messages of a subject can be fetched under a name. Those that nobody acknowledges
  /// for the time `lease` return.
  bool add_queue(const std::string& stream, const std::string& name, const std::string& subject,
                 std::chrono::milliseconds lease) const;
  bool remove_queue(const std::string& stream, const std::string& name) const;
  std::optional<QueueState> queue_state(const std::string& stream, const std::string& name) const;
  std::optional<Subscription> subscribe(const std::string& stream, const std::string& name,
                                        const std::string& subject) const;

 private:
  struct DestroyConnection {
    void operator()(__natsConnection* connection) const;
  };
  struct DestroyContext {
    void operator()(__jsCtx* context) const;
  };

  std::unique_ptr<__natsConnection, DestroyConnection> connection_;
  std::unique_ptr<__jsCtx, DestroyContext> context_;
};

}  // namespace farm
