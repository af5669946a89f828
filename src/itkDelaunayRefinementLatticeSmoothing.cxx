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
#include "itkDelaunayRefinementLatticeVisit.h"
#include "itkDelaunayRefinementSmoothedRegions.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** At the start no component is smoothed by more than this share of its inscribed radius. */
constexpr double LargestShareOfRadius = 0.5;

/** A component that loses more than this share of its voxels is smoothed by half the width. */
constexpr double LargestLoss = 0.03;

/** Narrower widths, in voxels, are none; wider ones would take time and memory as their cube. */
constexpr double LeastWidthInVoxels = 0.2;
constexpr double LargestWidthInVoxels = 6.0;

/** What a weight of one half is multiplied by, at most, to be less. */
constexpr double LargestMirrored = 1.0 - 1e-6;
} // namespace

void
DelaunayRefinementLatticeOracle::Smooth(double width)
{
  width = std::min(width, LargestWidthInVoxels * this->GetLeastSpacing());
  const std::vector<DelaunayRefinementComponent> components =
    this->ComputeComponents(width / LargestShareOfRadius, true);
  const std::array<double, 3> spacing{ std::sqrt(m_Gram[0][0]), std::sqrt(m_Gram[1][1]), std::sqrt(m_Gram[2][2]) };
  const double                leastWidth = LeastWidthInVoxels * this->GetLeastSpacing();
  // Of a few widths, so that few kernels are needed.
  const auto lower = [leastWidth](double value, double limit) {
    while (value > limit && value >= leastWidth)
    {
      value *= 0.5;
    }
    return value < leastWidth ? 0.0 : value;
  };

  std::vector<double> widths;
  for (const DelaunayRefinementComponent & component : components)
  {
    widths.push_back(lower(width, LargestShareOfRadius * component.inscribedRadius));
  }
  this->FindCavities();
  m_Smoothed = std::make_unique<DelaunayRefinementSmoothedRegions>(*m_Mask, *m_Components, *m_Bricks, spacing);
  for (bool isDone = false; !isDone;)
  {
    m_Smoothed->Smooth(widths, m_Threads);
    const std::vector<std::ptrdiff_t> gains = m_Smoothed->CountGains(m_Threads);
    isDone = true;
    for (std::size_t i = 0; i < widths.size(); ++i)
    {
      const double loss = -static_cast<double>(gains[i]) / static_cast<double>(components[i].numberOfVoxels);
      if (loss > LargestLoss && widths[i] > 0.0)
      {
        widths[i] = lower(widths[i], 0.5 * widths[i]);
        isDone = false;
      }
    }
  }
  for (std::size_t i = 0; i < widths.size(); ++i)
  {
    if (widths[i] < width)
    {
      m_LoweredWidths.emplace_back(components[i], widths[i]);
    }
  }
  this->TakeSmoothedRegions();
}

void
DelaunayRefinementLatticeOracle::TakeSmoothedRegions()
{
  const auto isInImage = [this](const IndexType & voxel) {
    const auto & size = m_Mask->GetSize();
    return voxel[0] >= 0 && voxel[1] >= 0 && voxel[2] >= 0 && voxel[0] < size[0] && voxel[1] < size[1] &&
           voxel[2] < size[2];
  };
  const auto forEachVoxel = [&](const auto & action) {
    m_Smoothed->ForEachVoxel([&](const IndexType & padded, RegionType region) {
      const IndexType voxel{ padded[0] - 1, padded[1] - 1, padded[2] - 1 };
      if (isInImage(voxel))
      {
        action(voxel, region);
      }
    });
  };
  forEachVoxel(
    [this](const IndexType & voxel, RegionType region) { m_Mask->Set(voxel[0], voxel[1], voxel[2], region != 0); });
  if (this->HasRegions())
  {
    forEachVoxel([&](const IndexType & voxel, RegionType region) {
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        IndexType before = voxel;
        --before[axis];
        m_Changes->Set(axis,
                       voxel[0],
                       voxel[1],
                       voxel[2],
                       isInImage(before) && m_Mask->Get(before[0], before[1], before[2]) &&
                         this->GetRegion(before[0], before[1], before[2]) != region);
      }
    });
    const auto regionOf = [this](std::int32_t x, std::int32_t y, std::int32_t z) { return this->GetRegion(x, y, z); };
    *m_Components = DelaunayRefinementVoxelComponents(*m_Mask, *m_Changes, regionOf, m_Threads);
  }
  else
  {
    // Its weights are values, and one half is the level.
    m_Model = ModelEnum::GREY;
    *m_Components = DelaunayRefinementVoxelComponents(*m_Mask, m_Threads);
  }
  *m_Bricks = DelaunayRefinementBricks(*m_Mask, m_Changes.get(), m_Threads);
}

DelaunayRefinementOracle::RegionType
DelaunayRefinementLatticeOracle::GetRegion(std::int32_t x, std::int32_t y, std::int32_t z) const
{
  if (m_Smoothed != nullptr)
  {
    const IndexType padded{ x + 1, y + 1, z + 1 };
    if (m_Smoothed->Has(padded))
    {
      return m_Smoothed->GetRegion(padded);
    }
  }
  return this->GetVoxelRegion(x, y, z);
}

double
DelaunayRefinementLatticeOracle::GetValue(std::int32_t x, std::int32_t y, std::int32_t z) const
{
  if (m_Smoothed != nullptr)
  {
    const IndexType padded{ x + 1, y + 1, z + 1 };
    return m_Smoothed->Has(padded) ? m_Smoothed->GetWeight(padded) - 0.5 : m_Mask->Get(x, y, z) ? 0.5 : -0.5;
  }
  const auto & size = m_Mask->GetSize();
  return this->GetVoxelValue(
    std::clamp(x, 0, size[0] - 1), std::clamp(y, 0, size[1] - 1), std::clamp(z, 0, size[2] - 1));
}

DelaunayRefinementRegionsCell
DelaunayRefinementLatticeOracle::MakeSmoothedCell(const IndexType & cell) const
{
  DelaunayRefinementRegionsCell content;
  for (unsigned int i = 0; i < 8; ++i)
  {
    const IndexType padded{ cell[0] + static_cast<std::int32_t>(i & 1u),
                            cell[1] + static_cast<std::int32_t>(i >> 1 & 1u),
                            cell[2] + static_cast<std::int32_t>(i >> 2) };
    const bool      isInside = m_Mask->Get(padded[0] - 1, padded[1] - 1, padded[2] - 1);
    if (m_Smoothed->Has(padded))
    {
      // The mask prevails: in the outer layer, and where components were removed, weights are mirrored about one half.
      const double weight = m_Smoothed->GetWeight(padded);
      const bool   isMirrored = !isInside && weight >= 0.5;
      m_Smoothed->SetWeights(
        padded, i, isMirrored ? std::clamp((1.0 - weight) / weight, 0.0, LargestMirrored) : 1.0, content);
    }
    else if (isInside)
    {
      content.Add(this->GetVoxelRegion(padded[0] - 1, padded[1] - 1, padded[2] - 1), i, 1.0);
      content.SetUnion(i, 1.0);
    }
  }
  return content;
}
} // end namespace itk
