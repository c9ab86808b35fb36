// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdRelativeWindings.h"

#include <algorithm>

namespace skdtree
{
namespace
{
constexpr std::uint32_t None = 0xffffffffu;

/// A facet between two regions, as seen from one of them.
struct Link
{
  std::uint32_t From;
  std::uint32_t To;
  std::uint32_t Facet;

  bool operator<(const Link& o) const
  {
    return this->From != o.From ? this->From < o.From
                                : (this->To != o.To ? this->To < o.To : this->Facet < o.Facet);
  }
  bool ConnectsAs(const Link& o) const { return this->From == o.From && this->To == o.To; }
};

std::vector<Link> ListLinks(const SkdArrangement& arrangement)
{
  std::vector<Link> links;
  Link last{ None, None, None };
  for (std::uint32_t facet = 0; facet < arrangement.Facets.GetNumberOfFacets(); ++facet)
  {
    const Link link{ arrangement.GetFront(facet), arrangement.GetBack(facet), facet };
    if (!link.ConnectsAs(last))
    {
      links.push_back(link);
      links.push_back({ link.To, link.From, facet });
      last = link;
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end(),
                [](const Link& a, const Link& b) { return a.ConnectsAs(b); }),
    links.end());
  return links;
}

/// The numbers behind a facet are higher by 1 for each of its layers.
SkdRegionWindings Across(const SkdArrangement& arrangement,
  const std::vector<std::uint32_t>& surfaceOf, const Link& link, SkdRegionWindings windings)
{
  const int step = link.From == arrangement.GetFront(link.Facet) ? 1 : -1;
  arrangement.Facets.ForEachLayer(link.Facet,
    [&](std::uint32_t parent, int sign) {
      SkdAddWinding(windings, { surfaceOf[parent], step * sign });
    });
  return windings;
}
}

void SkdAddWinding(SkdRegionWindings& to, const SkdWindingOf& winding)
{
  const auto at = std::lower_bound(to.begin(), to.end(), winding);
  if (at == to.end() || at->Surface != winding.Surface)
  {
    to.insert(at, winding);
    return;
  }
  at->Number += winding.Number;
  if (at->Number == 0)
  {
    to.erase(at);
  }
}

SkdRelativeWindings::SkdRelativeWindings(
  const SkdArrangement& arrangement, const std::vector<std::uint32_t>& surfaceOf)
  : OfRegions(arrangement.NumberOfRegions)
  , ComponentOf(arrangement.NumberOfRegions, None)
{
  const std::vector<Link> links = ListLinks(arrangement);
  std::vector<std::uint32_t> open;
  for (std::uint32_t start = 0; start < this->OfRegions.size(); ++start)
  {
    if (this->ComponentOf[start] != None)
    {
      continue;
    }
    this->ComponentOf[start] = this->NumberOfComponents++;
    open.push_back(start);
    while (!open.empty())
    {
      const std::uint32_t region = open.back();
      open.pop_back();
      auto link = std::lower_bound(links.begin(), links.end(), Link{ region, 0, 0 });
      for (; link != links.end() && link->From == region; ++link)
      {
        if (this->ComponentOf[link->To] == None)
        {
          this->ComponentOf[link->To] = this->ComponentOf[region];
          this->OfRegions[link->To] =
            Across(arrangement, surfaceOf, *link, this->OfRegions[region]);
          open.push_back(link->To);
        }
      }
    }
  }
}
}
