#include <random>

#include "mesher/errors.h"
#include "mesher/triangulation/delaunay.h"
#include "tools/thesis/counted_walks.h"
#include "tools/thesis/experiment.h"

namespace parmesan::thesis {
namespace {

struct WalkTotals {
  WalkCounts guibas;
  WalkCounts bossen;
};

void add(WalkCounts& sum, const WalkCounts& c) {
  sum.right_of += c.right_of;
  sum.equal += c.equal;
  sum.onext += c.onext;
  sum.dprev += c.dprev;
  sum.org += c.org;
  sum.dest += c.dest;
  sum.sym += c.sym;
}

// Random sites of a square are inserted one by one into a triangle around it; each is located from an edge at the site
// before, by both walks. That one start in two needs Sym tells that the thesis started from such a place.
WalkTotals totals_of_insertions(int n, unsigned seed) {
  std::mt19937 engine(seed);
  const auto draw = [&engine] { return static_cast<double>(engine()) / 4294967296.0; };
  const std::vector<Point> corners{{-2, -2}, {4, -2}, {-2, 4}};
  Triangulation t = delaunay(corners).triangulation;
  WalkTotals totals;
  VertexId last = 0;
  for (int i = 0; i < n; ++i) {
    const Point p{draw(), draw()};
    const CountedWalk guibas = walk_of_guibas_stolfi(t, p, t.edge_of(last));
    const CountedWalk bossen = walk_of_bossen(t, p, t.edge_of(last));
    add(totals.guibas, guibas.counts);
    add(totals.bossen, bossen.counts);
    last = insert_site(t, p, bossen.edge);
    if (insert_site(t, p, guibas.edge) != last) throw MeshingError("the two walks end in different places");
  }
  return totals;
}

}  // namespace

Item table_2_1(const Setting& setting) {
  Item item("table_2_1", "Table 2.1: calls per location of a site, Guibas and Stolfi's walk and Bossen's");
  const std::vector<std::vector<double>> printed{
      {207.8, 90.7, 2.29, 657, 277, 2.37},  {167.7, 78.1, 2.15, 531, 243, 2.18},  {126.1, 44.1, 2.86, 403, 137, 2.94},
      {80.1, 43.6, 1.84, 251, 137, 1.83},   {83.9, 39.1, 2.15, 265, 122, 2.17},   {83.9, 39.1, 2.15, 265, 122, 2.17},
      {0.52, 0.62, 0.84, 0.40, 0.62, 0.65}, {374.5, 166.5, 2.25, 1183, 519, 2.27}};
  const std::vector<std::string> names{"RightOf", "Point =", "Onext", "Dprev", "Org", "Dest", "Sym", "Total"};
  const std::vector<int> sizes = setting.quick ? std::vector<int>{1000, 10000} : std::vector<int>{10000, 100000};
  std::vector<std::vector<Json>> rows(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) rows[k].push_back(names[k]);
  for (std::size_t s = 0; s < sizes.size(); ++s) {
    const WalkTotals totals = totals_of_insertions(sizes[s], 1);
    const auto row = [](const WalkCounts& c) {
      return std::vector<std::int64_t>{c.right_of, c.equal, c.onext, c.dprev, c.org, c.dest, c.sym, c.topological()};
    };
    const auto guibas = row(totals.guibas);
    const auto bossen = row(totals.bossen);
    for (std::size_t k = 0; k < names.size(); ++k) {
      rows[k].push_back(static_cast<double>(guibas[k]) / sizes[s]);
      rows[k].push_back(static_cast<double>(bossen[k]) / sizes[s]);
      rows[k].push_back(static_cast<double>(guibas[k]) / static_cast<double>(bossen[k]));
      for (std::size_t c = 0; c < 3; ++c)
        rows[k].push_back(sizes[s] >= 10000 ? Json(printed[k][(sizes[s] == 100000 ? 3 : 0) + c]) : Json());
    }
    const double ratio =
        static_cast<double>(totals.guibas.topological()) / static_cast<double>(totals.bossen.topological());
    const Json of_thesis = sizes[s] == 10000 ? Json(2.25) : (sizes[s] == 100000 ? Json(2.27) : Json());
    item.add("ratio of all topological calls, " + std::to_string(sizes[s]) + " sites", of_thesis, ratio,
             "random sites differ; the edge that walks start from is not given there", {.min = 2.0});
  }
  std::vector<std::string> columns{"procedure"};
  for (const int n : sizes)
    for (const char* which : {"Guibas", "Bossen", "ratio", "Guibas, thesis", "Bossen, thesis", "ratio, thesis"})
      columns.push_back(std::string(which) + " (" + std::to_string(n) + ")");
  item.add_table("Calls per location", columns, rows);
  item.add_note(
      "Sites are uniform in a square and inserted one by one into a triangle around it; every location starts "
      "at the site inserted before.");
  return item;
}

}  // namespace parmesan::thesis
