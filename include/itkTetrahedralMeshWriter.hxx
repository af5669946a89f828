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
#ifndef itkTetrahedralMeshWriter_hxx
#define itkTetrahedralMeshWriter_hxx

#include "itkTetrahedralMeshWriter.h"

#include "itkCommonEnums.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace itk
{
template <typename TMesh>
TetrahedralMeshWriter<TMesh>::TetrahedralMeshWriter()
{
  this->SetNumberOfRequiredInputs(1);
}

template <typename TMesh>
void
TetrahedralMeshWriter<TMesh>::SetInput(const MeshType * mesh)
{
  // The pipeline keeps its inputs non-const; the writer never changes them.
  this->ProcessObject::SetNthInput(0, const_cast<MeshType *>(mesh));
}

template <typename TMesh>
auto
TetrahedralMeshWriter<TMesh>::GetInput() -> const MeshType *
{
  return this->GetMesh();
}

template <typename TMesh>
void
TetrahedralMeshWriter<TMesh>::Write()
{
  auto * input = const_cast<MeshType *>(this->GetMesh());
  if (input == nullptr)
  {
    itkExceptionMacro("The writer has no mesh: call SetInput first");
  }
  if (m_FileName.empty())
  {
    itkExceptionMacro("The writer has no file name: call SetFileName first");
  }
  input->Update();

  this->SetAbortGenerateData(false);
  this->UpdateProgress(0.0F);
  this->InvokeEvent(StartEvent());
  try
  {
    this->GenerateData();
  }
  catch (const ProcessAborted &)
  {
    this->InvokeEvent(AbortEvent());
    this->ResetPipeline();
    throw;
  }
  catch (...)
  {
    this->ResetPipeline();
    throw;
  }
  this->UpdateProgress(1.0F);
  this->InvokeEvent(EndEvent());
  this->ReleaseInputs();
}

template <typename TMesh>
void
TetrahedralMeshWriter<TMesh>::GenerateData()
{
  TetrahedralMeshFileContent content;
  this->FlattenPointsAndCells(content);
  this->FlattenLabels(content);

  const auto progress = [this](double share) {
    this->UpdateProgress(static_cast<float>(share));
    return !this->GetAbortGenerateData();
  };
  if (!TetrahedralMeshFile::Write(m_FileName, content, progress))
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }
}

template <typename TMesh>
void
TetrahedralMeshWriter<TMesh>::FlattenPointsAndCells(TetrahedralMeshFileContent & content) const
{
  const MeshType * mesh = this->GetMesh();
  const auto *     points = mesh->GetPoints();
  const auto *     cells = mesh->GetCells();
  if (points == nullptr || cells == nullptr || cells->Size() == 0)
  {
    itkExceptionMacro("The mesh has no cells: there is nothing to write to " << m_FileName);
  }

  // Ascending, but with gaps in containers that are maps.
  std::vector<IdentifierType> pointIds;
  pointIds.reserve(points->Size());
  content.points.reserve(3 * points->Size());
  for (auto point = points->Begin(); point != points->End(); ++point)
  {
    pointIds.push_back(point.Index());
    for (unsigned int i = 0; i < 3; ++i)
    {
      content.points.push_back(point.Value()[i]);
    }
  }
  const auto indexOf = [this, &pointIds](IdentifierType id) {
    if (id < pointIds.size() && pointIds[id] == id)
    {
      return static_cast<std::int64_t>(id);
    }
    const auto found = std::lower_bound(pointIds.begin(), pointIds.end(), id);
    if (found == pointIds.end() || *found != id)
    {
      itkExceptionMacro("A cell of the mesh uses point " << id << ", which the mesh does not have");
    }
    return static_cast<std::int64_t>(found - pointIds.begin());
  };

  const auto kind = cells->Begin().Value()->GetType();
  if (kind != CellGeometryEnum::TETRAHEDRON_CELL && kind != CellGeometryEnum::TRIANGLE_CELL)
  {
    itkExceptionMacro("Only meshes of tetrahedra or of triangles can be written; this one has other cells");
  }
  content.pointsPerCell = kind == CellGeometryEnum::TETRAHEDRON_CELL ? 4 : 3;
  content.cells.reserve(content.pointsPerCell * cells->Size());
  for (auto cell = cells->Begin(); cell != cells->End(); ++cell)
  {
    if (cell.Value()->GetType() != kind)
    {
      itkExceptionMacro(
        "Only meshes of tetrahedra or of triangles can be written; this one has cells of several kinds");
    }
    std::transform(
      cell.Value()->PointIdsBegin(), cell.Value()->PointIdsEnd(), std::back_inserter(content.cells), indexOf);
  }
}

template <typename TMesh>
void
TetrahedralMeshWriter<TMesh>::FlattenLabels(TetrahedralMeshFileContent & content) const
{
  using ValueType = typename MeshType::CellPixelType;
  if constexpr (std::is_arithmetic_v<ValueType>)
  {
    const MeshType * mesh = this->GetMesh();
    const auto *     cellData = mesh->GetCellData();
    if (cellData == nullptr || cellData->Size() == 0)
    {
      return;
    }
    using IntegerType = std::conditional_t<std::is_floating_point_v<ValueType>, std::int64_t, ValueType>;
    std::vector<IntegerType> values;
    values.reserve(mesh->GetCells()->Size());
    for (auto cell = mesh->GetCells()->Begin(); cell != mesh->GetCells()->End(); ++cell)
    {
      ValueType value{};
      if (!cellData->GetElementIfIndexExists(cell.Index(), &value))
      {
        itkExceptionMacro("The mesh has cell data for some cells only: give each cell its value, or none");
      }
      if constexpr (std::is_floating_point_v<ValueType>)
      {
        if (!(value >= -0x1p63 && value < 0x1p63) || std::trunc(value) != value)
        {
          itkExceptionMacro("The cell data of the mesh are labels and must be whole numbers; " << value << " is none");
        }
      }
      values.push_back(static_cast<IntegerType>(value));
    }

    // 32 bits where they suffice: finite-element codes take no other tags, and all readers know them.
    const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
    const auto fits = [low = *smallest, high = *largest](auto type) {
      using LimitsType = std::numeric_limits<decltype(type)>;
      if constexpr (std::is_signed_v<IntegerType>)
      {
        return static_cast<std::int64_t>(low) >= LimitsType::min() &&
               static_cast<std::int64_t>(high) <= LimitsType::max();
      }
      else
      {
        return static_cast<std::uint64_t>(high) <= static_cast<std::uint64_t>(LimitsType::max());
      }
    };
    if (fits(std::int32_t{}))
    {
      content.labels = std::vector<std::int32_t>(values.begin(), values.end());
    }
    else if (fits(std::int64_t{}))
    {
      content.labels = std::vector<std::int64_t>(values.begin(), values.end());
    }
    else
    {
      content.labels = std::vector<std::uint64_t>(values.begin(), values.end());
    }
  }
}

template <typename TMesh>
auto
TetrahedralMeshWriter<TMesh>::GetMesh() const -> const MeshType *
{
  return static_cast<const MeshType *>(this->GetPrimaryInput());
}

template <typename TMesh>
void
TetrahedralMeshWriter<TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << std::endl;
}
} // end namespace itk

#endif
