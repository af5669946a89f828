/*=========================================================================
 *
 *  Copyright The DelaunayRefinement Contributors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0.txt
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#include "itkDelaunayRefinementLocalTopology.h"

#include <algorithm>

namespace itk
{
namespace
{
constexpr auto None = DelaunayRefinementTriangulation::None;
} // namespace

void
DelaunayRefinementLocalTopology::Normalize(FacetsType & facets)
{
  auto &     list = facets.m_Facets;
  const auto isLess = [](const auto & a, const auto & b) { return a.vertices < b.vertices; };
  const auto isSame = [](const auto & a, const auto & b) { return a.vertices == b.vertices; };
  std::sort(list.begin(), list.end(), isLess);
  list.erase(std::unique(list.begin(), list.end(), isSame), list.end());
}

bool
DelaunayRefinementLocalTopology::Describe(const FacetsType & facets, RegionType region, SurfaceType & surface)
{
  const auto & list = facets.m_Facets;
  const auto   isOfRegion = [&](std::uint32_t facet) {
    return list[facet].regions[0] == region || list[facet].regions[1] == region;
  };
  surface.edges.clear();
  surface.rim.clear();
  surface.parts.clear();
  surface.fans.clear();
  m_EdgesOfFacets.clear();
  m_Parts.assign(list.size(), { { None, None }, 0 });
  m_Fans.assign(3 * list.size(), { None, { None, None } });
  for (std::uint32_t i = 0; i < list.size(); ++i)
  {
    if (isOfRegion(i))
    {
      const auto & v = list[i].vertices;
      m_EdgesOfFacets.push_back({ { v[0], v[1] }, { 3 * i, 3 * i + 1 } });
      m_EdgesOfFacets.push_back({ { v[0], v[2] }, { 3 * i, 3 * i + 2 } });
      m_EdgesOfFacets.push_back({ { v[1], v[2] }, { 3 * i + 1, 3 * i + 2 } });
    }
  }
  std::sort(m_EdgesOfFacets.begin(), m_EdgesOfFacets.end(), [](const auto & a, const auto & b) {
    return a.edge != b.edge ? a.edge < b.edge : a.corners < b.corners;
  });

  // Facets that share an edge, and their corners at it.
  const auto isSame = [this](std::size_t i, std::size_t j) {
    return j < m_EdgesOfFacets.size() && m_EdgesOfFacets[i].edge == m_EdgesOfFacets[j].edge;
  };
  m_JoinedFacets.Start(list.size());
  m_JoinedCorners.Start(3 * list.size());
  for (std::size_t i = 0; i < m_EdgesOfFacets.size();)
  {
    const std::size_t number = isSame(i, i + 1) ? 2 : 1;
    if (isSame(i, i + 2))
    {
      return false;
    }
    surface.edges.push_back(m_EdgesOfFacets[i].edge);
    if (number == 2)
    {
      const auto & one = m_EdgesOfFacets[i].corners;
      const auto & other = m_EdgesOfFacets[i + 1].corners;
      m_JoinedFacets.Join(one[0] / 3, other[0] / 3);
      m_JoinedCorners.Join(one[0], other[0]);
      m_JoinedCorners.Join(one[1], other[1]);
    }
    i += number;
  }

  // Facets less edges plus fans: a vertex counts as often as it has fans.
  for (std::size_t i = 0; i < m_EdgesOfFacets.size();)
  {
    const auto &        own = m_EdgesOfFacets[i];
    const std::uint32_t part = m_JoinedFacets.Find(own.corners[0] / 3);
    const bool          isRim = !isSame(i, i + 1);
    --m_Parts[part].eulerCharacteristic;
    if (isRim)
    {
      m_Parts[part].name = std::min(m_Parts[part].name, own.edge);
      for (unsigned int end = 0; end < 2; ++end)
      {
        auto & ends = m_Fans[m_JoinedCorners.Find(own.corners[end])].ends;
        ends[ends[0] == None ? 0 : 1] = own.edge[1 - end];
      }
    }
    i += isRim ? 1 : 2;
  }
  for (std::uint32_t i = 0; i < list.size(); ++i)
  {
    if (!isOfRegion(i))
    {
      continue;
    }
    const std::uint32_t part = m_JoinedFacets.Find(i);
    ++m_Parts[part].eulerCharacteristic;
    for (std::uint32_t corner = 3 * i; corner < 3 * i + 3; ++corner)
    {
      const std::uint32_t fan = m_JoinedCorners.Find(corner);
      if (fan == corner)
      {
        ++m_Parts[part].eulerCharacteristic;
        m_Fans[fan].vertex = list[i].vertices[corner - 3 * i];
        std::sort(m_Fans[fan].ends.begin(), m_Fans[fan].ends.end());
        surface.fans.push_back(m_Fans[fan]);
      }
    }
  }
  for (std::uint32_t i = 0; i < list.size(); ++i)
  {
    if (m_JoinedFacets.Find(i) == i && isOfRegion(i))
    {
      surface.parts.push_back(m_Parts[i]);
    }
  }
  for (std::size_t i = 0; i < m_EdgesOfFacets.size(); ++i)
  {
    if (!isSame(i, i + 1) && (i == 0 || !isSame(i, i - 1)))
    {
      const auto & own = m_EdgesOfFacets[i];
      surface.rim.emplace_back(own.edge, m_Parts[m_JoinedFacets.Find(own.corners[0] / 3)].name);
    }
  }
  std::sort(surface.parts.begin(), surface.parts.end());
  std::sort(surface.fans.begin(), surface.fans.end());
  return true;
}

bool
DelaunayRefinementLocalTopology::TakeOut(IndexType vertex, std::vector<FanType> & fans)
{
  const auto isOwn = [vertex](const FanType & fan) { return fan.vertex == vertex; };
  const auto found = std::find_if(fans.begin(), fans.end(), isOwn);
  if (found == fans.end())
  {
    return true;
  }
  const bool isClosed = found->ends[0] == None;
  fans.erase(found);
  return isClosed && std::none_of(fans.begin(), fans.end(), isOwn);
}

bool
DelaunayRefinementLocalTopology::AreEqual(FacetsType & before, FacetsType & after, IndexType vertex, bool mayComeOrGo)
{
  Normalize(before);
  Normalize(after);
  m_VerticesToAsk.clear();
  m_Regions.clear();
  for (const FacetsType * facets : { &before, &after })
  {
    for (const auto & facet : facets->m_Facets)
    {
      m_Regions.insert(m_Regions.end(), facet.regions.begin(), facet.regions.end());
    }
  }
  std::sort(m_Regions.begin(), m_Regions.end());
  m_Regions.erase(std::unique(m_Regions.begin(), m_Regions.end()), m_Regions.end());
  for (const RegionType region : m_Regions)
  {
    if (!this->Describe(before, region, m_Before) || !this->Describe(after, region, m_After) ||
        (mayComeOrGo && !(TakeOut(vertex, m_Before.fans) && TakeOut(vertex, m_After.fans))) ||
        m_Before.parts != m_After.parts || m_Before.rim != m_After.rim || m_Before.fans != m_After.fans)
    {
      return false;
    }
    // An edge that was on no facet before may be on two beyond.
    for (const EdgeType & edge : m_After.edges)
    {
      if (edge[0] != vertex && edge[1] != vertex &&
          !std::binary_search(m_Before.edges.begin(), m_Before.edges.end(), edge))
      {
        m_VerticesToAsk.push_back(edge[0]);
      }
    }
  }
  std::sort(m_VerticesToAsk.begin(), m_VerticesToAsk.end());
  m_VerticesToAsk.erase(std::unique(m_VerticesToAsk.begin(), m_VerticesToAsk.end()), m_VerticesToAsk.end());
  return true;
}
} // end namespace itk
