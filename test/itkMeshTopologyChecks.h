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
#ifndef itkMeshTopologyChecks_h
#define itkMeshTopologyChecks_h

#include "itkMeshChecks.h"

#include <map>

namespace itk::DelaunayRefinementTest
{
/** \class DisjointSets
 * \brief Union-find, for counting components.
 */
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size)
    : m_NumberOfSets(size)
  {
    m_Parents.reserve(size);
    for (std::size_t element = 0; element < size; ++element)
    {
      m_Parents.push_back(element);
    }
  }

  std::size_t
  Find(std::size_t element)
  {
    while (m_Parents[element] != element)
    {
      m_Parents[element] = m_Parents[m_Parents[element]];
      element = m_Parents[element];
    }
    return element;
  }

  void
  Join(std::size_t a, std::size_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    if (a != b)
    {
      m_Parents[a] = b;
      --m_NumberOfSets;
    }
  }

  std::size_t
  GetNumberOfSets() const
  {
    return m_NumberOfSets;
  }

private:
  std::vector<std::size_t> m_Parents{};
  std::size_t              m_NumberOfSets;
};

/** \name Topology
 */
///@{
using EdgeTrianglesMap = std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>>;

/** The triangles around each edge of the triangles. */
inline EdgeTrianglesMap
ComputeEdgeTriangles(const CheckedMesh & mesh)
{
  EdgeTrianglesMap edges;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      edges[MakeSorted<2>({ mesh.triangles[i][j], mesh.triangles[i][(j + 1) % 3] })].push_back(i);
    }
  }
  return edges;
}

/** Edges of the triangles without exactly two triangles. */
inline std::size_t
CountNonManifoldEdges(const CheckedMesh & mesh)
{
  const EdgeTrianglesMap edges = ComputeEdgeTriangles(mesh);
  return std::count_if(edges.begin(), edges.end(), [](const auto & edge) { return edge.second.size() != 2; });
}

/** Vertices whose triangles make more than one fan. */
inline std::size_t
CountNonManifoldVertices(const CheckedMesh & mesh)
{
  // Corner 3 i + j is vertex j of triangle i; corners of one vertex in triangles that share an edge there are joined.
  const auto cornerOf = [&mesh](std::size_t triangle, std::uint32_t vertex) {
    const auto & vertices = mesh.triangles[triangle];
    return 3 * triangle + (std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin());
  };
  DisjointSets corners(3 * mesh.triangles.size());
  for (const auto & [edge, triangles] : ComputeEdgeTriangles(mesh))
  {
    for (const std::size_t triangle : triangles)
    {
      for (const std::uint32_t vertex : edge)
      {
        corners.Join(cornerOf(triangles.front(), vertex), cornerOf(triangle, vertex));
      }
    }
  }
  std::map<std::uint32_t, std::set<std::size_t>> fans;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (const std::uint32_t vertex : mesh.triangles[i])
    {
      fans[vertex].insert(corners.Find(cornerOf(i, vertex)));
    }
  }
  return std::count_if(fans.begin(), fans.end(), [](const auto & fan) { return fan.second.size() != 1; });
}

/** Vertices - edges + triangles of the boundary: 2 for each sphere, 0 for a torus. */
inline int
ComputeBoundaryEulerCharacteristic(const CheckedMesh & mesh)
{
  std::set<std::uint32_t> vertices;
  for (const auto & triangle : mesh.triangles)
  {
    vertices.insert(triangle.begin(), triangle.end());
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(ComputeEdgeTriangles(mesh).size()) +
         static_cast<int>(mesh.triangles.size());
}

/** Components of tetrahedra joined by faces. */
inline std::size_t
CountVolumeComponents(const CheckedMesh & mesh)
{
  DisjointSets sets(mesh.tetrahedra.size());
  ForEachFace(ComputeFaces(mesh), [&sets](auto first, auto last) {
    for (auto face = first; face != last; ++face)
    {
      sets.Join(first->tetrahedron, face->tetrahedron);
    }
  });
  return sets.GetNumberOfSets();
}

/** Components of triangles joined by edges. */
inline std::size_t
CountBoundaryComponents(const CheckedMesh & mesh)
{
  DisjointSets sets(mesh.triangles.size());
  for (const auto & edge : ComputeEdgeTriangles(mesh))
  {
    for (const std::size_t triangle : edge.second)
    {
      sets.Join(edge.second.front(), triangle);
    }
  }
  return sets.GetNumberOfSets();
}
///@}
} // end namespace itk::DelaunayRefinementTest

#endif
