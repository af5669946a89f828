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
#ifndef itkMeshExpectations_h
#define itkMeshExpectations_h

#include "itkMeshChecks.h"
#include "itkMeshDistanceChecks.h"
#include "itkMeshTopologyChecks.h"

#include <gtest/gtest.h>

namespace itk::DelaunayRefinementTest
{
/** The boundary triangles' angles are above this, in degrees (paper, Theorem 2). */
constexpr double MinimumPlanarAngle = 30.0;

/** Tetrahedra are no flatter than this part of their longest edge cubed. */
constexpr double MinimumRelativeVolume = 1e-11;

/** The tetrahedra fill a part of space once, and the triangles are its boundary and the interfaces between labels. */
inline void
ExpectValidMesh(const CheckedMesh & mesh)
{
  ASSERT_EQ(CountBadIndices(mesh), 0u);
  ASSERT_EQ(CountNonFinitePoints(mesh), 0u);
  EXPECT_FALSE(mesh.tetrahedra.empty());
  EXPECT_EQ(CountDuplicatePoints(mesh), 0u);
  EXPECT_EQ(CountOrphanPoints(mesh), 0u);
  EXPECT_EQ(CountDuplicateTetrahedra(mesh), 0u);
  EXPECT_EQ(CountInvertedTetrahedra(mesh), 0u);
  EXPECT_GT(ComputeMinimumRelativeVolume(mesh), MinimumRelativeVolume);
  EXPECT_EQ(CountOversharedFaces(mesh), 0u);
  EXPECT_EQ(CountFoldedFaces(mesh), 0u);
  EXPECT_EQ(CountBoundaryMismatches(mesh), 0u);
  if (!mesh.triangleOtherLabels.empty())
  {
    ASSERT_EQ(mesh.tetrahedronLabels.size(), mesh.tetrahedra.size());
    ASSERT_EQ(mesh.triangleLabels.size(), mesh.triangles.size());
    ASSERT_EQ(mesh.triangleOtherLabels.size(), mesh.triangles.size());
    EXPECT_EQ(CountTriangleLabelMismatches(mesh), 0u);
  }
  EXPECT_EQ(CountDelaunayViolations(mesh), 0u);
}

/** The paper's Theorem 2. */
inline void
ExpectQuality(const CheckedMesh & mesh, double radiusEdgeRatioBound)
{
  ASSERT_EQ(CountBadIndices(mesh), 0u);
  EXPECT_LT(ComputeMaximumRadiusEdgeRatio(mesh), radiusEdgeRatioBound);
  EXPECT_GT(ComputePlanarAngles(mesh).minimum, MinimumPlanarAngle);
}

inline void
ExpectManifoldBoundary(const CheckedMesh & mesh)
{
  ASSERT_EQ(CountBadIndices(mesh), 0u);
  EXPECT_EQ(CountNonManifoldEdges(mesh), 0u);
  EXPECT_EQ(CountNonManifoldVertices(mesh), 0u);
}

/** \class ExpectedTopology
 * \brief What a shape's mesh must have; a sphere has one component, one sheet of boundary and characteristic 2.
 */
struct ExpectedTopology
{
  std::size_t volumeComponents;
  std::size_t boundaryComponents;
  int         boundaryEulerCharacteristic;
};

inline void
ExpectTopology(const CheckedMesh & mesh, const ExpectedTopology & topology)
{
  ASSERT_EQ(CountBadIndices(mesh), 0u);
  EXPECT_EQ(CountVolumeComponents(mesh), topology.volumeComponents);
  EXPECT_EQ(CountBoundaryComponents(mesh), topology.boundaryComponents);
  EXPECT_EQ(ComputeBoundaryEulerCharacteristic(mesh), topology.boundaryEulerCharacteristic);
}

/** Validity and quality: what holds for every object and every delta. */
inline void
ExpectGuarantees(const CheckedMesh & mesh, double radiusEdgeRatioBound = 2.0)
{
  ExpectValidMesh(mesh);
  ExpectQuality(mesh, radiusEdgeRatioBound);
}
} // end namespace itk::DelaunayRefinementTest

#endif
