#include "client/rebuild/face_builder.hpp"

#include <algorithm>
#include <limits>

#include "client/rebuild/loop_tracer.hpp"
#include "client/rebuild/region_sides.hpp"
#include "common/base/parallel.hpp"

namespace spoctree {

namespace {

class FaceBuilder {
 public:
  FaceBuilder(const Carriers& carriers, std::span<const Vec3> positions, Surface& surface)
      : carriers_(carriers), positions_(positions), surface_(surface) {}

  /// The faces of one carrier.
  void build(std::span<const ChainEdge> chain, std::uint32_t carrier, std::uint8_t sides) {
    const CarrierSide front = 2 * carrier;
    const CarrierSide back = front + 1;
    collect(chain);
    if (sides == 2) {
      trace_and_add(back);
      return;
    }
    const PlaneFrame frame(carriers_.plane(carrier), false);
    tracer_.trace(edges_, frame, positions_, loops_);
    if (sides == 1 || turn_all(chain, true)) {
      add_faces(front, frame);
      return;
    }
    if (turn_all(chain, false)) {
      trace_and_add(back);
      return;
    }
    collect_counted(chain);
    std::vector<PlaneEdge> back_edges;
    separate_sides(counted_, frame, positions_, edges_, back_edges);
    trace_and_add(front);
    edges_.swap(back_edges);
    trace_and_add(back);
  }

 private:
  void collect(std::span<const ChainEdge> chain) {
    edges_.clear();
    for (const ChainEdge& use : chain) {
      for (std::int32_t i = 0; i < std::abs(use.count); ++i) {
        edges_.push_back(use.count > 0 ? PlaneEdge{use.a, use.b} : PlaneEdge{use.b, use.a});
      }
    }
  }

  void collect_counted(std::span<const ChainEdge> chain) {
    counted_.clear();
    for (const ChainEdge& use : chain) {
      counted_.push_back(
          {use.count > 0 ? PlaneEdge{use.a, use.b} : PlaneEdge{use.b, use.a}, std::abs(use.count)});
    }
  }

  /// Separate loops of one direction only: a hole has a loop of the other direction around it, so
  /// these are faces that look all the same way.
  bool turn_all(std::span<const ChainEdge> chain, bool counter_clockwise) const {
    const auto is_single = [](const ChainEdge& use) { return std::abs(use.count) == 1; };
    const auto turns = [&](const TracedLoops::Loop& loop) {
      return counter_clockwise ? loop.area > 0 : loop.area < 0;
    };
    return !loops_.branches && std::all_of(chain.begin(), chain.end(), is_single) &&
           std::all_of(loops_.loops.begin(), loops_.loops.end(), turns);
  }

  void trace_and_add(CarrierSide side) {
    const PlaneFrame frame(carriers_.plane(side >> 1), (side & 1) != 0);
    tracer_.trace(edges_, frame, positions_, loops_);
    add_faces(side, frame);
  }

  void add_faces(CarrierSide side, const PlaneFrame& frame) {
    const auto& loops = loops_.loops;
    holes_of_.assign(loops.size(), {});
    outer_.assign(loops.size(), true);
    for (std::uint32_t i = 0; i < loops.size(); ++i) {
      if (loops[i].area > 0) continue;
      const std::uint32_t around = find_outer(i, frame);
      if (around == loops.size()) continue;  // none (rounding): a face of its own, still closed
      outer_[i] = false;
      holes_of_[around].push_back(i);
    }
    for (std::uint32_t i = 0; i < loops.size(); ++i) {
      if (!outer_[i]) continue;
      surface_.faces.push_back({carriers_.name(side),
                                static_cast<std::uint32_t>(surface_.loops.size()),
                                static_cast<std::uint32_t>(1 + holes_of_[i].size())});
      add_loop(loops[i]);
      for (const std::uint32_t hole : holes_of_[i]) add_loop(loops[hole]);
    }
  }

  void add_loop(const TracedLoops::Loop& loop) {
    surface_.loops.push_back(
        {static_cast<std::uint32_t>(surface_.loop_vertices.size()), loop.count});
    const auto vertices = loops_.vertices_of(loop);
    surface_.loop_vertices.insert(surface_.loop_vertices.end(), vertices.begin(), vertices.end());
  }

  /// The smallest counter-clockwise loop around a clockwise one.
  std::uint32_t find_outer(std::uint32_t hole, const PlaneFrame& frame) const {
    const auto& loops = loops_.loops;
    // A hole may touch the loop around it in vertices, so ask for the middle of an edge.
    const auto vertices = loops_.vertices_of(loops[hole]);
    const Vec2 point =
        0.5 * (frame.project(positions_[vertices[0]]) + frame.project(positions_[vertices[1]]));
    auto best = static_cast<std::uint32_t>(loops.size());
    double best_area = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < loops.size(); ++i) {
      if (loops[i].area > -loops[hole].area && loops[i].area < best_area &&
          contains(loops[i], point, frame)) {
        best = i;
        best_area = loops[i].area;
      }
    }
    return best;
  }

  bool contains(const TracedLoops::Loop& loop, Vec2 p, const PlaneFrame& frame) const {
    const auto vertices = loops_.vertices_of(loop);
    bool inside = false;
    Vec2 a = frame.project(positions_[vertices.back()]);
    for (const std::uint32_t vertex : vertices) {
      const Vec2 b = frame.project(positions_[vertex]);
      if ((a.y <= p.y) != (b.y <= p.y) && (cross(b - a, p - a) > 0) == (b.y > a.y)) {
        inside = !inside;
      }
      a = b;
    }
    return inside;
  }

  const Carriers& carriers_;
  std::span<const Vec3> positions_;
  Surface& surface_;
  LoopTracer tracer_;
  TracedLoops loops_;
  std::vector<PlaneEdge> edges_;
  std::vector<CountedEdge> counted_;
  std::vector<bool> outer_;
  std::vector<std::vector<std::uint32_t>> holes_of_;
};

void append(const Surface& part, Surface& surface) {
  const auto first_vertex = static_cast<std::uint32_t>(surface.loop_vertices.size());
  const auto first_loop = static_cast<std::uint32_t>(surface.loops.size());
  surface.loop_vertices.insert(surface.loop_vertices.end(), part.loop_vertices.begin(),
                               part.loop_vertices.end());
  for (const Surface::Loop& loop : part.loops) {
    surface.loops.push_back({first_vertex + loop.first, loop.count});
  }
  for (const Surface::Face& face : part.faces) {
    surface.faces.push_back({face.plane, first_loop + face.first_loop, face.loop_count});
  }
}

}  // namespace

void build_faces(const Chain& chain, const Carriers& carriers, std::span<const std::uint8_t> sides,
                 std::span<const Vec3> positions, Surface& surface) {
  // The chain again, carrier by carrier.
  std::vector<std::uint32_t> begin(carriers.count() + 1);
  for (const ChainEdge& use : chain) ++begin[use.carrier + 1];
  for (std::uint32_t carrier = 0; carrier < carriers.count(); ++carrier) {
    begin[carrier + 1] += begin[carrier];
  }
  std::vector<ChainEdge> sorted(chain.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (const ChainEdge& use : chain) sorted[next[use.carrier]++] = use;
  // Parts of about the same length, on their own, one behind the other.
  constexpr std::size_t kEdgesPerTask = 8192;
  std::vector<std::uint32_t> starts{0};
  for (std::uint32_t carrier = 0; carrier < carriers.count(); ++carrier) {
    if (begin[carrier + 1] - begin[starts.back()] >= kEdgesPerTask) starts.push_back(carrier + 1);
  }
  starts.push_back(carriers.count());
  std::vector<Surface> parts(starts.size() - 1);
  parallel_for(parts.size(), [&](std::size_t i) {
    FaceBuilder builder(carriers, positions, parts[i]);
    for (std::uint32_t carrier = starts[i]; carrier < starts[i + 1]; ++carrier) {
      if (begin[carrier] == begin[carrier + 1]) continue;
      builder.build({sorted.data() + begin[carrier], begin[carrier + 1] - begin[carrier]}, carrier,
                    sides[carrier]);
    }
  });
  for (const Surface& part : parts) append(part, surface);
}

}  // namespace spoctree
