// spoctree-silhouettes: solids -> silhouettes -> octrees, and how good these are.

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "common/program/run_program.hpp"
#include "common/program/threads.hpp"
#include "tools/silhouettes/build_command.hpp"
#include "tools/silhouettes/experiment_command.hpp"
#include "tools/silhouettes/render_command.hpp"

namespace {

using namespace spoctree;

const std::map<std::string, MaskFormat> kFormats{
    {"pbm", MaskFormat::Pbm}, {"pgm", MaskFormat::Pgm}, {"png", MaskFormat::Png}};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Makes octrees from silhouettes in up to thirteen views of the universe cube.",
               "spoctree-silhouettes");
  app.require_subcommand(1);
  app.footer(
      "Views are face-x, face-y, face-z, edge-37, ..., corner-7, ...; face, edge, corner and all\n"
      "stand for many. Exit codes: 0 done, 2 wrong usage, 3 bad input.");

  RenderArguments render;
  CLI::App& render_command = *app.add_subcommand("render", "draw the silhouettes of a mesh");
  render_command.add_option("MESH", render.mesh, "OFF, OBJ, STL or PLY")->required();
  render_command.add_option("-o,--output", render.folder, "the folder for the masks")->required();
  render_command.add_option("--size", render.size, "pixels in each row and each column")
      ->check(CLI::Range(1, kMostMaskPixels))
      ->capture_default_str();
  render_command.add_option("--views", render.views, "a list of views")->capture_default_str();
  render_command.add_option("--cube", render.cube,
                            "X,Y,Z,SIDE: the cube that is seen; the mesh's universe cube, if not "
                            "given");
  render_command.add_option("--format", render.format, "pbm, pgm or png")
      ->transform(CLI::CheckedTransformer(kFormats))
      ->default_str("pgm");
  render_command.add_flag("--square-pixels", render.square_pixels,
                          "pixels as large as a face view's in all views: edge views are wider, "
                          "corner views larger; without it, they are stretched");
  ThreadsOption render_threads(render_command);
  render_command.callback([&] {
    render_threads.apply();
    run_render(render);
  });

  SilhouetteBuildArguments build;
  CLI::App& build_command = *app.add_subcommand("build", "make the octree of silhouettes");
  build_command
      .add_option("MASK", build.masks,
                  "PBM, PGM and PNG files called like their views (cup-face-x.png), and folders of "
                  "them; what is bright is the object (PBM: what is 1)")
      ->required();
  build_command.add_option("-o,--output", build.output, "the .spo file; - is standard output")
      ->required();
  build_command.add_option("--views", build.views,
                           "a list of views; all that there are, if not given");
  build_command.add_option("--order", build.order,
                           "in which order views are used, such as edge,face,corner");
  build_command.add_option("--cube", build.cube,
                           "X,Y,Z,SIDE: the cube that is seen; that of a cube.txt beside them, or "
                           "0,0,0,2");
  build_command
      .add_option("--max-depth", build.max_depth,
                  "the octree's depth; without it, cells are pixels of the face views")
      ->check(CLI::Range(0, kMostSilhouetteDepth));
  build_command.add_flag("--grow", build.grow, "grow every silhouette by one pixel");
  build_command
      .add_option("--black-fraction", build.black_fraction,
                  "the smallest cells are full if so much of their pixels is")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  build_command
      .add_option("--corner-fraction", build.corner_fraction,
                  "the same for corner views, whose cells are hexagons of triangles")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  build_command.add_flag("--stages", build.stages,
                         "also write FILE-3.spo and so on, after the views of each kind");
  ThreadsOption build_threads(build_command);
  build_command.callback([&] {
    build_threads.apply();
    run_silhouette_build(build);
  });

  ExperimentArguments experiment;
  CLI::App& experiment_command =
      *app.add_subcommand("experiment", "repeat the evaluation of Ahuja and Veenstra (1989)");
  experiment_command.add_option("-o,--output", experiment.folder,
                                "a folder for the tables and charts");
  experiment_command
      .add_option("--orientations", experiment.options.orientations, "of each object")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  experiment_command.add_option("--seed", experiment.options.seed, "of the orientations")
      ->capture_default_str();
  experiment_command
      .add_option("--size", experiment.options.size, "pixels in each row and column of face views")
      ->check(CLI::Range(16, 1024))
      ->capture_default_str();
  experiment_command
      .add_option("--corner-fraction", experiment.options.corner_fraction,
                  "as for build, where less is usual: no smallest cell is lost there")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  experiment_command.add_flag("--variants", experiment.variants,
                              "also what other readings of the paper would give");
  ThreadsOption experiment_threads(experiment_command);
  experiment_command.callback([&] {
    experiment_threads.apply();
    run_experiment_command(experiment);
  });

  return run_program(app, argc, argv);
}
