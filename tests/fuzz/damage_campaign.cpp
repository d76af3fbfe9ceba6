// Every truncation and a flip in every byte of mesh files, through the server's own steps and,
// for some of them, through the whole program. Prints a line per file; exits with 1 if a file
// crashes anything or costs more than a file may.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/damage.hpp"

namespace {

using namespace spoctree;
namespace fs = std::filesystem;

struct CampaignOptions {
  std::vector<std::string> files;
  std::size_t step = 1;
  std::size_t build_every = 20;
  std::string program;
  std::size_t program_every = 500;
};

void print(const std::string& name, const char* how, const DamageReport& report) {
  std::printf("%-62s %-9s %7zu files %6zu solids %6zu built %7.3f s %5zu MiB %s\n", name.c_str(),
              how, report.files, report.solids, report.built, report.slowest_seconds,
              report.peak_bytes >> 20, to_text(report.slowest).c_str());
  for (const std::string& failure : report.failures) std::printf("  FAILED %s\n", failure.c_str());
  std::fflush(stdout);
}

// Damaged copies as files, and the program on them.
DamageReport run_program(const CampaignOptions& options, const fs::path& path,
                         const std::string& bytes, bool is_repaired) {
  DamageReport report;
  std::string pattern = (fs::temp_directory_path() / "spoctree-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) return report;
  const fs::path copy = fs::path(pattern) / path.filename();
  std::vector<Damage> damages = every_damage(bytes.size(), options.step * options.program_every);
  damages.push_back({});
  for (const Damage& damage : damages) {
    const std::string file = damaged(bytes, damage);
    std::ofstream(copy, std::ios::binary).write(file.data(), std::ssize(file));
    std::vector<std::string> words = {options.program, "build", copy.string(), "-o",
                                      (fs::path(pattern) / "out.spo").string()};
    if (is_repaired) words.emplace_back("--repair");
    const WatchedRun run = run_watched(words);
    ++report.files;
    if (run.code == 0) ++report.solids;
    report.peak_bytes = std::max(report.peak_bytes, run.peak_bytes);
    if (run.seconds > report.slowest_seconds) {
      report.slowest_seconds = run.seconds;
      report.slowest = damage;
    }
    const bool is_one_line = std::count(run.err.begin(), run.err.end(), '\n') == 1;
    if (run.code == 0 ? run.err.empty() : run.code == 3 && is_one_line) continue;
    report.failures.push_back(to_text(damage) + ": code " + std::to_string(run.code) + " " +
                              run.err);
  }
  fs::remove_all(pattern);
  return report;
}

}  // namespace

int main(int argc, char** argv) {
  CampaignOptions options;
  CLI::App app("Damages mesh files in every place, and sees what the server makes of them.");
  app.add_option("FILE", options.files)->required()->check(CLI::ExistingFile);
  app.add_option("--step", options.step, "only every n-th byte")->check(CLI::PositiveNumber);
  app.add_option("--build-every", options.build_every, "build every n-th solid")
      ->check(CLI::PositiveNumber);
  app.add_option("--program", options.program, "spoctree-server, for whole runs");
  app.add_option("--program-every", options.program_every, "whole runs for every n-th place")
      ->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);

  bool has_failed = false;
  for (const std::string& name : options.files) {
    const fs::path path = name;
    const auto format = format_of_extension(path);
    if (!format) continue;
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::vector<Damage> damages = every_damage(bytes.size(), options.step);
    for (const bool is_repaired : {false, true}) {
      const DamageReport report =
          judge_damaged(path.filename(), *format, bytes, damages,
                        {.repair = is_repaired, .build_every = options.build_every});
      print(path.filename(), is_repaired ? "--repair" : "plain", report);
      has_failed |= !report.failures.empty();
      if (options.program.empty()) continue;
      const DamageReport runs = run_program(options, path, bytes, is_repaired);
      print(path.filename(), is_repaired ? "program -r" : "program", runs);
      has_failed |= !runs.failures.empty();
    }
  }
  return has_failed ? 1 : 0;
}
