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
#ifndef itkFuzzCase_h
#define itkFuzzCase_h

#include "itkFilterRun.h"
#include "itkOracleChecks.h"

#include "itkBSplineInterpolateImageFunction.h"
#include "itkNearestNeighborInterpolateImageFunction.h"

namespace itk::DelaunayRefinementTest
{
/** \class FuzzBytes
 * \brief Turns bytes into numbers, and into zeros when there are no more.
 */
class FuzzBytes
{
public:
  FuzzBytes(const std::uint8_t * data, std::size_t size)
    : m_Next(data)
    , m_End(data + size)
  {}

  unsigned int
  TakeByte()
  {
    return m_Next == m_End ? 0u : *m_Next++;
  }

  /** True for one byte in \c many. */
  bool
  TakeRarely(unsigned int many)
  {
    return this->TakeByte() * many >= 256u * (many - 1u);
  }

  /** Between two numbers. */
  double
  TakeNumber(double low, double high)
  {
    return low + (high - low) * this->TakeByte() / 255.0;
  }

private:
  const std::uint8_t * m_Next;
  const std::uint8_t * m_End;
};

/** \class FuzzOutcomes
 * \brief How often each end was seen.
 */
struct FuzzOutcomes
{
  std::size_t meshed{ 0 };
  std::size_t refusedParameters{ 0 };
  std::size_t refusedObjects{ 0 };
  std::size_t tetrahedra{ 0 };
};

/** A short image of 6 x 6 x 6 voxels, anywhere in space: a mask of 0 and 1, or grey values. */
inline ShortImageType::Pointer
MakeFuzzImage(FuzzBytes & bytes, bool isGrey)
{
  ImageGeometry geometry = MakeObliqueGeometry({ 0.0, 0.0, 0.0 }, bytes.TakeRarely(2));
  if (bytes.TakeRarely(2))
  {
    geometry.direction.SetIdentity();
  }
  geometry.size.Fill(6);
  for (unsigned int i = 0; i < 3; ++i)
  {
    geometry.spacing[i] = bytes.TakeRarely(2) ? bytes.TakeNumber(0.6, 1.8) : 1.0;
    geometry.origin[i] = bytes.TakeNumber(-200.0, 200.0);
  }
  const auto         image = MakeEmptyImage<short>(geometry);
  const unsigned int density = bytes.TakeByte();
  for (ImageRegionIteratorWithIndex<ShortImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    const unsigned int value = bytes.TakeByte();
    it.Set(static_cast<short>(isGrey ? static_cast<int>(value) - 128 : value < density ? 1 : 0));
  }
  return image;
}

template <typename TFilter>
std::string
DescribeFuzzCase(TFilter * filter)
{
  std::ostringstream text;
  text.precision(17);
  filter->GetInput()->Print(text);
  filter->Print(text);
  for (ImageRegionConstIteratorWithIndex<ShortImageType> it(filter->GetInput(),
                                                            filter->GetInput()->GetBufferedRegion());
       !it.IsAtEnd();
       ++it)
  {
    text << it.Get() << ' ';
  }
  return text.str();
}

/** Every guarantee that holds for any image and delta. */
template <typename TFilter>
void
ExpectFuzzGuarantees(TFilter * filter, const DelaunayRefinementOracle & oracle)
{
  const CheckedMesh mesh = GetMesh(filter);
  ExpectGuarantees(mesh, filter->GetRadiusEdgeRatioBound());
  ExpectLabel(mesh, 1.0);
  EXPECT_LE(ComputeMaximumCircumradius(mesh), filter->GetCellSize() * (1.0 + 1e-5));
  for (const std::uint32_t missing : filter->GetStatistics().missingComponents)
  {
    EXPECT_LT(filter->GetComponents()[missing].numberOfVoxels,
              std::max<std::size_t>(8, filter->GetMinimumComponentSize()));
  }
  EXPECT_EQ(filter->GetStatistics().missingComponents.empty(),
            std::none_of(filter->GetWarnings().begin(), filter->GetWarnings().end(), [](const std::string & warning) {
              return warning.find("missing") != std::string::npos;
            }));
  const double delta = filter->GetEffectiveDelta();
  EXPECT_LT(ComputeMaximumDistance(SampleBoundary(mesh, delta / 2.0),
                                   [&oracle, delta](const PointType & point) {
                                     return oracle.IsSurfaceWithin(point, delta * (1.0 + 1e-5)) ? 0.0 : 1.0;
                                   }),
            0.5);
}

/** Meshes what the bytes say, and expects either the guarantees or a refusal for a reason that is known beforehand. */
template <typename TMesh>
void
MeshFuzzCase(FuzzBytes & bytes, FuzzOutcomes & outcomes)
{
  using ObjectType = DelaunayRefinementObject<short>;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  const unsigned int definition = bytes.TakeByte() % 3;
  const bool         isGrey = definition != 0;
  const auto         image = MakeFuzzImage(bytes, isGrey);
  const auto         filter = DelaunayRefinementMeshFilter<ShortImageType, TMesh>::New();
  filter->SetInput(image);
  ObjectType object;
  if (definition == 1)
  {
    object.definition = ObjectType::DefinitionEnum::THRESHOLD;
    object.lower = bytes.TakeNumber(-130.0, 130.0);
    object.upper = object.lower + bytes.TakeNumber(0.0, 300.0);
    filter->SetLowerThreshold(object.lower);
    filter->SetUpperThreshold(object.upper);
  }
  else if (definition == 2)
  {
    object.definition = ObjectType::DefinitionEnum::ISO_VALUE;
    object.isoValue = bytes.TakeNumber(-130.0, 130.0);
    filter->SetIsoValue(object.isoValue);
  }

  // A spacing is the least of all three; most deltas are near it, some much larger.
  const auto & spacing = image->GetSpacing();
  const double voxel = std::min({ spacing[0], spacing[1], spacing[2] });
  bool         isValid = true;
  if (!bytes.TakeRarely(64))
  {
    filter->SetDelta(voxel * (bytes.TakeRarely(8) ? bytes.TakeNumber(3.0, 40.0) : bytes.TakeNumber(0.9, 3.0)));
  }
  if (bytes.TakeRarely(6))
  {
    filter->SetRadiusEdgeRatioBound(bytes.TakeNumber(1.0, 4.0));
  }
  if (bytes.TakeRarely(6))
  {
    filter->SetCellSize(voxel * bytes.TakeNumber(0.9, 4.0));
  }
  if (bytes.TakeRarely(6))
  {
    filter->SetMinimumDihedralAngle(bytes.TakeNumber(0.5, 20.0));
    filter->SetPaperSlivers(bytes.TakeRarely(4));
  }
  if (bytes.TakeRarely(6))
  {
    filter->SetMinimumComponentSize(bytes.TakeByte() % 20u);
    filter->SetLargestComponentOnly(bytes.TakeRarely(2));
  }
  if (bytes.TakeRarely(32))
  {
    isValid = false;
    const std::array<double, 5> bad{ 0.0, -1.0, nan, std::numeric_limits<double>::infinity(), -0.0 };
    const double                value = bad[bytes.TakeByte() % bad.size()];
    switch (bytes.TakeByte() % 4)
    {
      case 0:
        filter->SetDelta(value);
        break;
      case 1:
        filter->SetRadiusEdgeRatioBound(value);
        break;
      case 2:
        filter->SetCellSize(std::isinf(value) ? nan : value);
        break;
      default:
        filter->SetMinimumDihedralAngle(value == 0.0 ? 60.0 : value);
    }
  }
  using InterpolatorType = typename DelaunayRefinementMeshFilter<ShortImageType, TMesh>::InterpolatorType;
  typename InterpolatorType::Pointer interpolator;
  if (bytes.TakeRarely(4))
  {
    interpolator = NearestNeighborInterpolateImageFunction<ShortImageType, double>::New();
  }
  else if (bytes.TakeRarely(8))
  {
    interpolator = BSplineInterpolateImageFunction<ShortImageType, double>::New();
  }
  if (interpolator)
  {
    filter->SetInterpolator(interpolator);
  }

  SCOPED_TRACE(DescribeFuzzCase(filter.GetPointer()));
  const std::string error = GetError(filter.GetPointer());
  if (!isValid)
  {
    EXPECT_NE(error.find("must be"), std::string::npos) << error;
    ++outcomes.refusedParameters;
    return;
  }
  object.minimumComponentSize = filter->GetMinimumComponentSize();
  object.largestComponentOnly = filter->GetLargestComponentOnly();
  const ImageDelaunayRefinementOracle<ShortImageType> oracle(image, object, interpolator);
  if (error.empty())
  {
    ExpectFuzzGuarantees(filter.GetPointer(), oracle);
    ++outcomes.meshed;
    outcomes.tetrahedra += filter->GetOutput()->GetNumberOfCells();
    return;
  }
  // Objects of a few voxels may be too thin, others may not.
  const auto components = oracle.ComputeComponents(0.0);
  EXPECT_TRUE(std::all_of(
    components.begin(), components.end(), [](const auto & component) { return component.numberOfVoxels < 8; }))
    << error;
  EXPECT_TRUE(error.find("There is no object") != std::string::npos || error.find("too thin") != std::string::npos)
    << error;
  ++outcomes.refusedObjects;
}

/** Points are stored as floats for one half of the inputs and as doubles for the other. */
inline void
MeshFuzzInput(const std::uint8_t * data, std::size_t size, FuzzOutcomes & outcomes)
{
  FuzzBytes bytes(data, size);
  if (bytes.TakeRarely(2))
  {
    MeshFuzzCase<DoubleMeshType>(bytes, outcomes);
  }
  else
  {
    MeshFuzzCase<FloatMeshType>(bytes, outcomes);
  }
}
} // end namespace itk::DelaunayRefinementTest

#endif
