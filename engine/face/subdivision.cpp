#include "engine/face/subdivision.h"

#include <memory>

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

namespace sinew {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

/// A row under construction, in the form in which OpenSubdiv interpolates values.
class Row {
 public:
  Row() = default;
  explicit Row(std::uint32_t column) : entries_{{column, 1.0}} {}

  void Clear() { entries_.clear(); }
  void AddWithWeight(const Row& other, double weight) {
    if (weight == 0.0) return;
    std::vector<SparseRows::Entry> sum;
    sum.reserve(entries_.size() + other.entries_.size());
    auto a = entries_.begin();
    for (const SparseRows::Entry& b : other.entries_) {
      while (a != entries_.end() && a->column < b.column) sum.push_back(*a++);
      const bool same = a != entries_.end() && a->column == b.column;
      sum.push_back({b.column, weight * b.weight + (same ? a->weight : 0.0)});
      if (same) ++a;
    }
    sum.insert(sum.end(), a, entries_.end());
    entries_ = std::move(sum);
  }
  const std::vector<SparseRows::Entry>& entries() const { return entries_; }

 private:
  std::vector<SparseRows::Entry> entries_;
};

std::unique_ptr<Far::TopologyRefiner> refiner_of(std::size_t vertices, std::span<const Quad> quads) {
  const std::vector<int> corners(quads.size(), 4);
  std::vector<int> indices;
  for (const Quad& quad : quads) indices.insert(indices.end(), quad.begin(), quad.end());
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(vertices);
  descriptor.numFaces = static_cast<int>(quads.size());
  descriptor.numVertsPerFace = corners.data();
  descriptor.vertIndicesPerFace = indices.data();
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  return std::unique_ptr<Far::TopologyRefiner>(
      Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_CATMARK, options)));
}

}  // namespace

Subdivision subdivide(std::size_t vertices, std::span<const Quad> quads, int level) {
  const auto refiner = refiner_of(vertices, quads);
  Far::TopologyRefiner::UniformOptions uniform(level);
  uniform.fullTopologyInLastLevel = true;
  if (level > 0) refiner->RefineUniform(uniform);

  std::vector<Row> rows;
  for (std::uint32_t v = 0; v < vertices; ++v) rows.emplace_back(v);
  const Far::PrimvarRefinerReal<double> interpolate(*refiner);
  for (int l = 1; l <= level; ++l) {
    std::vector<Row> finer(static_cast<std::size_t>(refiner->GetLevel(l).GetNumVertices()));
    interpolate.Interpolate(l, rows, finer);
    rows = std::move(finer);
  }
  std::vector<Row> limit(rows.size());
  interpolate.Limit(rows, limit);

  Subdivision out;
  for (const Row& row : limit) {
    out.limit.entries.insert(out.limit.entries.end(), row.entries().begin(), row.entries().end());
    out.limit.first.push_back(static_cast<std::uint32_t>(out.limit.entries.size()));
  }
  const Far::TopologyLevel& last = refiner->GetLevel(level);
  for (int f = 0; f < last.GetNumFaces(); ++f) {
    const Far::ConstIndexArray corners = last.GetFaceVertices(f);
    out.quads.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
                         static_cast<std::uint32_t>(corners[2]), static_cast<std::uint32_t>(corners[3])});
    int coarse = f;
    for (int l = level; l > 0; --l) coarse = refiner->GetLevel(l).GetFaceParentFace(coarse);
    out.from.push_back(static_cast<std::uint32_t>(coarse));
  }
  return out;
}

}  // namespace sinew
