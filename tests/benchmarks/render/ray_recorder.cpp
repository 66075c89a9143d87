// A library to be preloaded into bpt (LD_PRELOAD): it records the rays of a render and replays them through
// Embree alone, back to back. On exit it writes a line `kind rays seconds` each for `camera`, `shadow` and
// `bounce` rays to the file that RAY_RECORDER names; the seconds are the processor time of all threads for
// replaying them.
//
// Rays of occlusion queries are shadow rays. Other rays are camera rays if their origin is the eye, which
// RAY_RECORDER_EYE gives as three numbers, else bounce rays. The kind of a packet is that of its first active
// ray.
//
// Each thread replays its rays when it has a batch of them: first the camera rays, then the shadow rays, then
// the bounce rays, each in the order of recording. The rest is replayed when the renderer first releases a
// scene, for which it has to be idle. The renderer's filters are called with copies of the queries' contexts,
// so contexts must not have pointers to anything that changes.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <tuple>
#include <type_traits>
#include <vector>

#include "tests/benchmarks/render/embree_queries.h"

namespace {

using embree_queries::next;
using embree_queries::Packet;
using embree_queries::PerThread;
using embree_queries::Single;

constexpr std::size_t Batch = 4096;       // rays; below 1 MB, so that they come from the L2 cache
constexpr std::size_t ContextBytes = 64;  // Embree's context has 24 bytes; shadow rays of bpt add 20
constexpr std::size_t RayFields = 12;     // of RTCRayN, 4 bytes per ray each: RTCRay is RTCRayN of one ray
constexpr std::size_t HitFields = 8;      // of RTCHitN
constexpr std::size_t GeometryField = 6;  // geomID, before instID
constexpr std::uint32_t InvalidId = ~0U;

enum Kind : std::size_t { Camera, Shadow, Bounce, KindCount };
constexpr std::array<const char*, KindCount> KindNames = {"camera", "shadow", "bounce"};

using Context = std::array<std::byte, ContextBytes>;

/// Arrays of a field of each ray.
template <std::size_t N, std::size_t Fields>
using Packed = std::array<std::array<std::uint32_t, N>, Fields>;

template <std::size_t N>
constexpr std::size_t Alignment = N == 1 ? 16 : 4 * N;

template <std::size_t N>
struct Query {
  alignas(Alignment<N>) Packed<N, RayFields> rays;
  alignas(Alignment<N>) std::array<int, N> valid;
  alignas(8) Context context;
  void* scene;
};

/// The queries of one function of Embree.
template <std::size_t N, bool IsOcclusion>
class Queries {
 public:
  using Function = std::conditional_t<N == 1, Single, Packet>;

  void add(Function* function, const Query<N>& query) {
    function_ = function;
    queries_.push_back(query);
  }

  void replay() {
    for (const Query<N>& query : queries_) ask(query);
    queries_.clear();
  }

 private:
  void ask(const Query<N>& query) const {
    Context context = query.context;
    struct alignas(Alignment<N>) {
      Packed<N, RayFields> rays;
      Packed<N, IsOcclusion ? 0 : HitFields> hits;
    } asked;
    asked.rays = query.rays;
    if constexpr (!IsOcclusion) {
      asked.hits[GeometryField].fill(InvalidId);
      asked.hits[GeometryField + 1].fill(InvalidId);
    }
    if constexpr (N == 1) {
      function_(query.scene, context.data(), &asked);
    } else {
      function_(query.valid.data(), query.scene, context.data(), &asked);
    }
  }

  Function* function_ = nullptr;
  std::vector<Query<N>> queries_;
};

template <bool IsOcclusion>
using AllQueries = std::tuple<Queries<1, IsOcclusion>, Queries<4, IsOcclusion>, Queries<8, IsOcclusion>,
                              Queries<16, IsOcclusion>>;

struct Sum {
  std::uint64_t rays = 0;
  double seconds = 0;
};

/// The processor time of this thread, which the waiting of a busy machine does not add to.
double thread_seconds() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::array<float, 3> eye() {
  const char* text = std::getenv("RAY_RECORDER_EYE");
  std::array<float, 3> eye = {};
  if (text == nullptr || std::sscanf(text, "%f %f %f", &eye[0], &eye[1], &eye[2]) != 3) std::abort();
  return eye;
}

/// The rays of one thread.
class Recording {
 public:
  template <std::size_t N, bool IsOcclusion, class Function>
  void add(Function* function, const Query<N>& query) {
    std::uint64_t rays = 0;
    std::size_t first = N;
    for (std::size_t i = 0; i < N; ++i) {
      if (query.valid[i] == 0) continue;
      if (rays++ == 0) first = i;
    }
    if (rays == 0) return;
    const Kind kind = IsOcclusion ? Shadow : is_camera_ray(query, first) ? Camera : Bounce;
    if constexpr (IsOcclusion) {
      std::get<Queries<N, true>>(shadow_).add(function, query);
    } else {
      std::get<Queries<N, false>>(kind == Camera ? camera_ : bounce_).add(function, query);
    }
    sums_[kind].rays += rays;
    waiting_ += rays;
    if (waiting_ >= Batch) replay();
  }

  void replay() {
    replay(camera_, sums_[Camera]);
    replay(shadow_, sums_[Shadow]);
    replay(bounce_, sums_[Bounce]);
    waiting_ = 0;
  }

  const Sum& sum(Kind kind) const { return sums_[kind]; }

 private:
  template <std::size_t N>
  bool is_camera_ray(const Query<N>& query, std::size_t ray) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float origin = 0;
      std::memcpy(&origin, &query.rays[axis][ray], sizeof(origin));
      if (origin != eye_[axis]) return false;
    }
    return true;
  }

  template <class All>
  static void replay(All& queries, Sum& sum) {
    const double start = thread_seconds();
    std::apply([](auto&... each) { (each.replay(), ...); }, queries);
    sum.seconds += thread_seconds() - start;
  }

  std::array<float, 3> eye_ = eye();
  AllQueries<false> camera_, bounce_;
  AllQueries<true> shadow_;
  std::array<Sum, KindCount> sums_;
  std::uint64_t waiting_ = 0;
};

/// The recordings of all threads.
class Recorder {
 public:
  Recorder() = default;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder() { write(); }

  Recording& new_recording() { return recordings_.add(); }
  void replay() {
    recordings_.for_each([](Recording& recording) { recording.replay(); });
  }

 private:
  void write() {
    const char* path = std::getenv("RAY_RECORDER");
    std::FILE* file = path != nullptr ? std::fopen(path, "w") : nullptr;
    if (file == nullptr) return;
    for (const Kind kind : {Camera, Shadow, Bounce}) {
      Sum all;
      recordings_.for_each([&](const Recording& recording) {
        all.rays += recording.sum(kind).rays;
        all.seconds += recording.sum(kind).seconds;
      });
      std::fprintf(file, "%s %.0f %.9g\n", KindNames[kind], static_cast<double>(all.rays), all.seconds);
    }
    std::fclose(file);
  }

  PerThread<Recording> recordings_;
};

Recorder& recorder() {
  static Recorder recorder;
  return recorder;
}

/// Records a query before the renderer's own changes it.
template <std::size_t N, bool IsOcclusion, class Function>
void record(Function* function, const int* valid, void* scene, const void* context, const void* rays) {
  thread_local Recording& recording = recorder().new_recording();
  Query<N> query;
  if (valid == nullptr) {
    query.valid.fill(-1);
  } else {
    std::memcpy(query.valid.data(), valid, sizeof(query.valid));
  }
  std::memcpy(query.context.data(), context, ContextBytes);
  std::memcpy(&query.rays, rays, sizeof(query.rays));
  query.scene = scene;
  recording.add<N, IsOcclusion>(function, query);
}

}  // namespace

// NOLINTBEGIN(readability-identifier-naming)
#define SINGLE(NAME, IS_OCCLUSION)                                \
  extern "C" void NAME(void* scene, void* context, void* ray) {   \
    static Single* const query = next<Single>(#NAME);             \
    record<1, IS_OCCLUSION>(query, nullptr, scene, context, ray); \
    query(scene, context, ray);                                   \
  }
#define PACKET(NAME, SIZE, IS_OCCLUSION)                                           \
  extern "C" void NAME(const int* valid, void* scene, void* context, void* rays) { \
    static Packet* const query = next<Packet>(#NAME);                              \
    record<SIZE, IS_OCCLUSION>(query, valid, scene, context, rays);                \
    query(valid, scene, context, rays);                                            \
  }
SINGLE(rtcIntersect1, false)
SINGLE(rtcOccluded1, true)
PACKET(rtcIntersect4, 4, false)
PACKET(rtcOccluded4, 4, true)
PACKET(rtcIntersect8, 8, false)
PACKET(rtcOccluded8, 8, true)
PACKET(rtcIntersect16, 16, false)
PACKET(rtcOccluded16, 16, true)

extern "C" void rtcReleaseScene(void* scene) {
  using Release = void(void* scene);
  static Release* const release = next<Release>("rtcReleaseScene");
  recorder().replay();
  release(scene);
}
// NOLINTEND(readability-identifier-naming)
