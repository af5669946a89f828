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
#include "itkDelaunayRefinementEngine.h"

#include "itkDelaunayRefinementAccuracy.h"
#include "itkDelaunayRefinementAudit.h"
#include "itkDelaunayRefinementBlockQueue.h"
#include "itkDelaunayRefinementCircumcenters.h"
#include "itkDelaunayRefinementComplex.h"
#include "itkDelaunayRefinementEncroachment.h"
#include "itkDelaunayRefinementFlatTetrahedra.h"
#include "itkDelaunayRefinementExtraction.h"
#include "itkDelaunayRefinementInteriorSeeds.h"
#include "itkDelaunayRefinementJunctionSample.h"
#include "itkDelaunayRefinementLocalDelta.h"
#include "itkDelaunayRefinementManifoldRepair.h"
#include "itkDelaunayRefinementMissingComponents.h"
#include "itkDelaunayRefinementQueue.h"
#include "itkDelaunayRefinementRules.h"
#include "itkDelaunayRefinementSliverRemoval.h"
#include "itkDelaunayRefinementSurfaceSample.h"
#include "itkDelaunayRefinementThreads.h"

#include <algorithm>
#include <chrono>
#include <random>

namespace itk
{
namespace
{
using Geometry = DelaunayRefinementGeometry;
using RefinementRule = DelaunayRefinementEnums::RefinementRule;
using EncroachmentCase = DelaunayRefinementEnums::EncroachmentCase;
using TerminationReason = DelaunayRefinementEnums::TerminationReason;
using VertexKind = DelaunayRefinementEnums::VertexKind;

/** The box keeps a little more than the distance from the surface that the proof of Lemma 2 needs. */
constexpr double BoxDistance = 2.8284271247461903 * 1.001;

/** More have nothing to do in a batch of insertions. */
constexpr unsigned int MostThreads = DelaunayRefinementCircumcenters::MostItems;

/** So many cells that follow each other are one thread's at a time. */
constexpr std::size_t CellsPerPiece = 4096;

/** So many cells ahead what their neighbors are is fetched from memory. */
constexpr std::size_t CellsToFetch = 8;

/** Insertions between two calls of the progress callback. */
constexpr unsigned int ProgressInterval = 256;

/** A component without a tetrahedron gets half its delta this often. */
constexpr unsigned int MaximumNumberOfLowerings = 4;

/** Tetrahedra that are too flat get another vertex, moved by this share of delta. */
constexpr double       ShapeMove = 1e-3;
constexpr unsigned int MaximumNumberOfShapeRounds = 20;

/** So often vertices are put where the boundary is no manifold. */
constexpr unsigned int MaximumNumberOfManifoldRounds = 20;

/** So often slivers are removed anew, but not if more than so many are left: the bound is out of reach then. */
constexpr unsigned int MaximumNumberOfSliverRounds = 20;
constexpr std::size_t  MostSliversForAnotherRound = 1000;
} // namespace

/** \class DelaunayRefinementEngine::Impl
 * \brief The loop over the rules, and all that it works on. */
class DelaunayRefinementEngine::Impl
{
public:
  Impl(const DelaunayRefinementOracle & oracle, const DelaunayRefinementParameters & parameters)
    : m_Oracle(oracle)
    , m_Parameters(parameters)
    , m_LocalDelta(oracle, parameters)
    , m_Threads(std::min(parameters.numberOfThreads, MostThreads))
  {}

  TerminationReason
  Run()
  {
    m_Statistics.terminationReason = this->RunAllPhases();
    return m_Statistics.terminationReason;
  }

  DelaunayRefinementResult
  TakeResult()
  {
    return std::move(m_Result);
  }

  const DelaunayRefinementStatistics &
  GetStatistics() const
  {
    return m_Statistics;
  }

  std::array<std::size_t, DelaunayRefinementEnums::NumberOfRefinementRules>
  CountFiringRules() const
  {
    if (m_Complex == nullptr)
    {
      return {};
    }
    return CountFiringDelaunayRefinementRules(m_Oracle, m_LocalDelta, *m_Sample, *m_Complex, *m_Rules);
  }

private:
  using PointType = DelaunayRefinementPoint;
  using IndexType = DelaunayRefinementComplex::IndexType;
  using Clock = std::chrono::steady_clock;

  TerminationReason
  RunAllPhases();

  bool
  StartComplex(const std::vector<PointType> & features);

  DelaunayRefinementOracle::BoundsType
  ComputeBox() const;

  /** Applies rules until none is left that fires, or the run is stopped. */
  void
  Refine();

  /** Queues whatever may fire for the new cells of the last call that changed the complex. */
  void
  ExamineNewCells();

  /** The same for all cells. */
  void
  ExamineAllCells();

  void
  Queue(const std::vector<DelaunayRefinementRules::FindingType> & findings);

  /** R1 for what is open of the surface, \c numberOfVertices being there already; false if the run is to stop. */
  bool
  Certify(std::vector<PointType> & points, std::size_t numberOfVertices);

  bool
  ApplyR3();
  bool
  ApplyR1();
  bool
  ApplyEncroachment();
  bool
  ApplyR2();
  bool
  ApplyR4();

  /** Inserts circumcenters of cells in a queue, if \c ask says so. */
  bool
  ApplyToCircumcenters(DelaunayRefinementBlockQueue & queue, const DelaunayRefinementCircumcenters::AskType & ask);

  /** R2 for one cell. */
  void
  InsertOrEncroach(IndexType cell);

  /** Inserts a vertex, None if there is one at the point or the limit is reached; a feature vertex also removes the
   * free vertices within 2 delta (section III), or within the cell size if that is less. */
  IndexType
  Insert(RefinementRule rule, const PointType & point, VertexKind kind, double delta, IndexType hint);

  void
  InsertFeature(RefinementRule rule, const PointType & point, IndexType hint);

  void
  Encroach(const DelaunayRefinementEncroachment::ProposalType & proposal, IndexType cell);

  /** Replaces a vertex of tetrahedra that are too flat to be stored; false if there were none. */
  bool
  MendFlatTetrahedra();

  void
  MoveVertex(IndexType vertex);

  /** Lowers delta for components in which no tetrahedron has its circumcenter; false if there were none. */
  bool
  LowerDeltaOfMissingComponents();

  /** Makes the regions' boundaries 2-manifolds; true if rules have to be asked again before the next try. */
  bool
  MakeManifold();

  /** Gives all tetrahedra back to the regions of their circumcenters, slivers that were left to outside included. */
  void
  UndoRepair();

  /** Puts a vertex on the largest surface ball of the facets at a vertex that part regions. */
  void
  InsertNear(IndexType vertex);

  /** Makes dihedral angles large enough; false if they are, or as large as can be. */
  bool
  RemoveSlivers();

  /** Tells the statistics what slivers are left. */
  void
  DescribeSlivers();

  /** Lowers delta where the boundary is not what was asked for; false if it is. */
  bool
  ImproveAccuracy();

  /** Tells the caller how far it is; false if he, now or before, wished to stop. */
  bool
  KeepGoing();

  static double
  SecondsSince(Clock::time_point start)
  {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  const DelaunayRefinementOracle &                  m_Oracle;
  DelaunayRefinementParameters                      m_Parameters;
  DelaunayRefinementLocalDelta                      m_LocalDelta;
  DelaunayRefinementThreads                         m_Threads;
  DelaunayRefinementStatistics                      m_Statistics{};
  DelaunayRefinementResult                          m_Result{};
  std::unique_ptr<DelaunayRefinementSurfaceSample>  m_Sample{};
  std::unique_ptr<DelaunayRefinementComplex>        m_Complex{};
  std::unique_ptr<DelaunayRefinementRules>          m_Rules{};
  std::unique_ptr<DelaunayRefinementEncroachment>   m_Encroachment{};
  std::unique_ptr<DelaunayRefinementCircumcenters>  m_Circumcenters{};
  std::unique_ptr<DelaunayRefinementManifoldRepair> m_Repair{};
  std::unique_ptr<DelaunayRefinementSliverRemoval>  m_SliverRemoval{};
  std::unique_ptr<DelaunayRefinementAccuracy>       m_Accuracy{};
  DelaunayRefinementBlockQueue                      m_R2Queue{};
  DelaunayRefinementQueue                           m_EncroachmentQueue{};
  DelaunayRefinementQueue                           m_R3Queue{};
  DelaunayRefinementBlockQueue                      m_R4Queue{};
  std::vector<IndexType>                            m_Found{};
  std::vector<DelaunayRefinementRules::FindingType> m_Findings{};
  DelaunayRefinementArray<std::uint32_t>            m_ExaminedIn{};
  std::uint32_t                                     m_NumberOfExaminations{ 0 };
  std::mt19937_64                                   m_Random{};
  bool                                              m_IsSampleOpen{ false };
  bool                                              m_IsSampleThinned{ false }; // by moves of vertices alone
  TerminationReason                                 m_Reason{ TerminationReason::COMPLETED };
  unsigned int                                      m_NumberOfLowerings{ 0 };
  unsigned int                                      m_NumberOfShapeRounds{ 0 };
  unsigned int                                      m_NumberOfManifoldRounds{ 0 };
  unsigned int                                      m_NumberOfSliverRounds{ 0 };
  IndexType                                         m_SizeAfterSlivers{ 0 };
  std::size_t                                       m_NumberOfSteps{ 0 };
  std::size_t                                       m_NextQuestion{ ProgressInterval };
  double                                            m_Progress{ 0.0 };
};

TerminationReason
DelaunayRefinementEngine::Impl::RunAllPhases()
{
  auto start = Clock::now();
  if (!this->KeepGoing())
  {
    return m_Reason;
  }
  m_Sample = std::make_unique<DelaunayRefinementSurfaceSample>(m_Oracle, m_LocalDelta, m_Parameters.roundToFloat);
  const auto             keepGoing = [this] { return this->KeepGoing(); };
  std::vector<PointType> features =
    SampleDelaunayRefinementJunctions(m_Oracle, m_LocalDelta, m_Parameters.roundToFloat, keepGoing);
  const std::size_t numberOfJunctions = features.size();
  for (const PointType & feature : features)
  {
    m_Sample->Add(feature);
  }
  const bool isSampled = this->KeepGoing() && m_Sample->Certify(features, m_Threads, keepGoing);
  m_Statistics.samplingSeconds = SecondsSince(start);
  if (!isSampled)
  {
    return m_Reason;
  }
  m_LocalDelta.Settle();
  if (features.empty())
  {
    return TerminationReason::NO_SURFACE_FOUND;
  }
  if (features.size() + 8 > m_Parameters.maximumNumberOfVertices)
  {
    return TerminationReason::VERTEX_LIMIT;
  }

  m_Statistics.insertions[static_cast<std::size_t>(RefinementRule::JUNCTION)] = numberOfJunctions;
  m_Statistics.insertions[static_cast<std::size_t>(RefinementRule::R1)] = features.size() - numberOfJunctions;

  start = Clock::now();
  const bool isStarted = this->StartComplex(features);
  m_Statistics.insertionSeconds = SecondsSince(start);
  if (!isStarted)
  {
    return m_Reason;
  }

  start = Clock::now();
  this->Refine();
  m_Statistics.refinementSeconds = SecondsSince(start);
  for (std::size_t kind = 0; kind < m_Statistics.vertices.size(); ++kind)
  {
    m_Statistics.vertices[kind] = m_Complex->GetNumberOfVertices(static_cast<VertexKind>(kind));
  }
  m_Statistics.loweredDeltas = m_LocalDelta.GetLowered();
  if (m_Reason != TerminationReason::COMPLETED)
  {
    return m_Reason;
  }

  start = Clock::now();
  m_Statistics.missingCavities = FindMissingDelaunayRefinementCavities(m_Oracle, *m_Complex, m_Threads);
  this->DescribeSlivers();
  if (this->KeepGoing())
  {
    m_Result = ExtractDelaunayRefinementResult(*m_Complex, &m_Threads);
  }
  m_Repair->Undo();
  m_Statistics.extractionSeconds = SecondsSince(start);
  return m_Reason;
}

DelaunayRefinementOracle::BoundsType
DelaunayRefinementEngine::Impl::ComputeBox() const
{
  // Rounding outwards to floats makes the corners fit either kind of coordinates.
  const double margin = BoxDistance * m_LocalDelta.GetMaximum();
  auto         box = m_Oracle.GetSurfaceBounds();
  for (int i = 0; i < 3; ++i)
  {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    box.minimum[i] = std::nextafter(static_cast<float>(box.minimum[i] - margin), -infinity);
    box.maximum[i] = std::nextafter(static_cast<float>(box.maximum[i] + margin), infinity);
  }
  return box;
}

bool
DelaunayRefinementEngine::Impl::StartComplex(const std::vector<PointType> & features)
{
  std::vector<double> deltas;
  deltas.reserve(features.size());
  for (const PointType & feature : features)
  {
    deltas.push_back(m_LocalDelta.GetAt(feature));
  }
  m_Complex = std::make_unique<DelaunayRefinementComplex>(m_Oracle, m_Parameters.roundToFloat, this->ComputeBox());
  m_Rules = std::make_unique<DelaunayRefinementRules>(m_Oracle, m_Parameters, *m_Complex, m_LocalDelta, *m_Sample);
  m_Encroachment = std::make_unique<DelaunayRefinementEncroachment>(*m_Complex);
  m_Circumcenters = std::make_unique<DelaunayRefinementCircumcenters>(*m_Complex, *m_Rules, m_Threads);
  m_Repair = std::make_unique<DelaunayRefinementManifoldRepair>(
    m_Oracle, *m_Rules, *m_Complex, m_Threads, m_Parameters.paperSlivers ? 0.0 : m_Parameters.minimumDihedralAngle);
  m_SliverRemoval = std::make_unique<DelaunayRefinementSliverRemoval>(
    m_Parameters, m_Oracle, m_LocalDelta, *m_Rules, *m_Repair, *m_Sample, *m_Complex, m_Threads);
  m_Accuracy =
    std::make_unique<DelaunayRefinementAccuracy>(m_Oracle, m_Parameters, *m_Complex, m_LocalDelta, m_Threads);
  const auto             keepGoing = [this] { return this->KeepGoing(); };
  std::vector<PointType> seeds = FindDelaunayRefinementInteriorSeeds(
    m_Oracle, features, m_LocalDelta.GetMaximum(), m_Parameters.roundToFloat, m_Threads, keepGoing);
  if (features.size() + seeds.size() + 8 > m_Parameters.maximumNumberOfVertices)
  {
    seeds.clear();
  }
  m_Statistics.seeds = seeds.size();
  m_Statistics.insertions[static_cast<std::size_t>(RefinementRule::R2)] = seeds.size();
  if (!m_Complex->Start(features, deltas, seeds, m_Threads, keepGoing))
  {
    // Half a triangulation is none.
    m_Complex.reset();
    return false;
  }
  this->ExamineAllCells();
  return true;
}

void
DelaunayRefinementEngine::Impl::Refine()
{
  // Any order of the rules keeps the proofs. Rules that insert feature vertices go first, as those remove free
  // vertices.
  while (m_Reason == TerminationReason::COMPLETED)
  {
    if (++m_NumberOfSteps >= m_NextQuestion)
    {
      m_NextQuestion = m_NumberOfSteps + ProgressInterval;
      if (!this->KeepGoing())
      {
        return;
      }
    }
    if (!(this->ApplyR1() || this->ApplyR3() || this->ApplyEncroachment() || this->ApplyR2() || this->ApplyR4() ||
          this->MendFlatTetrahedra() || this->LowerDeltaOfMissingComponents() || this->MakeManifold() ||
          this->ImproveAccuracy() || this->RemoveSlivers()))
    {
      return;
    }
  }
}

void
DelaunayRefinementEngine::Impl::ExamineNewCells()
{
  const auto & triangulation = m_Complex->GetTriangulation();
  LengthenDelaunayRefinementArray(m_ExaminedIn, triangulation.GetNumberOfCellIndexes());
  ++m_NumberOfExaminations;
  m_Findings.clear();
  for (const IndexType cell : m_Complex->GetNewCells())
  {
    // A facet between two new cells once, when the first of them has its turn.
    unsigned int facets = 0;
    m_ExaminedIn[cell] = m_NumberOfExaminations;
    for (unsigned int i = 0; i < 4; ++i)
    {
      const IndexType neighbor = triangulation.GetCell(cell).neighbors[i];
      facets |= m_ExaminedIn[neighbor] != m_NumberOfExaminations ? 1u << i : 0;
    }
    m_Rules->Examine(cell, facets, m_Findings);
  }
  this->Queue(m_Findings);
}

void
DelaunayRefinementEngine::Impl::ExamineAllCells()
{
  using FindingsType = std::vector<DelaunayRefinementRules::FindingType>;
  const auto &              triangulation = m_Complex->GetTriangulation();
  const auto &              cells = m_Complex->GetNewCells();
  std::vector<FindingsType> findings(DelaunayRefinementThreads::CountPieces(cells.size(), CellsPerPiece));
  const auto                examinePiece = [&](std::size_t piece, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      for (const IndexType neighbor : triangulation.GetCell(cells[std::min(i + CellsToFetch, end - 1)]).neighbors)
      {
        m_Complex->FetchRegion(neighbor);
      }
      unsigned int facets = 0;
      for (unsigned int slot = 0; slot < 4; ++slot)
      {
        facets |= triangulation.GetCell(cells[i]).neighbors[slot] > cells[i] ? 1u << slot : 0;
      }
      m_Rules->Examine(cells[i], facets, findings[piece]);
    }
  };
  DelaunayRefinementThreads::RunPieces(&m_Threads, cells.size(), CellsPerPiece, examinePiece);
  std::for_each(findings.begin(), findings.end(), [this](const FindingsType & some) { this->Queue(some); });
}

void
DelaunayRefinementEngine::Impl::Queue(const std::vector<DelaunayRefinementRules::FindingType> & findings)
{
  using RuleGroupEnum = DelaunayRefinementRules::RuleGroupEnum;
  for (const auto & finding : findings)
  {
    switch (finding.which)
    {
      case RuleGroupEnum::R2:
        m_R2Queue.Push(finding.block, finding.entry);
        break;
      case RuleGroupEnum::ENCROACHMENT:
        m_EncroachmentQueue.Push(finding.entry);
        break;
      case RuleGroupEnum::R3:
        m_R3Queue.Push(finding.entry);
        break;
      case RuleGroupEnum::R4:
        m_R4Queue.Push(finding.block, finding.entry);
        break;
    }
  }
}

bool
DelaunayRefinementEngine::Impl::Certify(std::vector<PointType> & points, std::size_t numberOfVertices)
{
  const auto keepGoing = [&] {
    if (points.size() + numberOfVertices > m_Parameters.maximumNumberOfVertices)
    {
      m_Reason = TerminationReason::VERTEX_LIMIT;
    }
    return this->KeepGoing();
  };
  if (!m_Sample->Certify(points, m_Threads, keepGoing))
  {
    return false;
  }
  m_LocalDelta.Settle();
  return true;
}

bool
DelaunayRefinementEngine::Impl::ApplyR3()
{
  DelaunayRefinementQueue::EntryType entry;
  if (!m_R3Queue.Pop(m_Complex->GetTriangulation(), entry))
  {
    return false;
  }
  PointType center;
  if (m_Rules->FiresR3(entry.cell, entry.facet, center))
  {
    this->InsertFeature(RefinementRule::R3, center, entry.cell);
  }
  return true;
}

bool
DelaunayRefinementEngine::Impl::ApplyR1()
{
  if (!m_IsSampleOpen)
  {
    return false;
  }
  // All at once: the points keep their distance from each other and from the vertices there are now.
  std::vector<PointType> points;
  const bool             isCertified = this->Certify(points, m_Complex->GetNumberOfVertices());
  if (isCertified && m_IsSampleThinned)
  {
    const std::size_t number = points.size();
    points = m_SliverRemoval->Cover(points);
    m_Statistics.insertions[static_cast<std::size_t>(RefinementRule::R1)] += number - points.size();
  }
  m_IsSampleThinned = false;
  if (!points.empty())
  {
    this->UndoRepair();
  }
  for (std::size_t i = 0; i < points.size() && m_Reason == TerminationReason::COMPLETED; ++i)
  {
    // Points come in an order in which each is near the one before it, or most are.
    const IndexType last = i == 0 ? 1 : m_Complex->GetTriangulation().GetNumberOfVertexIndexes() - 1;
    const IndexType hint = m_Complex->GetTriangulation().GetCellOfVertex(last);
    this->InsertFeature(
      RefinementRule::R1, points[i], hint != DelaunayRefinementComplex::None ? hint : m_Complex->GetNewCells().front());
    if (i % ProgressInterval == 0)
    {
      this->KeepGoing();
    }
  }
  m_IsSampleOpen = false;
  return true;
}

bool
DelaunayRefinementEngine::Impl::ApplyEncroachment()
{
  DelaunayRefinementQueue::EntryType entry;
  if (!m_EncroachmentQueue.Pop(m_Complex->GetTriangulation(), entry))
  {
    return false;
  }
  if (m_Rules->FiresR2(entry.cell))
  {
    this->InsertOrEncroach(entry.cell);
  }
  return true;
}

bool
DelaunayRefinementEngine::Impl::ApplyR2()
{
  return this->ApplyToCircumcenters(m_R2Queue, [this](IndexType cell, RefinementRule & rule) {
    rule = RefinementRule::R2;
    return m_Rules->FiresR2(cell);
  });
}

bool
DelaunayRefinementEngine::Impl::ApplyR4()
{
  return this->ApplyToCircumcenters(m_R4Queue, [this](IndexType cell, RefinementRule & rule) {
    rule = m_Rules->FiresR4(cell)         ? RefinementRule::R4
           : m_Rules->FiresCellSize(cell) ? RefinementRule::CELL_SIZE
                                          : RefinementRule::R4_PRIME;
    return true;
  });
}

bool
DelaunayRefinementEngine::Impl::ApplyToCircumcenters(DelaunayRefinementBlockQueue &                   queue,
                                                     const DelaunayRefinementCircumcenters::AskType & ask)
{
  using OutcomeEnum = DelaunayRefinementCircumcenters::OutcomeEnum;
  if (!m_Circumcenters->Apply(queue, ask, m_Parameters.maximumNumberOfVertices))
  {
    return false;
  }
  const auto & triangulation = m_Complex->GetTriangulation();
  for (const auto & item : m_Circumcenters->GetItems())
  {
    m_NumberOfSteps += item.numberOfCells;
    const bool isThere = triangulation.GetGeneration(item.entry.cell) == item.entry.generation;
    switch (item.outcome)
    {
      case OutcomeEnum::NOTHING:
        break;
      case OutcomeEnum::INSERTED:
        ++m_Statistics.insertions[static_cast<std::size_t>(item.rule)];
        this->Queue(item.findings);
        break;
      case OutcomeEnum::LATER:
        if (isThere)
        {
          queue.Push(m_Complex->FindBlock(item.entry.cell), item.entry);
        }
        break;
      case OutcomeEnum::BEYOND:
        if (isThere)
        {
          this->InsertOrEncroach(item.entry.cell);
        }
        break;
      case OutcomeEnum::FULL:
        m_Reason = TerminationReason::VERTEX_LIMIT;
        break;
    }
  }
  return true;
}

void
DelaunayRefinementEngine::Impl::InsertOrEncroach(IndexType cell)
{
  const PointType center = m_Complex->Round(m_Complex->GetCircumcenter(cell));
  const auto      proposal = m_Encroachment->FindEncroachment(center);
  if (proposal.which == EncroachmentCase::NONE)
  {
    this->Insert(RefinementRule::R2, center, VertexKind::FREE, 0.0, cell);
  }
  else
  {
    this->Encroach(proposal, cell);
  }
}

void
DelaunayRefinementEngine::Impl::InsertFeature(RefinementRule rule, const PointType & point, IndexType hint)
{
  const PointType rounded = m_Complex->Round(point);
  const IndexType vertex = this->Insert(rule, rounded, VertexKind::FEATURE, m_LocalDelta.GetAt(point), hint);
  if (vertex != DelaunayRefinementComplex::None && rule != RefinementRule::R1)
  {
    m_Sample->Add(rounded);
  }
}

DelaunayRefinementEngine::Impl::IndexType
DelaunayRefinementEngine::Impl::Insert(RefinementRule    rule,
                                       const PointType & point,
                                       VertexKind        kind,
                                       double            delta,
                                       IndexType         hint)
{
  if (m_Complex->GetNumberOfVertices() >= m_Parameters.maximumNumberOfVertices)
  {
    m_Reason = TerminationReason::VERTEX_LIMIT;
    return DelaunayRefinementComplex::None;
  }
  const IndexType vertex = m_Complex->Insert(point, kind, delta, hint);
  if (vertex == DelaunayRefinementComplex::None)
  {
    return vertex;
  }
  ++m_Statistics.insertions[static_cast<std::size_t>(rule)];
  this->ExamineNewCells();
  if (kind == VertexKind::FEATURE)
  {
    m_Complex->FindFreeVerticesWithin(vertex, std::min(2.0 * delta, m_Parameters.cellSize), m_Found);
    for (const IndexType found : m_Found)
    {
      m_Complex->Remove(found);
      ++m_Statistics.removals;
      this->ExamineNewCells();
    }
  }
  return vertex;
}

void
DelaunayRefinementEngine::Impl::Encroach(const DelaunayRefinementEncroachment::ProposalType & proposal, IndexType cell)
{
  const VertexKind kind = proposal.which == EncroachmentCase::E2 ? VertexKind::BOX : VertexKind::BOX_EDGE;
  const IndexType  vertex = this->Insert(RefinementRule::R2, proposal.point, kind, 0.0, cell);
  if (vertex == DelaunayRefinementComplex::None)
  {
    return;
  }
  ++m_Statistics.encroachments[static_cast<std::size_t>(proposal.which)];
  if (m_Complex->GetNumberOfVertices(VertexKind::FREE) == 0 &&
      (kind == VertexKind::BOX || m_Complex->GetNumberOfVertices(VertexKind::BOX) == 0))
  {
    return;
  }
  // Emptying the ball after the insertion leads to the same triangulation as before it.
  m_Complex->FindVerticesWithin(vertex, proposal.radius, m_Found);
  for (const IndexType found : m_Found)
  {
    const VertexKind other = m_Complex->GetKind(found);
    if (other == VertexKind::FREE || (other == VertexKind::BOX && kind == VertexKind::BOX_EDGE))
    {
      m_Complex->Remove(found);
      ++m_Statistics.encroachmentRemovals;
      this->ExamineNewCells();
    }
  }
}

bool
DelaunayRefinementEngine::Impl::MendFlatTetrahedra()
{
  if (m_NumberOfShapeRounds == MaximumNumberOfShapeRounds)
  {
    return false;
  }
  const std::vector<IndexType> vertices = FindVerticesOfFlatDelaunayRefinementTetrahedra(*m_Complex, m_Threads);
  if (vertices.empty())
  {
    return false;
  }
  ++m_NumberOfShapeRounds;
  this->UndoRepair();
  for (const IndexType vertex : vertices)
  {
    this->MoveVertex(vertex);
  }
  return true;
}

void
DelaunayRefinementEngine::Impl::MoveVertex(IndexType vertex)
{
  if (m_Complex->GetTriangulation().GetCellOfVertex(vertex) == DelaunayRefinementComplex::None)
  {
    // A feature vertex that was moved before this one made room for itself.
    return;
  }
  const VertexKind kind = m_Complex->GetKind(vertex);
  const double     delta = kind == VertexKind::FEATURE ? m_Complex->GetDelta(vertex) : m_LocalDelta.GetMinimum();
  const PointType  old = m_Complex->GetPoint(vertex);
  PointType        moved;
  if (!FindDelaunayRefinementPlaceNearby(m_Oracle, kind, old, ShapeMove * delta, m_Random, moved))
  {
    return;
  }
  m_Complex->Remove(vertex);
  this->ExamineNewCells();
  const IndexType hint = m_Complex->GetNewCells().front();
  if (this->Insert(RefinementRule::SHAPE, m_Complex->Round(moved), kind, delta, hint) ==
      DelaunayRefinementComplex::None)
  {
    // Somebody is there already.
    this->Insert(RefinementRule::SHAPE, old, kind, delta, m_Complex->GetTriangulation().GetCellOfVertex(1));
  }
  else if (kind == VertexKind::FEATURE)
  {
    m_Sample->Forget(old);
    m_Sample->Add(m_Complex->Round(moved));
  }
}

bool
DelaunayRefinementEngine::Impl::LowerDeltaOfMissingComponents()
{
  m_Statistics.missingComponents = FindMissingDelaunayRefinementComponents(m_Oracle, *m_Complex, m_Threads);
  if (m_NumberOfLowerings == MaximumNumberOfLowerings)
  {
    return false;
  }
  ++m_NumberOfLowerings;
  for (const std::uint32_t component : m_Statistics.missingComponents)
  {
    const auto & isDispensable = m_Parameters.isDispensable;
    if (component >= isDispensable.size() || !isDispensable[component])
    {
      m_LocalDelta.Lower(component, 0.5 * m_LocalDelta.GetOfComponent(component));
      m_IsSampleOpen = true;
    }
  }
  return m_IsSampleOpen;
}

bool
DelaunayRefinementEngine::Impl::MakeManifold()
{
  if (!m_Parameters.manifold)
  {
    return false;
  }
  const std::vector<IndexType> left = m_Repair->Run();
  m_Statistics.changedTetrahedra = m_Repair->GetNumberOfChanges();
  m_Statistics.nonManifoldVertices = left.size();
  if (left.empty() || m_NumberOfManifoldRounds == MaximumNumberOfManifoldRounds)
  {
    return false;
  }
  ++m_NumberOfManifoldRounds;
  this->UndoRepair();
  std::for_each(left.begin(), left.end(), [this](IndexType vertex) { this->InsertNear(vertex); });
  return true;
}

void
DelaunayRefinementEngine::Impl::UndoRepair()
{
  m_Repair->Undo();
  m_SizeAfterSlivers = 0;
}

void
DelaunayRefinementEngine::Impl::InsertNear(IndexType vertex)
{
  if (m_Complex->GetTriangulation().GetCellOfVertex(vertex) == DelaunayRefinementComplex::None)
  {
    // A feature vertex that was put nearby made room for itself.
    return;
  }
  DelaunayRefinementVertexStar star;
  star.Find(*m_Complex, vertex);
  const PointType own = m_Complex->GetPoint(vertex);
  PointType       chosen;
  double          largest = 0.0;
  for (std::size_t i = 0; i < star.GetCells().size(); ++i)
  {
    const auto & cell = star.GetCells()[i];
    for (const std::uint32_t neighbor : cell.neighbors)
    {
      PointType crossing;
      if (star.GetRegions()[i] > star.GetRegions()[neighbor] &&
          m_Oracle.FindFirstCrossing(m_Complex->GetCircumcenter(cell.index),
                                     m_Complex->GetCircumcenter(star.GetCells()[neighbor].index),
                                     crossing) &&
          Geometry::SquaredDistance(own, crossing) > largest)
      {
        largest = Geometry::SquaredDistance(own, crossing);
        chosen = crossing;
      }
    }
  }
  if (largest > 0.0)
  {
    this->InsertFeature(RefinementRule::MANIFOLD, chosen, star.GetCells().front().index);
  }
}

bool
DelaunayRefinementEngine::Impl::RemoveSlivers()
{
  // New tetrahedra come with new vertices, or when they are given back.
  const auto & triangulation = m_Complex->GetTriangulation();
  if (!(m_Parameters.minimumDihedralAngle > 0.0) || m_Parameters.paperSlivers ||
      m_NumberOfSliverRounds == MaximumNumberOfSliverRounds ||
      m_SizeAfterSlivers == triangulation.GetNumberOfVertexIndexes() ||
      m_SliverRemoval->GetNumberOfLeft() > MostSliversForAnotherRound)
  {
    return false;
  }
  ++m_NumberOfSliverRounds;
  const auto start = Clock::now();
  m_IsSampleOpen = m_SliverRemoval->Run([this] { return this->KeepGoing(); });
  m_IsSampleThinned = m_IsSampleOpen;
  m_SizeAfterSlivers = triangulation.GetNumberOfVertexIndexes();
  m_Statistics.sliverSeconds += SecondsSince(start);
  return m_IsSampleOpen;
}

void
DelaunayRefinementEngine::Impl::DescribeSlivers()
{
  m_Statistics.insertions[static_cast<std::size_t>(RefinementRule::SLIVER)] = m_SliverRemoval->GetNumberOfInsertions();
  m_Statistics.movedVertices = m_SliverRemoval->GetNumberOfMoves();
  m_Statistics.changedTetrahedra = m_Repair->GetNumberOfChanges();
  if (!(m_Parameters.minimumDihedralAngle > 0.0))
  {
    return;
  }
  for (const IndexType cell : m_SliverRemoval->FindSlivers())
  {
    const auto p = m_Complex->GetPoints(cell);
    PointType  center{};
    for (const PointType & point : p)
    {
      center = Geometry::AddScaled(center, 0.25, point);
    }
    const double cosine = Geometry::ComputeLargestDihedralCosine(p[0], p[1], p[2], p[3]);
    const double angle = std::acos(std::min(1.0, cosine)) / Geometry::RadiansPerDegree;
    if (angle < m_Parameters.minimumDihedralAngle)
    {
      m_Statistics.slivers.push_back({ angle, center });
    }
  }
  std::stable_sort(m_Statistics.slivers.begin(), m_Statistics.slivers.end(), [](const auto & a, const auto & b) {
    return a.dihedralAngle < b.dihedralAngle;
  });
}

bool
DelaunayRefinementEngine::Impl::ImproveAccuracy()
{
  m_IsSampleOpen = m_Accuracy->Improve(m_Statistics);
  if (m_IsSampleOpen)
  {
    this->UndoRepair();
  }
  return m_IsSampleOpen;
}

bool
DelaunayRefinementEngine::Impl::KeepGoing()
{
  if (m_Reason == TerminationReason::COMPLETED && m_Parameters.progress)
  {
    const double done = static_cast<double>(m_NumberOfSteps);
    const double queued = static_cast<double>(m_R2Queue.GetLength() + m_EncroachmentQueue.GetLength() +
                                              m_R3Queue.GetLength() + m_R4Queue.GetLength());
    m_Progress = std::max(m_Progress, done / (done + queued + 1.0));
    if (!m_Parameters.progress(m_Progress))
    {
      m_Reason = TerminationReason::STOPPED_BY_CALLER;
    }
  }
  return m_Reason == TerminationReason::COMPLETED;
}

DelaunayRefinementEngine::DelaunayRefinementEngine(const DelaunayRefinementOracle &     oracle,
                                                   const DelaunayRefinementParameters & parameters)
  : m_Impl(std::make_unique<Impl>(oracle, parameters))
{}

DelaunayRefinementEngine::~DelaunayRefinementEngine() = default;

DelaunayRefinementEnums::TerminationReason
DelaunayRefinementEngine::Run()
{
  return m_Impl->Run();
}

DelaunayRefinementResult
DelaunayRefinementEngine::TakeResult()
{
  return m_Impl->TakeResult();
}

const DelaunayRefinementStatistics &
DelaunayRefinementEngine::GetStatistics() const
{
  return m_Impl->GetStatistics();
}

std::array<std::size_t, DelaunayRefinementEnums::NumberOfRefinementRules>
DelaunayRefinementEngine::CountFiringRules() const
{
  return m_Impl->CountFiringRules();
}
} // end namespace itk
