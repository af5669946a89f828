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
#include "itkDelaunayRefinementMeshFilter.h"
#include "itkImageDelaunayRefinementOracle.h"

#include "itkFilterRun.h"

#include "itkImageFileReader.h"
#include "itkNiftiImageIO.h"
#include "itksys/SystemTools.hxx"

using namespace itk::DelaunayRefinementTest;

namespace
{
/** \class DelaunayRefinementBrain
 * \brief The Colin27 brain of Debian's package mricron-data; the object is what is not 0. */
class DelaunayRefinementBrain : public ::testing::Test
{
protected:
  void
  SetUp() override
  {
    const std::string fileName = "/usr/share/mricron/templates/ch2bet.nii.gz";
    if (!itksys::SystemTools::FileExists(fileName))
    {
      GTEST_SKIP() << fileName << " is not there";
    }
    const auto reader = itk::ImageFileReader<ShortImageType>::New();
    reader->SetImageIO(itk::NiftiImageIO::New());
    reader->SetFileName(fileName);
    reader->Update();
    m_Image = reader->GetOutput();
  }

  /** The mesh at a delta, with all that is guaranteed. */
  CheckedMesh
  MeshAt(double delta, double minimumDihedralAngle = 0.0)
  {
    const auto filter = MakeFilter(m_Image.GetPointer(), delta);
    filter->SetLowerThreshold(1.0);
    filter->SetMinimumDihedralAngle(minimumDihedralAngle);
    filter->Update();
    const CheckedMesh mesh = GetMesh(filter.GetPointer());
    ExpectGuarantees(mesh);
    ExpectLabel(mesh, 1.0);
    constexpr std::size_t leastSize = 8;
    for (const std::uint32_t missing : filter->GetStatistics().missingComponents)
    {
      EXPECT_LT(filter->GetComponents()[missing].numberOfVoxels, leastSize);
    }
    EXPECT_NEAR(ComputeEnclosedVolume(mesh) / ComputeVolume(mesh), 1.0, 1e-6);
    return mesh;
  }

  ShortImageType::Pointer m_Image{};
};
} // namespace

TEST_F(DelaunayRefinementBrain, CoarseMesh)
{
  const CheckedMesh mesh = MeshAt(6.0);
  // The paper's mesh of its own brain has 5,589 tetrahedra.
  EXPECT_GT(mesh.tetrahedra.size(), 2000u);
  EXPECT_LT(mesh.tetrahedra.size(), 20000u);
  EXPECT_NEAR(ComputeVolume(mesh) / ComputeVoxelVolume(m_Image.GetPointer()), 1.0, 0.05);
}

TEST_F(DelaunayRefinementBrain, FineMesh)
{
  const CheckedMesh mesh = MeshAt(3.0);
  // The paper's mesh of its own brain has 27,333 tetrahedra.
  EXPECT_GT(mesh.tetrahedra.size(), 15000u);
  EXPECT_LT(mesh.tetrahedra.size(), 80000u);
  EXPECT_NEAR(ComputeVolume(mesh) / ComputeVoxelVolume(m_Image.GetPointer()), 1.0, 0.02);
}

TEST_F(DelaunayRefinementBrain, MeshWithoutSlivers)
{
  const double plain = ComputeDihedralAngles(MeshAt(6.0)).minimum;
  EXPECT_LT(plain, 5.0);
  const CheckedMesh mended = MeshAt(6.0, 15.0);
  EXPECT_GE(ComputeDihedralAngles(mended).minimum, 15.0);
  ExpectManifoldBoundary(mended);
  // With slivers between vertices of a cleft that is closed in the mesh.
  EXPECT_GE(ComputeDihedralAngles(MeshAt(2.0, 12.0)).minimum, 12.0);
}

TEST_F(DelaunayRefinementBrain, NoRuleFiresAnyMore)
{
  using OracleType = itk::ImageDelaunayRefinementOracle<ShortImageType>;
  itk::DelaunayRefinementObject<short> object;
  object.lower = 1.0;
  object.definition = itk::DelaunayRefinementObject<short>::DefinitionEnum::THRESHOLD;
  object.largestComponentOnly = true;
  const OracleType oracle(m_Image, object);
  for (const auto & [refineOutside, minimumDihedralAngle] :
       { std::pair{ false, 0.0 }, std::pair{ true, 0.0 }, std::pair{ false, 18.0 }, std::pair{ true, 12.0 } })
  {
    itk::DelaunayRefinementParameters parameters;
    parameters.delta = 6.0;
    parameters.refineOutside = refineOutside;
    parameters.minimumDihedralAngle = minimumDihedralAngle;
    itk::DelaunayRefinementEngine engine(oracle, parameters);
    ASSERT_EQ(engine.Run(), itk::DelaunayRefinementEnums::TerminationReason::COMPLETED);
    for (const std::size_t number : engine.CountFiringRules())
    {
      EXPECT_EQ(number, 0u);
    }
  }
}
