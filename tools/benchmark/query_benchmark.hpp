// Point and ray queries, ours and those of CGAL, which is what one would use instead.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "common/tree/query_index.hpp"
#include "tools/benchmark/benchmark_model.hpp"

namespace spoctree {

/// A mesh prepared by CGAL for queries, with exact predicates: Side_of_triangle_mesh, and
/// first_intersection of an AABB_tree of its triangles.
class CgalQueries {
 public:
  explicit CgalQueries(const Solid& solid);
  ~CgalQueries();
  CgalQueries(const CgalQueries&) = delete;
  CgalQueries& operator=(const CgalQueries&) = delete;

  PointClass classify(Vec3 point) const;
  bool hits(const Ray& ray) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

/// "query-index", "classify" and "ray", and the last two with "-cgal": 100,000 questions each. The
/// rows of CGAL say how many times as many per second ours are (`ours`), where ours ran before.
void register_query_benchmarks(const std::shared_ptr<BenchmarkModel>& model);

}  // namespace spoctree
