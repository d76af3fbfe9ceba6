#include "tests/support/damage.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/spo_writer.hpp"
#include "server/build/build_octree.hpp"
#include "server/build/certify.hpp"
#include "server/solid/import_solid.hpp"
#include "server/solid/repair.hpp"

namespace spoctree {

namespace {

// What the child tells its parent while it lives. Plain memory that both see.
struct Progress {
  std::size_t next;  // the case under way
  std::size_t solids;
  std::size_t built;
  double slowest_seconds;
  std::size_t slowest;
  char complaint[512];  // about a case that did not crash
};

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;  // needs address space and memory for itself
#else
constexpr bool kIsSanitized = false;
#endif

// Address space is more than memory: stacks and arenas of threads that are never touched.
void limit_process() {
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  if (kIsSanitized) return;
  const rlimit space{3 * kMostBytes, 3 * kMostBytes};
  ::setrlimit(RLIMIT_AS, &space);
}

// A signal ends the process when it has used so much processor time from now on.
void start_timer() {
  itimerval timer{};
  timer.it_value.tv_sec = kIsSanitized ? 20 * kMostSeconds : kMostSeconds;
  ::setitimer(ITIMER_PROF, &timer, nullptr);
  ::alarm(30 * kMostSeconds);  // in case it waits for nothing
}

// One file through the server. True if it is a solid.
bool run_case(const std::string& name, MeshFormat format, const std::string& bytes,
              const DamageOptions& options, Progress& progress) {
  PolygonSoup soup = parse_mesh(format, bytes, name);
  ImportOptions import_options;
  if (options.repair) {
    soup = repair(std::move(soup)).soup;
    import_options.turn_shells = true;
  }
  const Solid solid = import_solid(soup, name, import_options);
  if (progress.solids++ % options.build_every != 0) return true;
  ++progress.built;
  const SolidQueries queries(solid);
  BuiltOctree built;
  try {
    built = build_octree(solid, queries, {});
  } catch (const BadInput& error) {
    throw BadInput(name + ": " + error.what());
  }
  certify(built, solid, queries);
  if (!validate(built.tree).empty()) throw std::logic_error("built an invalid tree");
  return true;
}

void run_cases(const std::string& name, MeshFormat format, std::string_view bytes,
               std::span<const Damage> damages, const DamageOptions& options, Progress& progress) {
  for (; progress.next < damages.size(); ++progress.next) {
    const double begin = processor_seconds();
    start_timer();
    try {
      run_case(name, format, damaged(bytes, damages[progress.next]), options, progress);
    } catch (const BadInput& error) {
      const std::string text = error.what();
      if (!text.starts_with(name) || text.find('\n') != std::string::npos) {
        std::snprintf(progress.complaint, sizeof progress.complaint, "a bad message: %s",
                      error.what());
      }
    } catch (const std::exception& error) {
      std::snprintf(progress.complaint, sizeof progress.complaint, "throws: %s", error.what());
    }
    if (progress.complaint[0] != '\0') return;
    const double seconds = processor_seconds() - begin;
    if (seconds > progress.slowest_seconds) {
      progress.slowest_seconds = seconds;
      progress.slowest = progress.next;
    }
  }
}

std::size_t peak_bytes_of(const rusage& usage) {
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

std::string read_whole(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::string to_text(const Damage& damage) {
  char text[64] = "undamaged";
  if (damage.kind == Damage::Kind::Cut) {
    std::snprintf(text, sizeof text, "cut to %zu bytes", damage.at);
  } else if (damage.kind == Damage::Kind::Flip) {
    std::snprintf(text, sizeof text, "byte %zu ^ 0x%02x", damage.at, damage.bits);
  }
  return text;
}

std::string damaged(std::string_view bytes, const Damage& damage) {
  std::string result(bytes);
  if (damage.kind == Damage::Kind::Cut) result.resize(damage.at);
  if (damage.kind == Damage::Kind::Flip) {
    result[damage.at] = static_cast<char>(result[damage.at] ^ damage.bits);
  }
  return result;
}

std::vector<Damage> every_damage(std::size_t file_bytes, std::size_t step) {
  constexpr unsigned char kBits[] = {0x01, 0x80, 0xff, 0x02, 0x40, 0x08, 0x20, 0x04, 0x10};
  std::vector<Damage> damages;
  for (std::size_t at = 0; at < file_bytes; at += step) {
    damages.push_back({Damage::Kind::Cut, at, 0});
    damages.push_back({Damage::Kind::Flip, at, kBits[at / step % std::size(kBits)]});
  }
  return damages;
}

DamageReport& DamageReport::operator+=(const DamageReport& other) {
  files += other.files;
  solids += other.solids;
  built += other.built;
  if (other.slowest_seconds > slowest_seconds) {
    slowest_seconds = other.slowest_seconds;
    slowest = other.slowest;
  }
  peak_bytes = std::max(peak_bytes, other.peak_bytes);
  failures.insert(failures.end(), other.failures.begin(), other.failures.end());
  return *this;
}

DamageReport judge_damaged(const std::string& name, MeshFormat format, std::string_view bytes,
                           std::span<const Damage> damages, const DamageOptions& options) {
  void* shared =
      ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw std::runtime_error("no shared memory");
  Progress& progress = *static_cast<Progress*>(shared);
  DamageReport report;
  report.files = damages.size();
  while (progress.next < damages.size()) {
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) {
      limit_process();
      run_cases(name, format, bytes, damages, options, progress);
      ::_exit(0);
    }
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    report.peak_bytes = std::max(report.peak_bytes, peak_bytes_of(usage));
    std::string failure = progress.complaint;
    if (WIFSIGNALED(status)) failure = std::string("ends by ") + ::strsignal(WTERMSIG(status));
    if (WIFEXITED(status) && WEXITSTATUS(status) != 0) failure = "exits";
    if (!failure.empty() && progress.next < damages.size()) {
      report.failures.push_back(name + (options.repair ? " --repair, " : ", ") +
                                to_text(damages[progress.next]) + ": " + failure);
      progress.complaint[0] = '\0';
      ++progress.next;
    }
  }
  if (!kIsSanitized && report.peak_bytes > kMostBytes) {
    report.failures.push_back(name + ": takes " + std::to_string(report.peak_bytes) + " bytes");
  }
  report.solids = progress.solids;
  report.built = progress.built;
  report.slowest_seconds = progress.slowest_seconds;
  if (progress.slowest < damages.size()) report.slowest = damages[progress.slowest];
  ::munmap(shared, sizeof(Progress));
  return report;
}

WatchedRun run_watched(const std::vector<std::string>& words) {
  std::string pattern = (std::filesystem::temp_directory_path() / "spoctree-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  const std::filesystem::path folder = pattern;
  const std::string out = (folder / "out").string();
  const std::string err = (folder / "err").string();
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    limit_process();
    const rlim_t seconds = kIsSanitized ? 20 * kMostSeconds : kMostSeconds;
    const rlimit time{seconds, seconds};
    ::setrlimit(RLIMIT_CPU, &time);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  WatchedRun run;
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  run.out = read_whole(out);
  run.err = read_whole(err);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  run.seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  run.peak_bytes = peak_bytes_of(usage);
  std::filesystem::remove_all(folder);
  return run;
}

}  // namespace spoctree
