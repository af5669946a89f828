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
#ifndef itkTetrahedralMeshWriter_h
#define itkTetrahedralMeshWriter_h

#include "itkProcessObject.h"
#include "itkTetrahedralMeshFile.h"

#include <string>

namespace itk
{
/** \class TetrahedralMeshWriter
 * \brief Writes an itk::Mesh of tetrahedra, or of triangles, for ParaView, VTK, meshio and others.
 *
 * The extension of FileName chooses the format, upper or lower case:
 * - tetrahedra: .vtu (binary, compressed) or .vtk (legacy, binary);
 * - triangles: .vtp (binary, compressed), .vtk (legacy, binary), .stl or .ply (binary).
 *
 * Points keep the order of the mesh and are written in double precision, in .stl and .ply in single precision. Cell
 * data that are whole numbers are written as an array of integers named \c label; .stl and .ply hold none. The same
 * mesh gives the same bytes.
 *
 * The file is written under another name in the same folder and renamed when it is complete: a failure or an abort
 * (AbortGenerateData) leaves nothing behind, and a file of that name as it was.
 *
 * \par Errors
 * An ExceptionObject says what to change: an extension of an unknown kind or not for these cells, a mesh without cells
 * or with other cells, a folder that is missing or may not be written to, a full disk. An abort ends in ProcessAborted.
 *
 * \ingroup DelaunayRefinement
 */
template <typename TMesh>
class ITK_TEMPLATE_EXPORT TetrahedralMeshWriter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TetrahedralMeshWriter);

  /** Standard class type aliases. */
  /** @ITKStartGrouping */
  using Self = TetrahedralMeshWriter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  /** @ITKEndGrouping */

  /** Method for creation through the object factory. */
  itkNewMacro(Self);

  /** Run-time type information. */
  itkTypeMacro(TetrahedralMeshWriter, ProcessObject);

  /** A mesh of any traits; its cell data are numbers if they are to be written. */
  using MeshType = TMesh;

  using Superclass::SetInput;

  /** The mesh to be written. None by default: Update() throws. */
  /** @ITKStartGrouping */
  void
  SetInput(const MeshType * mesh);
  const MeshType *
  GetInput();
  /** @ITKEndGrouping */

  /** Name of the file, with a known extension. Empty by default: Update() throws. */
  /** @ITKStartGrouping */
  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);
  /** @ITKEndGrouping */

  /** Brings the mesh up to date and writes it. */
  /** @ITKStartGrouping */
  void
  Write();

  void
  Update() override
  {
    this->Write();
  }

  void
  UpdateLargestPossibleRegion() override
  {
    this->Write();
  }
  /** @ITKEndGrouping */

protected:
  TetrahedralMeshWriter();
  ~TetrahedralMeshWriter() override = default;

  /** Prints all parameters. */
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  /** Flattens the mesh and writes it. */
  void
  GenerateData() override;

private:
  void
  FlattenPointsAndCells(TetrahedralMeshFileContent & content) const;

  void
  FlattenLabels(TetrahedralMeshFileContent & content) const;

  const MeshType *
  GetMesh() const;

  std::string m_FileName{};
};
} // end namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkTetrahedralMeshWriter.hxx"
#endif

#endif
