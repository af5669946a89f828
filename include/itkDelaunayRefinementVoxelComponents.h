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
#ifndef itkDelaunayRefinementVoxelComponents_h
#define itkDelaunayRefinementVoxelComponents_h

#include "itkDelaunayRefinementRegionChanges.h"
#include "itkDelaunayRefinementThreads.h"
#include "itkDelaunayRefinementVoxelMask.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace itk
{
/** \class DelaunayRefinementVoxelComponents
 * \brief The 18-connected components of a mask's voxels: those that share a face or an edge belong together, as the
 * half level of the interpolated mask joins them. Where voxels have regions, those of one region do.
 *
 * Components are numbered from 0 in the order of their first voxels.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinement_EXPORT DelaunayRefinementVoxelComponents
{
public:
  /** A voxel: x, y, z from the image's first voxel. */
  using IndexType = std::array<std::int32_t, 3>;
  /** Components are numbered from 0. */
  using ComponentType = std::uint32_t;

  /** Voxels first to last (included) of one row. */
  struct RunType
  {
    /** Its first voxel's x. */
    std::int32_t first;
    /** Its last voxel's x. */
    std::int32_t last;
    /** The component it belongs to. */
    ComponentType component;
  };

  /** What is known of a component. */
  struct ComponentInfoType
  {
    /** Size in voxels. */
    std::size_t numberOfVoxels;
    /** The first in the order of the image. */
    IndexType firstVoxel;
    /** Least index along each axis. */
    IndexType minimum;
    /** Greatest index along each axis. */
    IndexType maximum;
    /** The region of its voxels. */
    DelaunayRefinementRegion region;
  };

  /** The region of the voxel (x, y, z) of the mask. May be called on several threads at once. */
  using RegionOfVoxelType = std::function<DelaunayRefinementRegion(std::int32_t, std::int32_t, std::int32_t)>;

  /** The runs of all rows. */
  using RunsType = DelaunayRefinementArray<RunType>;

  /** Finds the components of a mask, on several threads if there are any. */
  explicit DelaunayRefinementVoxelComponents(const DelaunayRefinementVoxelMask & mask,
                                             DelaunayRefinementThreads *         threads = nullptr);

  /** The same by regions. */
  DelaunayRefinementVoxelComponents(const DelaunayRefinementVoxelMask &     mask,
                                    const DelaunayRefinementRegionChanges & changes,
                                    const RegionOfVoxelType &               regionOf,
                                    DelaunayRefinementThreads *             threads = nullptr);

  /** All components, by their numbers. */
  const std::vector<ComponentInfoType> &
  GetComponents() const
  {
    return m_Components;
  }

  /** Removes components from here and their voxels from the mask; the others keep their order. */
  void
  Remove(const std::vector<bool> & isRemoved, DelaunayRefinementVoxelMask & mask);

  /** The component of a voxel of the object. */
  ComponentType
  Find(std::int32_t x, std::int32_t y, std::int32_t z) const;

  /** Visits the components of all voxels in a box that may reach beyond the image, \c last included, some more than
   * once. */
  template <typename TVisitor>
  void
  VisitInBox(const IndexType & first, const IndexType & last, const TVisitor & visit) const
  {
    for (std::int32_t z = std::max(first[2], 0); z <= std::min(last[2], m_Size[2] - 1); ++z)
    {
      for (std::int32_t y = std::max(first[1], 0); y <= std::min(last[1], m_Size[1] - 1); ++y)
      {
        const RunType * const end = m_Runs.data() + this->GetFirstRun(y + 1, z);
        const RunType *       run = std::lower_bound(m_Runs.data() + this->GetFirstRun(y, z),
                                               end,
                                               first[0],
                                               [](const RunType & left, std::int32_t x) { return left.last < x; });
        for (; run != end && run->first <= last[0]; ++run)
        {
          visit(run->component);
        }
      }
    }
  }

  /** Runs of all rows, one row after another. */
  const RunsType &
  GetRuns() const
  {
    return m_Runs;
  }

  /** The first run of row (y, z); that of the next row ends it. */
  std::size_t
  GetFirstRun(std::int32_t y, std::int32_t z) const
  {
    return this->GetFirstRun(static_cast<std::size_t>(z) * m_Size[1] + y);
  }

  /** The same by the row's number, y + z times the rows of a slice. */
  std::size_t
  GetFirstRun(std::size_t row) const
  {
    return m_FirstRuns[row];
  }

private:
  std::size_t
  GetNumberOfRows() const
  {
    return static_cast<std::size_t>(m_Size[1]) * m_Size[2];
  }

  void
  FindComponents(DelaunayRefinementThreads * threads);

  /** \c changes may be null. */
  void
  FindRuns(const DelaunayRefinementVoxelMask &     mask,
           const DelaunayRefinementRegionChanges * changes,
           DelaunayRefinementThreads *             threads);

  // While runs are joined, the component of each is the number of one before it that it is joined to, or its own.

  ComponentType
  FindRoot(ComponentType run);

  /** That of all runs of a row, which has some, if all are joined to the same one. */
  ComponentType
  FindComponentOfRow(std::size_t row) const;

  /** Joins the runs of two rows that come within \c reach voxels of each other. */
  void
  JoinRows(std::size_t row, std::size_t other, std::int32_t reach);

  /** Two runs, by their numbers. */
  void
  JoinRuns(std::size_t i, std::size_t j);

  /** Joins the rows of some slices to each other. */
  void
  JoinSlices(std::int32_t begin, std::int32_t end);

  void
  JoinSliceToPrevious(std::int32_t z);

  void
  NumberComponents();

  /** Adds the runs of some rows to what is known of components. */
  void
  Summarize(std::size_t beginRow, std::size_t endRow, std::vector<ComponentInfoType> & infos) const;

  DelaunayRefinementVoxelMask::SizeType m_Size;
  RunsType                              m_Runs{};
  /** For each run; empty without regions. */
  DelaunayRefinementArray<DelaunayRefinementRegion> m_Regions{};
  DelaunayRefinementArray<ComponentType>            m_FirstRuns{};
  DelaunayRefinementArray<ComponentType>            m_RowComponents{}; // while runs are joined
  std::vector<ComponentInfoType>                    m_Components{};
};
} // end namespace itk

#endif
