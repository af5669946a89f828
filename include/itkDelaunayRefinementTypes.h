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
#ifndef itkDelaunayRefinementTypes_h
#define itkDelaunayRefinementTypes_h

#include "itkDelaunayRefinementEnums.h"
#include "itkDelaunayRefinementMemory.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace itk
{
/** A point of physical space, in the image's units (mm). */
using DelaunayRefinementPoint = std::array<double, 3>;

/** A number of a region of space: 0 is outside, the regions of the object are numbered from 1. */
using DelaunayRefinementRegion = std::uint32_t;

/** \class DelaunayRefinementParameters
 * \brief What the refinement engine is told. Lengths are in physical units (mm).
 *
 * \ingroup DelaunayRefinement
 */
struct DelaunayRefinementParameters
{
  /** Sampling density of the surface (the paper's delta). Positive. */
  double delta{ 1.0 };

  /** Lower deltas for some components of the object, by the oracle's component number; empty or shorter than the
   * number of components: \c delta holds for the rest. */
  std::vector<double> componentDelta{};

  /** Components that may be missing in the mesh, by the oracle's component number: delta is not lowered for their sake.
   * Empty or shorter than the number of components: the rest may not. */
  std::vector<bool> isDispensable{};

  /** Upper bound on the radius-edge ratio of tetrahedra (the paper's rho bar). At least 1. */
  double radiusEdgeRatioBound{ 2.0 };

  /** Upper bound on the circumradius of tetrahedra inside. Infinite: no bound. */
  double cellSize{ std::numeric_limits<double>::infinity() };

  /** Vertices are inserted and moved until no tetrahedron has a smaller dihedral angle, in degrees; tetrahedra on the
   * boundary may also be left to outside. Below 60. 0: nothing is done about angles. */
  double minimumDihedralAngle{ 0.0 };

  /** Whether rule R4' of the paper (section VI-B) is applied to tetrahedra with smaller dihedral angles instead: it
   * splits them while new edges are at least a quarter of delta long, and keeps no angle for sure. */
  bool paperSlivers{ false };

  /** Whether R2, with E1 to E3, is applied to all intersecting tetrahedra, as in the paper, not only to those with a
   * feature vertex and their circumcenter inside. No guarantee needs it (docs/guarantees.md, section 4), and it takes
   * about as long as all the rest. */
  bool refineOutside{ false };

  /** Whether the boundary of each region is to be a 2-manifold: a few tetrahedra are given to another region than that
   * of their circumcenter, and vertices put where that does not help. */
  bool manifold{ true };

  /** Upper bound on both directions of the distance between the boundary and the surface: delta is lowered where it is
   * not kept. Infinite: no bound, and no distance is measured. */
  double hausdorffBound{ std::numeric_limits<double>::infinity() };

  /** Delta is lowered until the boundary has the topology of the object, no further than to this (mm) where topology
   * itself tells where, and to an eighth of it where a distance has to. Infinite: not for the sake of topology, which
   * is not counted. Only for one region, and with \c manifold. */
  double topologySize{ std::numeric_limits<double>::infinity() };

  /** Delta is lowered, but no further than this (mm), where boundary and surface are farther from each other than \c
   * deviationShare of the delta there, and than \c leastDeviation (mm): where the surface is bent or parts are thin.
   * Infinite: delta is not lowered for that. */
  /** @ITKStartGrouping */
  double leastDelta{ std::numeric_limits<double>::infinity() };
  double deviationShare{ 0.1 };
  double leastDeviation{ 0.0 };
  /** @ITKEndGrouping */

  /** An upper bound on delta (mm), positive: the least one in the axis-aligned cube around a point whose edges are
   * twice
   * \c reach (mm) long. Asked for cubes with edges of about \c sizeFieldStep (mm), on one thread. Empty: none. */
  /** @ITKStartGrouping */
  std::function<double(const DelaunayRefinementPoint & point, double reach)> sizeField{};
  double                                                                     sizeFieldStep{ 1.0 };
  /** @ITKEndGrouping */

  /** The refinement stops with VERTEX_LIMIT before the triangulation has more vertices. */
  std::uint64_t maximumNumberOfVertices{ std::numeric_limits<std::uint64_t>::max() };

  /** Every point is rounded to single precision before it is inserted. */
  bool roundToFloat{ false };

  /** Threads to use. The mesh does not depend on their number. At least 1. */
  unsigned int numberOfThreads{ 1 };

  /** Called now and then on the calling thread with a growing share of the work done, in [0, 1]; the refinement stops
   * with STOPPED_BY_CALLER when it returns false. */
  std::function<bool(double)> progress{};
};

/** \class DelaunayRefinementDistance
 * \brief How far one of two surfaces lies from the other at most, and where.
 *
 * \ingroup DelaunayRefinement
 */
struct DelaunayRefinementDistance
{
  /** In physical units (mm); negative if it was not measured. */
  double distance{ -1.0 };

  /** A point of the one surface that is as far from the other. */
  DelaunayRefinementPoint place{};
};

/** \class DelaunayRefinementTopology
 * \brief Counts that tell the topology of a solid object whose surface is a 2-manifold.
 *
 * \ingroup DelaunayRefinement
 */
struct DelaunayRefinementTopology
{
  /** Whether it was counted. */
  bool isKnown{ false };

  /** Parts that hang together. */
  std::int64_t components{ 0 };

  /** Parts of space outside that the object encloses. */
  std::int64_t cavities{ 0 };

  /** Of the surface: 2 for each closed piece of it, less 2 for each of its handles. */
  std::int64_t eulerCharacteristic{ 0 };

  /** Handles of all pieces of the surface together. */
  std::int64_t
  GetGenus() const
  {
    return components + cavities - eulerCharacteristic / 2;
  }

  /** Whether all counts agree, or neither is known. */
  bool
  operator==(const DelaunayRefinementTopology & other) const
  {
    return isKnown == other.isKnown && components == other.components && cavities == other.cavities &&
           eulerCharacteristic == other.eulerCharacteristic;
  }
};

/** Components, cavities and genus. */
extern DelaunayRefinement_EXPORT std::ostream &
                                 operator<<(std::ostream & out, const DelaunayRefinementTopology & topology);

/** \class DelaunayRefinementSliver
 * \brief A tetrahedron with a small dihedral angle.
 *
 * \ingroup DelaunayRefinement
 */
struct DelaunayRefinementSliver
{
  /** The smallest of its six, in degrees. */
  double dihedralAngle{ 0.0 };

  /** Its centroid. */
  DelaunayRefinementPoint place{};
};

/** \class DelaunayRefinementStatistics
 * \brief What the last run did, counted and timed.
 *
 * \ingroup DelaunayRefinement
 */
struct DelaunayRefinementStatistics
{
  /** Vertices inserted by each rule, indexed by DelaunayRefinementEnums::RefinementRule. */
  std::array<std::size_t, DelaunayRefinementEnums::NumberOfRefinementRules> insertions{};

  /** Those of R2's vertices that were inserted with the first ones, where it would have asked for many. */
  std::size_t seeds{ 0 };

  /** Circumcenters of R2 replaced by each case, indexed by DelaunayRefinementEnums::EncroachmentCase (NONE is unused).
   */
  std::array<std::size_t, DelaunayRefinementEnums::NumberOfEncroachmentCases> encroachments{};

  /** Vertices removed around new feature vertices. */
  std::size_t removals{ 0 };

  /** Vertices removed by the encroachment cases. */
  std::size_t encroachmentRemovals{ 0 };

  /** Vertices of the final triangulation, those outside the mesh included, by DelaunayRefinementEnums::VertexKind. */
  std::array<std::size_t, 4> vertices{};

  /** Seconds of wall time of a phase: surface sampling, bulk insertion, refinement, extraction. */
  /** @ITKStartGrouping */
  double samplingSeconds{ 0.0 };
  double insertionSeconds{ 0.0 };
  double refinementSeconds{ 0.0 };
  double extractionSeconds{ 0.0 };
  /** @ITKEndGrouping */

  /** Components of the object, by the oracle's number, in which no tetrahedron has its circumcenter. */
  std::vector<std::uint32_t> missingComponents{};

  /** Cavities of the object, by the oracle's number, in which no tetrahedron outside has its circumcenter. */
  std::vector<std::uint32_t> missingCavities{};

  /** Vertices moved because of small dihedral angles, each time counted. */
  std::size_t movedVertices{ 0 };

  /** Seconds of wall time of insertions and moves because of small dihedral angles; part of the refinement's. */
  double sliverSeconds{ 0.0 };

  /** The tetrahedra left with a smaller dihedral angle than was asked for, by angle. */
  std::vector<DelaunayRefinementSliver> slivers{};

  /** Tetrahedra given to another region than that of their circumcenter, for the boundary's sake, or left to outside as
   * slivers. */
  std::size_t changedTetrahedra{ 0 };

  /** Vertices at which the boundary of a region is not a 2-manifold, as far as that was asked for. */
  std::size_t nonManifoldVertices{ 0 };

  /** From the mesh's boundary, interfaces included, to the surface; measured if there is a bound, and then certified:
   * no point is farther by more than a tenth of the bound. */
  DelaunayRefinementDistance meshToSurface{};

  /** From the surface to the mesh's boundary; the same. */
  DelaunayRefinementDistance surfaceToMesh{};

  /** Topology of the object in the image, and of the mesh; counted if delta may be lowered for its sake. */
  /** @ITKStartGrouping */
  DelaunayRefinementTopology imageTopology{};
  DelaunayRefinementTopology meshTopology{};
  /** @ITKEndGrouping */

  /** For each component for which delta was lowered: its number and the delta that was used. */
  std::vector<std::pair<std::uint32_t, double>> loweredDeltas{};

  /** Why the run ended. */
  DelaunayRefinementEnums::TerminationReason terminationReason{
    DelaunayRefinementEnums::TerminationReason::NO_SURFACE_FOUND
  };
};

/** All of them on one line. */
extern DelaunayRefinement_EXPORT std::ostream &
                                 operator<<(std::ostream & out, const DelaunayRefinementStatistics & statistics);

/** \class DelaunayRefinementResult
 * \brief The tetrahedra whose circumcenters are inside the object (paper, section III), and their boundary.
 *
 * \ingroup DelaunayRefinement
 */
struct DelaunayRefinementResult
{
  /** Points used by at least one tetrahedron. */
  DelaunayRefinementArray<DelaunayRefinementPoint> points{};

  /** FEATURE or FREE, for each point. */
  DelaunayRefinementArray<DelaunayRefinementEnums::VertexKind> pointKinds{};

  /** Positively oriented: det(p1 - p0, p2 - p0, p3 - p0) > 0, which is VTK's and ITK's order. */
  DelaunayRefinementArray<std::array<std::uint32_t, 4>> tetrahedra{};

  /** The oracle's region of each tetrahedron's circumcenter, never 0. */
  DelaunayRefinementArray<std::uint32_t> regions{};

  /** Faces between two regions, or between one and outside, counterclockwise as seen from the one with the smaller
   * number; outside is 0. */
  DelaunayRefinementArray<std::array<std::uint32_t, 3>> boundaryTriangles{};

  /** The regions that each of them parts: the larger number, and the smaller one. */
  DelaunayRefinementArray<std::array<std::uint32_t, 2>> boundaryRegions{};
};
} // end namespace itk

#endif
