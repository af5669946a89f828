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
#ifndef itkDelaunayRefinementMeshFilterWarnings_hxx
#define itkDelaunayRefinementMeshFilterWarnings_hxx

// What the filter tells of a mesh that lacks something, and whether that is an error. Included at the end of the
// filter's own file.

#include "itkDelaunayRefinementMeshFilter.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace itk
{
template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::FindMissingLabels(const DelaunayRefinementResult & result)
{
  std::vector<bool> isThere(m_RegionLabels.size(), false);
  for (const std::uint32_t region : result.regions)
  {
    isThere[region - 1] = true;
  }
  for (std::size_t i = 0; i < m_RegionLabels.size(); ++i)
  {
    if (!isThere[i])
    {
      m_MissingLabels.push_back(m_RegionLabels[i]);
    }
  }
}

template <typename TInputImage, typename TOutputMesh>
template <typename TDescribe>
std::string
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::DescribeSome(std::size_t number, const TDescribe & describe)
{
  constexpr std::size_t mostShown = 10;
  std::ostringstream    text;
  for (std::size_t i = 0; i < std::min(number, mostShown); ++i)
  {
    text << (i == 0 ? "" : ", ");
    describe(text, i);
  }
  text << (number > mostShown ? ", ..." : "");
  return text.str();
}

template <typename TInputImage, typename TOutputMesh>
std::string
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::DescribePlace(const DelaunayRefinementPoint & place)
{
  std::ostringstream text;
  text << place[0] << ", " << place[1] << ", " << place[2];
  return text.str();
}

template <typename TInputImage, typename TOutputMesh>
template <typename TPart>
std::string
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::DescribeVoxels(const TPart & part)
{
  std::ostringstream text;
  text << part.numberOfVoxels << (part.numberOfVoxels == 1 ? " voxel" : " voxels") << " at ("
       << DescribePlace(part.firstVoxel) << ")";
  return text.str();
}

template <typename TInputImage, typename TOutputMesh>
std::string
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::DescribeComponent(
  const DelaunayRefinementComponent & component) const
{
  std::ostringstream text;
  if (m_RegionLabels.size() > 1)
  {
    text << "label "
         << static_cast<typename NumericTraits<InputPixelType>::PrintType>(m_RegionLabels[component.region - 1])
         << " with ";
  }
  text << DescribeVoxels(component);
  return text.str();
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::WarnOfLabels()
{
  if (m_MissingLabels.empty())
  {
    return;
  }
  const auto describe = [this](std::ostream & text, std::size_t i) {
    const InputPixelType label = m_MissingLabels[i];
    const auto           place = std::lower_bound(m_RegionLabels.begin(), m_RegionLabels.end(), label);
    const auto           region = static_cast<std::uint32_t>(1 + (place - m_RegionLabels.begin()));
    // Its first component tells the place.
    double                              volume = 0.0;
    const DelaunayRefinementComponent * first = nullptr;
    for (const DelaunayRefinementComponent & component : m_Components)
    {
      if (component.region == region)
      {
        volume += component.volume;
        first = first == nullptr ? &component : first;
      }
    }
    text << static_cast<typename NumericTraits<InputPixelType>::PrintType>(label) << " (" << volume << " mm^3"
         << (first != nullptr ? " at " + DescribePlace(first->firstVoxel) : "") << ')';
  };
  std::ostringstream text;
  text << m_MissingLabels.size() << " of " << m_RegionLabels.size()
       << (m_MissingLabels.size() == 1 ? " labels is" : " labels are")
       << " missing in the mesh: " << DescribeSome(m_MissingLabels.size(), describe);
  m_Warnings.push_back(text.str());
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::ThrowIfStrict() const
{
  const bool isComplete =
    m_MissingLabels.empty() && m_Statistics.missingComponents.empty() && m_Statistics.missingCavities.empty();
  const bool isNear = !(m_HausdorffBound > 0.0) || std::max(m_Statistics.meshToSurface.distance,
                                                            m_Statistics.surfaceToMesh.distance) < m_HausdorffBound;
  const bool hasTopology = m_Statistics.meshTopology == m_Statistics.imageTopology;
  if (m_Strict && !(isComplete && isNear && hasTopology))
  {
    // What is missing is told first, what is not true to the image last.
    itkExceptionMacro("The mesh is not " << (isComplete ? "true to the image" : "complete") << ", as Strict asks for: "
                                         << (isComplete ? m_Warnings.back() : m_Warnings.front())
                                         << "; set a smaller Delta, or leave Strict off");
  }
  const std::string slivers = this->DescribeSlivers();
  if (m_Strict && !slivers.empty())
  {
    itkExceptionMacro("The mesh is not free of slivers, as Strict asks for: "
                      << slivers << "; set a smaller MinimumDihedralAngle, or leave Strict off");
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::WarnOfComponents()
{
  const std::string orOwn = m_LabelDeltas.empty() ? "" : " or the delta of their label";
  const auto &      missing = m_Statistics.missingComponents;
  if (!missing.empty())
  {
    std::ostringstream text;
    text << missing.size() << " of " << m_Components.size()
         << (missing.size() == 1 ? " components is" : " components are") << " too small for Delta " << m_EffectiveDelta
         << " mm" << orOwn
         << " and missing in the mesh: " << DescribeSome(missing.size(), [&](std::ostream & some, std::size_t i) {
              some << this->DescribeComponent(m_Components[missing[i]]);
            });
    m_Warnings.push_back(text.str());
  }
  const auto & lowered = m_Statistics.loweredDeltas;
  if (!lowered.empty())
  {
    const auto smallest = std::min_element(
      lowered.begin(), lowered.end(), [](const auto & a, const auto & b) { return a.second < b.second; });
    std::ostringstream text;
    text << "Delta was lowered for " << lowered.size() << " of " << m_Components.size()
         << " components that are too small for " << m_EffectiveDelta << " mm" << orOwn << "; the least is "
         << smallest->second << " mm for " << this->DescribeComponent(m_Components[smallest->first]);
    m_Warnings.push_back(text.str());
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::WarnOfCavities()
{
  const std::string orOwn = m_LabelDeltas.empty() ? "" : " or the delta of their label";
  const std::string orSmoothing = m_Smoothing > 0.0 ? ", or for Smoothing," : "";
  const auto &      missing = m_Statistics.missingCavities;
  if (missing.empty())
  {
    return;
  }
  const auto describe = [&](std::ostream & text, std::size_t i) { text << DescribeVoxels(m_Cavities[missing[i]]); };
  std::ostringstream text;
  text << missing.size() << " of " << m_Cavities.size() << (missing.size() == 1 ? " cavities is" : " cavities are")
       << " too small for Delta " << m_EffectiveDelta << " mm" << orOwn << orSmoothing
       << " and filled in the mesh: " << DescribeSome(missing.size(), describe);
  m_Warnings.push_back(text.str());
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::WarnOfSurface()
{
  if (m_Statistics.nonManifoldVertices > 0 && m_RegionLabels.size() < 2)
  {
    std::ostringstream text;
    text << "The boundary is no 2-manifold at " << m_Statistics.nonManifoldVertices << " vertices; set a smaller Delta";
    m_Warnings.push_back(text.str());
  }
  const auto warn = [this](const DelaunayRefinementDistance & distance, const char * from, const char * to) {
    if (distance.distance >= m_HausdorffBound)
    {
      std::ostringstream text;
      text << "HausdorffBound " << m_HausdorffBound << " mm is not kept: " << from << " is " << distance.distance
           << " mm from " << to << " at (" << DescribePlace(distance.place) << ")";
      m_Warnings.push_back(text.str());
    }
  };
  if (!(m_Statistics.meshTopology == m_Statistics.imageTopology))
  {
    std::ostringstream text;
    text << "The mesh has another topology, " << m_Statistics.meshTopology << ", than the object in the image, "
         << m_Statistics.imageTopology;
    m_Warnings.push_back(text.str());
  }
  if (m_HausdorffBound > 0.0)
  {
    warn(m_Statistics.meshToSurface, "the mesh's boundary", "the surface in the image");
    warn(m_Statistics.surfaceToMesh, "the surface in the image", "the mesh's boundary");
  }
}

template <typename TInputImage, typename TOutputMesh>
std::string
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::DescribeSlivers() const
{
  const auto & slivers = m_Statistics.slivers;
  if (slivers.empty() || m_PaperSlivers)
  {
    return "";
  }
  std::ostringstream text;
  text << "MinimumDihedralAngle " << m_MinimumDihedralAngle << " degrees is not kept by " << slivers.size()
       << (slivers.size() == 1 ? " tetrahedron: " : " tetrahedra: ")
       << DescribeSome(slivers.size(), [&](std::ostream & some, std::size_t i) {
            some << slivers[i].dihedralAngle << " at (" << DescribePlace(slivers[i].place) << ")";
          });
  return text.str();
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::WarnOfSlivers()
{
  const std::string slivers = this->DescribeSlivers();
  if (!slivers.empty())
  {
    m_Warnings.push_back(slivers);
  }
}

template <typename TInputImage, typename TOutputMesh>
void
DelaunayRefinementMeshFilter<TInputImage, TOutputMesh>::WarnOfSmoothing()
{
  if (m_LoweredSmoothings.empty())
  {
    return;
  }
  const auto largest =
    std::max_element(m_LoweredSmoothings.begin(), m_LoweredSmoothings.end(), [](const auto & a, const auto & b) {
      return a.first.numberOfVoxels < b.first.numberOfVoxels;
    });
  std::ostringstream text;
  text << "Smoothing was lowered for " << m_LoweredSmoothings.size() << " components that are thin or small against "
       << m_Smoothing << " mm; the largest is " << this->DescribeComponent(largest->first) << ", smoothed by "
       << largest->second << " mm";
  m_Warnings.push_back(text.str());
}
} // end namespace itk

#endif
