#include "tools/silhouettes/experiment_command.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "common/base/atomic_file.hpp"
#include "common/base/errors.hpp"
#include "common/program/output.hpp"
#include "common/report/text_table.hpp"
#include "tools/silhouettes/experiment_report.hpp"

namespace spoctree {

namespace {

std::string percent(double ratio) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", 100 * ratio);
  return text;
}

/// A regular tetrahedron on four corners of the cube [-1, 1]^3.
TestObject make_tetrahedron() {
  TestObject object;
  object.name = "tetrahedron";
  object.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  object.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  object.volume = 8.0 / 3;
  return object;
}

TableRow ratios_row(const std::string& name, const std::array<double, 3>& ratios,
                    const std::string& paper) {
  return {name, percent(ratios[0]), percent(ratios[1]), percent(ratios[2]), paper};
}

/// The cases of section III-A, which depend on no orientation.
std::string exact_cases(const std::vector<TestObject>& objects, const ExperimentOptions& options) {
  std::vector<TableRow> rows{{"", "3 views", "9", "13", "paper"}};
  rows.push_back(ratios_row("tetrahedron on the cube's corners",
                            ratios_as_they_stand(make_tetrahedron(), 128, 2, options),
                            "3 views 33.3"));
  const TestObject& sphere = objects[3];
  for (const int size : {128, 1024}) {
    rows.push_back(ratios_row("sphere that fills the cube, " + std::to_string(size) + " pixels",
                              ratios_as_they_stand(sphere, size, 2, options),
                              "3 views 88.9, 9 views 98.7"));
  }
  return align_columns(rows);
}

std::string variants_table(const std::vector<TestObject>& objects, const ExperimentOptions& asked) {
  struct Variant {
    const char* name;
    bool square_pixels;
    double corner_fraction;
    OrientationKind orientations;
    int size;
    double cube_side;
  };
  const int size = asked.size;
  constexpr auto kUniform = OrientationKind::Uniform;
  const std::array variants{
      Variant{"more than half of a hexagon, square pixels", true, 0.6, kUniform, size, 0},
      Variant{"at least half of a hexagon", true, 0.5, kUniform, size, 0},
      Variant{"at least a quarter of a hexagon", true, 0.25, kUniform, size, 0},
      Variant{"all of a hexagon", true, 1, kUniform, size, 0},
      Variant{"more than half, each picture stretched to a square", false, 0.6, kUniform, size, 0},
      Variant{"a quarter, each picture stretched", false, 0.25, kUniform, size, 0},
      Variant{"more than half; turned by three angles", true, 0.6, OrientationKind::Angles, size,
              0},
      Variant{"more than half; turned about an axis", true, 0.6, OrientationKind::AxisAngle, size,
              0},
      Variant{"more than half; four times as fine, little digitisation", true, 0.6, kUniform,
              4 * size, 0},
  };
  std::vector<TableRow> rows{
      {"undecided corner cells are black with", "3 views", "9", "13", "grown: 3", "9", "13"}};
  for (const Variant& variant : variants) {
    ExperimentOptions options = asked;
    options.square_pixels = variant.square_pixels;
    options.corner_fraction = variant.corner_fraction;
    options.orientation_kind = variant.orientations;
    options.size = variant.size;
    options.cube_side = variant.cube_side;
    if (variant.size > size) options.orientations = std::max(asked.orientations / 5, 1);
    const ExperimentRow row = average_of(run_experiment(objects, options));
    TableRow line{variant.name};
    for (const Accuracy& a : row.as_seen) line.push_back(percent(a.average));
    for (const Accuracy& a : row.grown) line.push_back(percent(a.average));
    rows.push_back(line);
  }
  rows.push_back({"the paper", "", "", "93.7", "", "", "76.5"});
  return align_columns(rows);
}

}  // namespace

void run_experiment_command(const ExperimentArguments& arguments) {
  const std::vector<TestObject> objects = make_test_objects();
  std::vector<ExperimentRow> rows = run_experiment(objects, arguments.options);
  const std::vector<ExperimentRow> alone = rows;
  const ExperimentRow average = average_of(rows);
  rows.push_back(average);

  std::string text = to_table(rows);
  text += "\nobjects of figure 11, 13 views: " + percent(average.as_seen[2].average) +
          " % (paper 93.7 %), grown " + percent(average.grown[2].average) + " % (paper 76.5 %)\n\n";
  text += exact_cases(objects, arguments.options);
  if (arguments.variants) text += "\n" + variants_table(objects, arguments.options);
  print(text);

  if (arguments.folder.empty()) return;
  const std::filesystem::path folder(arguments.folder);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw BadInput(arguments.folder + ": " + error.message());
  write_file_atomically(folder / "silhouettes.txt", text);
  write_file_atomically(folder / "silhouettes.csv", to_csv(rows));
  std::vector<StabilityEntry> primitives;
  std::vector<StabilityEntry> complex;
  for (const ExperimentRow& row : alone) {
    if (row.paper_volume > 0) {
      primitives.push_back({row.object, row.as_seen});
    } else {
      complex.push_back({row.object, row.as_seen});
      complex.push_back({"grown", row.grown});
    }
  }
  write_file_atomically(folder / "silhouettes-figure-12.svg", average_chart(alone));
  write_file_atomically(folder / "silhouettes-figure-13.svg", stability_chart(primitives));
  write_file_atomically(folder / "silhouettes-figure-15.svg", stability_chart(complex));
}

}  // namespace spoctree
