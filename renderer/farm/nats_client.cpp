#include "renderer/farm/nats_client.h"

#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nats/nats.h>

namespace farm {
namespace {

constexpr std::int64_t WaitMilliseconds = 5000;

template <class T, void (*Destroy)(T*)>
struct Destroyer {
  void operator()(T* object) const { Destroy(object); }
};
using Options = std::unique_ptr<natsOptions, Destroyer<natsOptions, natsOptions_Destroy>>;
using StreamInfo = std::unique_ptr<jsStreamInfo, Destroyer<jsStreamInfo, jsStreamInfo_Destroy>>;
using ConsumerInfo = std::unique_ptr<jsConsumerInfo, Destroyer<jsConsumerInfo, jsConsumerInfo_Destroy>>;

jsOptions js_options() {
  jsOptions options;
  jsOptions_Init(&options);
  options.Wait = WaitMilliseconds;
  return options;
}

std::int64_t nanoseconds(std::chrono::nanoseconds time) { return time.count(); }

/// Sets the options of a connection; returns the first that failed.
natsStatus set_options(natsOptions* options, const Access& access, const std::string& name) {
  constexpr int Forever = -1;
  constexpr std::int64_t RetryMilliseconds = 250;
  natsStatus status = natsOptions_SetURL(options, access.url.c_str());
  const auto then = [&](natsStatus next) {
    if (status == NATS_OK) status = next;
  };
  then(natsOptions_SetName(options, name.c_str()));
  then(natsOptions_SetTimeout(options, WaitMilliseconds));
  then(natsOptions_SetMaxReconnect(options, Forever));
  then(natsOptions_SetReconnectWait(options, RetryMilliseconds));
  if (!access.token.empty()) then(natsOptions_SetToken(options, access.token.c_str()));
  if (access.has_tls()) then(natsOptions_SetSecure(options, true));
  if (!access.tls_authority.empty()) {
    then(natsOptions_LoadCATrustedCertificates(options, access.tls_authority.c_str()));
  }
  if (!access.tls_certificate.empty()) {
    then(natsOptions_LoadCertificatesChain(options, access.tls_certificate.c_str(), access.tls_key.c_str()));
  }
  return status;
}

std::string problem_of(natsStatus status, const Access& access) {
  if (status == NATS_CONNECTION_AUTH_FAILED) {
    return fmt::format("{} refuses the connection: the token is missing or wrong (--token-file)", access.url);
  }
  if (status == NATS_NO_SERVER) {
    return fmt::format("no server answers at {}: `bpt farm serve` starts one", access.url);
  }
  return fmt::format("cannot connect to {}: {}", access.url, natsStatus_GetText(status));
}

}  // namespace

std::string_view Message::subject() const { return natsMsg_GetSubject(message_.get()); }

std::string_view Message::data() const {
  return {natsMsg_GetData(message_.get()), static_cast<std::size_t>(natsMsg_GetDataLength(message_.get()))};
}

// These may fail: the message then returns to its queue, as it does when its receiver dies.
void Message::acknowledge() const { natsMsg_Ack(message_.get(), nullptr); }
void Message::give_back() const { natsMsg_Nak(message_.get(), nullptr); }
void Message::extend() const { natsMsg_InProgress(message_.get(), nullptr); }

void Message::Destroy::operator()(natsMsg* message) const { natsMsg_Destroy(message); }

std::vector<Message> Subscription::fetch(int most, std::chrono::milliseconds time) const {
  natsMsgList list = {};
  const natsStatus status = natsSubscription_Fetch(&list, subscription_.get(), most, time.count(), nullptr);
  std::vector<Message> messages;
  // Without a connection it fails at once, and would be tried again at once.
  if (status != NATS_OK && status != NATS_TIMEOUT) std::this_thread::sleep_for(time);
  if (status != NATS_OK) return messages;
  for (int i = 0; i < list.Count; ++i) messages.emplace_back(std::exchange(list.Msgs[i], nullptr));
  natsMsgList_Destroy(&list);
  return messages;
}

void Subscription::Destroy::operator()(natsSubscription* subscription) const {
  natsSubscription_Destroy(subscription);
}

void Connection::DestroyConnection::operator()(natsConnection* connection) const {
  natsConnection_Destroy(connection);
}
void Connection::DestroyContext::operator()(jsCtx* context) const { jsCtx_Destroy(context); }

std::optional<Connection> Connection::open(const Access& access, const std::string& name,
                                           std::string& problem) {
  natsOptions* created = nullptr;
  natsStatus status = natsOptions_Create(&created);
  const Options options(created);
  if (status == NATS_OK) status = set_options(options.get(), access, name);
  Connection connection;
  natsConnection* connected = nullptr;
  if (status == NATS_OK) status = natsConnection_Connect(&connected, options.get());
  connection.connection_.reset(connected);
  jsCtx* context = nullptr;
  jsOptions of_context = js_options();
  if (status == NATS_OK) status = natsConnection_JetStream(&context, connected, &of_context);
  connection.context_.reset(context);
  if (status == NATS_OK) return connection;
  problem = problem_of(status, access);
  return std::nullopt;
}

std::size_t Connection::largest_message() const {
  return static_cast<std::size_t>(natsConnection_GetMaxPayload(connection_.get()));
}

bool Connection::is_closed() const { return natsConnection_IsClosed(connection_.get()); }

bool Connection::add_stream(const StreamSettings& settings) const {
  jsStreamConfig config;
  jsStreamConfig_Init(&config);
  const char* subjects = settings.subjects.c_str();
  config.Name = settings.name.c_str();
  config.Subjects = &subjects;
  config.SubjectsLen = 1;
  config.Retention = settings.is_queue ? js_WorkQueuePolicy : js_LimitsPolicy;
  config.Storage = settings.is_in_memory ? js_MemoryStorage : js_FileStorage;
  if (!settings.is_queue) config.MaxMsgsPerSubject = 1;
  config.MaxAge = nanoseconds(settings.age);
  // Another version of bpt may have made it with other settings.
  return js_AddStream(nullptr, context_.get(), &config, nullptr, nullptr) == NATS_OK ||
         js_UpdateStream(nullptr, context_.get(), &config, nullptr, nullptr) == NATS_OK;
}

bool Connection::publish(const std::string& subject, std::string_view bytes) const {
  return js_Publish(nullptr, context_.get(), subject.c_str(), bytes.data(), static_cast<int>(bytes.size()),
                    nullptr, nullptr) == NATS_OK;
}

bool Connection::publish(const std::string& subject, const std::vector<std::string>& messages) const {
  constexpr std::size_t AtOnce = 1000;  // the client library waits for no more than 4000
  jsPubOptions options;
  jsPubOptions_Init(&options);
  options.MaxWait = WaitMilliseconds;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (js_PublishAsync(context_.get(), subject.c_str(), messages[i].data(),
                        static_cast<int>(messages[i].size()), nullptr) != NATS_OK) {
      return false;
    }
    const bool is_last = i + 1 == messages.size();
    if ((is_last || (i + 1) % AtOnce == 0) && js_PublishAsyncComplete(context_.get(), &options) != NATS_OK) {
      return false;
    }
  }
  return true;
}

std::optional<std::string> Connection::last_message(const std::string& stream,
                                                    const std::string& subject) const {
  natsMsg* found = nullptr;
  if (js_GetLastMsg(&found, context_.get(), stream.c_str(), subject.c_str(), nullptr, nullptr) != NATS_OK) {
    return std::nullopt;
  }
  return std::string(Message(found).data());
}

std::optional<std::vector<std::string>> Connection::subjects(const std::string& stream,
                                                             const std::string& wanted) const {
  jsOptions options = js_options();
  options.Stream.Info.SubjectsFilter = wanted.c_str();
  jsStreamInfo* found = nullptr;
  if (js_GetStreamInfo(&found, context_.get(), stream.c_str(), &options, nullptr) != NATS_OK) {
    return std::nullopt;
  }
  const StreamInfo info(found);
  std::vector<std::string> subjects;
  const jsStreamStateSubjects* list = info->State.Subjects;
  for (int i = 0; list != nullptr && i < list->Count; ++i) subjects.emplace_back(list->List[i].Subject);
  return subjects;
}

bool Connection::purge(const std::string& stream, const std::string& subject) const {
  jsOptions options = js_options();
  options.Stream.Purge.Subject = subject.c_str();
  return js_PurgeStream(context_.get(), stream.c_str(), &options, nullptr) == NATS_OK;
}

bool Connection::add_queue(const std::string& stream, const std::string& name, const std::string& subject,
                           std::chrono::milliseconds lease) const {
  constexpr int Unlimited = -1;
  jsConsumerConfig config;
  jsConsumerConfig_Init(&config);
  config.Durable = name.c_str();
  config.FilterSubject = subject.c_str();
  config.AckPolicy = js_AckExplicit;
  config.AckWait = nanoseconds(lease);
  config.MaxAckPending = Unlimited;
  config.MaxDeliver = Unlimited;
  jsConsumerInfo* made = nullptr;
  const natsStatus status = js_AddConsumer(&made, context_.get(), stream.c_str(), &config, nullptr, nullptr);
  const ConsumerInfo info(made);
  return status == NATS_OK;
}

bool Connection::remove_queue(const std::string& stream, const std::string& name) const {
  return js_DeleteConsumer(context_.get(), stream.c_str(), name.c_str(), nullptr, nullptr) == NATS_OK;
}

std::optional<QueueState> Connection::queue_state(const std::string& stream, const std::string& name) const {
  jsConsumerInfo* found = nullptr;
  if (js_GetConsumerInfo(&found, context_.get(), stream.c_str(), name.c_str(), nullptr, nullptr) != NATS_OK) {
    return std::nullopt;
  }
  const ConsumerInfo info(found);
  return QueueState{info->NumPending, static_cast<std::uint64_t>(info->NumAckPending)};
}

std::optional<Subscription> Connection::subscribe(const std::string& stream, const std::string& name,
                                                  const std::string& subject) const {
  jsSubOptions options;
  jsSubOptions_Init(&options);
  options.Stream = stream.c_str();
  options.Consumer = name.c_str();
  natsSubscription* made = nullptr;
  if (js_PullSubscribe(&made, context_.get(), subject.c_str(), name.c_str(), nullptr, &options, nullptr) !=
      NATS_OK) {
    return std::nullopt;
  }
  return Subscription(made);
}

}  // namespace farm
