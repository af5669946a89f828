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
#ifndef itkFilterRun_h
#define itkFilterRun_h

#include "itkCheckedFilterOutput.h"
#include "itkDelaunayRefinementMeshFilter.h"
#include "itkMeshExpectations.h"
#include "itkTestImages.h"

#include "itkDefaultStaticMeshTraits.h"
#include "itkMesh.h"

namespace itk::DelaunayRefinementTest
{
/** Stores coordinates as floats. */
using FloatMeshType = Mesh<float, 3>;
using DoubleMeshType = Mesh<double, 3, DefaultStaticMeshTraits<double, 3, 3, double, double>>;

template <typename TMesh = FloatMeshType, typename TImage>
typename DelaunayRefinementMeshFilter<TImage, TMesh>::Pointer
MakeFilter(const TImage * image, double delta)
{
  auto filter = DelaunayRefinementMeshFilter<TImage, TMesh>::New();
  filter->SetInput(image);
  filter->SetDelta(delta);
  return filter;
}

template <typename TFilter>
CheckedMesh
GetMesh(TFilter * filter)
{
  CheckedMesh  mesh = MakeCheckedMesh(*filter->GetOutput(), *filter->GetBoundaryOutput());
  const auto & others = filter->GetBoundaryOtherLabels()->CastToSTLConstContainer();
  mesh.triangleOtherLabels.assign(others.begin(), others.end());
  return mesh;
}

/** Updates the filter; the text of the exception if there is one, else empty. */
template <typename TFilter>
std::string
GetError(TFilter * filter)
{
  try
  {
    filter->Update();
  }
  catch (const ExceptionObject & exception)
  {
    EXPECT_TRUE(filter->GetOutput()->GetNumberOfCells() == 0 || filter->GetOutput()->GetCells() == nullptr);
    return exception.GetDescription();
  }
  return {};
}

/** The filter refuses, with a sentence that has these words. */
template <typename TFilter>
void
ExpectError(TFilter * filter, const std::vector<std::string> & words)
{
  const std::string error = GetError(filter);
  EXPECT_FALSE(error.empty());
  for (const std::string & word : words)
  {
    EXPECT_NE(error.find(word), std::string::npos) << "\"" << word << "\" is missing in: " << error;
  }
}

/** One label for all tetrahedra and triangles. */
inline void
ExpectLabel(const CheckedMesh & mesh, double label)
{
  EXPECT_TRUE(mesh.tetrahedronLabels == std::vector<double>(mesh.tetrahedra.size(), label));
  EXPECT_TRUE(mesh.triangleLabels == std::vector<double>(mesh.triangles.size(), label));
}
} // end namespace itk::DelaunayRefinementTest

#endif
