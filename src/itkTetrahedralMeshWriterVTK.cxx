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
#include "itkTetrahedralMeshWriterVTK.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeUInt64Array.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <stdexcept>

namespace itk
{
namespace
{
/** Lends the memory of \c values to a VTK array, which must not outlive it and will not write to it. */
template <typename TArray, typename TValue>
void
Lend(TArray * array, const std::vector<TValue> & values)
{
  static_assert(sizeof(typename TArray::ValueType) == sizeof(TValue), "The array holds other values");
  constexpr int keep = 1;
  array->SetArray(reinterpret_cast<typename TArray::ValueType *>(const_cast<TValue *>(values.data())),
                  static_cast<vtkIdType>(values.size()),
                  keep);
}

/** \class SharedArrays
 * \brief Arrays that VTK's data sets share. */
class SharedArrays
{
public:
  explicit SharedArrays(const TetrahedralMeshFileContent & content)
  {
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    Lend(coordinates.Get(), content.points);
    m_Points->SetData(coordinates);

    const std::size_t step = content.pointsPerCell;
    m_OffsetValues.resize(content.cells.size() / step + 1);
    for (std::size_t i = 0; i < m_OffsetValues.size(); ++i)
    {
      m_OffsetValues[i] = static_cast<std::int64_t>(i * step);
    }
    vtkNew<vtkTypeInt64Array> offsets;
    Lend(offsets.Get(), m_OffsetValues);
    vtkNew<vtkTypeInt64Array> connectivity;
    Lend(connectivity.Get(), content.cells);
    m_Cells->SetData(offsets, connectivity);

    std::visit([this](const auto & labels) { this->AddLabels(labels); }, content.labels);
  }

  vtkSmartPointer<vtkUnstructuredGrid>
  MakeGrid() const
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(m_Points);
    grid->SetCells(VTK_TETRA, m_Cells);
    this->Finish(grid);
    return grid;
  }

  vtkSmartPointer<vtkPolyData>
  MakePolyData() const
  {
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(m_Points);
    surface->SetPolys(m_Cells);
    this->Finish(surface);
    return surface;
  }

private:
  void
  AddLabels(std::monostate)
  {}

  void
  AddLabels(const std::vector<std::int32_t> & labels)
  {
    this->AddLabelArray(vtkSmartPointer<vtkTypeInt32Array>::New(), labels);
  }

  void
  AddLabels(const std::vector<std::int64_t> & labels)
  {
    this->AddLabelArray(vtkSmartPointer<vtkTypeInt64Array>::New(), labels);
  }

  void
  AddLabels(const std::vector<std::uint64_t> & labels)
  {
    this->AddLabelArray(vtkSmartPointer<vtkTypeUInt64Array>::New(), labels);
  }

  template <typename TArray, typename TValue>
  void
  AddLabelArray(const vtkSmartPointer<TArray> & array, const std::vector<TValue> & labels)
  {
    array->SetName("label");
    Lend(array.Get(), labels);
    m_Labels = array;
  }

  void
  Finish(vtkDataSet * data) const
  {
    if (m_Labels != nullptr)
    {
      data->GetCellData()->SetScalars(m_Labels);
    }
  }

  vtkNew<vtkPoints>             m_Points;
  vtkNew<vtkCellArray>          m_Cells;
  std::vector<std::int64_t>     m_OffsetValues;
  vtkSmartPointer<vtkDataArray> m_Labels;
};

/** \class WriterObserver
 * \brief Collects errors, which VTK would print, and passes progress on. */
class WriterObserver : public vtkCommand
{
public:
  static WriterObserver *
  New()
  {
    return new WriterObserver;
  }

  void
  Execute(vtkObject * caller, unsigned long event, void * data) override
  {
    if (event == vtkCommand::ProgressEvent)
    {
      // The other half of the work is writing the bytes to the file.
      if (m_Progress && !m_Progress(0.5 * *static_cast<double *>(data)))
      {
        m_Stopped = true;
        vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
      }
    }
    else if (event == vtkCommand::ErrorEvent)
    {
      m_Errors += static_cast<const char *>(data);
    }
  }

  TetrahedralMeshFile::ProgressType m_Progress;
  std::string                       m_Errors;
  bool                              m_Stopped{ false };
};

template <typename TWriter>
bool
RunWriter(TWriter * writer, vtkDataObject * data, const TetrahedralMeshFile::ProgressType & progress)
{
  vtkNew<WriterObserver> observer;
  observer->m_Progress = progress;
  writer->AddObserver(vtkCommand::ErrorEvent, observer);
  writer->AddObserver(vtkCommand::ProgressEvent, observer);
  writer->SetInputDataObject(data);
  writer->SetWriteToOutputString(true);
  const bool written = writer->Write() != 0;
  if (observer->m_Stopped)
  {
    return false;
  }
  if (!written || writer->GetErrorCode() != 0 || !observer->m_Errors.empty())
  {
    throw std::runtime_error(observer->m_Errors.empty() ? "VTK failed to compose the file" : observer->m_Errors);
  }
  return true;
}

template <typename TWriter>
std::optional<std::string>
ComposeXML(vtkDataObject * data, const TetrahedralMeshFile::ProgressType & progress)
{
  vtkNew<TWriter> writer;
  writer->SetDataModeToAppended();
  writer->SetCompressorTypeToZLib();
  // Higher levels take three times as long for files 5 % smaller.
  writer->SetCompressionLevel(1);
  return RunWriter(writer.Get(), data, progress) ? std::optional(writer->GetOutputString()) : std::nullopt;
}

template <typename TWriter>
std::optional<std::string>
ComposeLegacy(vtkDataObject * data, bool longLabels, const TetrahedralMeshFile::ProgressType & progress)
{
  vtkNew<TWriter> writer;
  writer->SetFileTypeToBinary();
  // Version 4.2 is what most readers know; they know 64-bit integers from version 5.1 on.
  writer->SetFileVersion(longLabels ? TWriter::VTK_LEGACY_READER_VERSION_5_1 : TWriter::VTK_LEGACY_READER_VERSION_4_2);
  writer->SetHeader("Mesh of itk::DelaunayRefinementMeshFilter");
  return RunWriter(writer.Get(), data, progress) ? std::optional(writer->GetOutputStdString()) : std::nullopt;
}
} // namespace

std::optional<std::string>
ComposeVTKFile(TetrahedralMeshVTKFormat                  format,
               const TetrahedralMeshFileContent &        content,
               const TetrahedralMeshFile::ProgressType & progress)
{
  const SharedArrays arrays(content);
  const bool         tetrahedra = content.pointsPerCell == 4;
  if (format == TetrahedralMeshVTKFormat::XML)
  {
    return tetrahedra ? ComposeXML<vtkXMLUnstructuredGridWriter>(arrays.MakeGrid(), progress)
                      : ComposeXML<vtkXMLPolyDataWriter>(arrays.MakePolyData(), progress);
  }
  const bool longLabels = std::holds_alternative<std::vector<std::int64_t>>(content.labels) ||
                          std::holds_alternative<std::vector<std::uint64_t>>(content.labels);
  return tetrahedra ? ComposeLegacy<vtkUnstructuredGridWriter>(arrays.MakeGrid(), longLabels, progress)
                    : ComposeLegacy<vtkPolyDataWriter>(arrays.MakePolyData(), longLabels, progress);
}
} // end namespace itk
