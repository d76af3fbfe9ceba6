#include "tools/benchmark/occt_benchmark.hpp"

#include <benchmark/benchmark.h>

#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_HLRToShape.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <HLRBRep_PolyHLRToShape.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <gp_Ax2.hxx>

#include "client/lines/camera.hpp"
#include "tools/benchmark/occt_shape.hpp"

namespace spoctree {

namespace {

/// What `Camera` sees.
HLRAlgo_Projector general_view() {
  const Camera camera;
  const Vec3 towards = camera.toward_viewer();
  const Vec3 right = camera.right();
  return HLRAlgo_Projector(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(towards.x, towards.y, towards.z),
                                  gp_Dir(right.x, right.y, right.z)));
}

double count_edges(const TopoDS_Shape& shape) {
  double count = 0;
  if (shape.IsNull()) return count;
  for (TopExp_Explorer edge(shape, TopAbs_EDGE); edge.More(); edge.Next()) ++count;
  return count;
}

/// Visible edges: of all kinds, for none of the solid's edges is smooth.
template <class Drawing>
double count_visible(Drawing& drawing) {
  return count_edges(drawing.VCompound()) + count_edges(drawing.OutLineVCompound());
}

double draw_poly(benchmark::State& state, const TopoDS_Shape& shape) {
  triangulate(shape);
  HLRBRep_PolyHLRToShape drawing;
  for (auto _ : state) {
    const Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo;
    algorithm->Load(shape);
    algorithm->Projector(general_view());
    algorithm->Update();
    drawing.Update(algorithm);  // here each edge is compared with the triangles
  }
  return count_visible(drawing);
}

double draw_exact(benchmark::State& state, const TopoDS_Shape& shape) {
  Handle(HLRBRep_Algo) algorithm;
  for (auto _ : state) {
    algorithm = new HLRBRep_Algo;
    algorithm->Add(shape);
    algorithm->Projector(general_view());
    algorithm->Update();
    algorithm->Hide();
  }
  HLRBRep_HLRToShape drawing(algorithm);
  return count_visible(drawing);
}

void run(benchmark::State& state, BenchmarkModel& model, double most_faces,
         double (*draw)(benchmark::State&, const TopoDS_Shape&)) {
  if (model.face_count() > most_faces) {
    state.SkipWithError("more faces than OpenCASCADE is asked to draw here");
    return;
  }
  try {
    state.counters["lines"] =
        draw(state, make_occt_solid(model.surface(), model.built().tree.plane_set()));
    state.counters["faces"] = model.face_count();
  } catch (const Standard_Failure& error) {
    state.SkipWithError(error.GetMessageString());
  } catch (const std::exception& error) {
    state.SkipWithError(error.what());
  }
}

}  // namespace

void register_occt_benchmarks(const std::shared_ptr<BenchmarkModel>& model, double most_faces) {
  const auto add = [&](const char* stage, auto draw) {
    benchmark::RegisterBenchmark(
        (stage + ("/" + model->name())).c_str(),
        [=](benchmark::State& state) { run(state, *model, most_faces, draw); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
  };
  add("draw-occt-poly", draw_poly);
  add("draw-occt-exact", draw_exact);
}

}  // namespace spoctree
