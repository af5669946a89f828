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
#ifndef itkDelaunayRefinementCellsContainer_h
#define itkDelaunayRefinementCellsContainer_h

#include "itkMesh.h"
#include "itkObjectFactory.h"

#include <memory>
#include <new>
#include <vector>

namespace itk
{
/** \class DelaunayRefinementCellsContainer
 * \brief A mesh's cells in large pieces of memory that belong to their container.
 *
 * A mesh takes a piece of memory for each cell otherwise, which takes longer than to fill them. Pieces are short enough
 * to go where shorter arrays were, in memory that is in use already. To the mesh nothing differs: it deletes cells one
 * by one (CellsAllocatedDynamicallyCellByCell), those that were added later too, and may share the container with other
 * meshes. Cells are not to be used after their container is gone.
 *
 * \ingroup DelaunayRefinement
 */
template <typename TMesh>
class DelaunayRefinementCellsContainer : public TMesh::CellsContainer
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DelaunayRefinementCellsContainer);

  /** Standard class type aliases. */
  using Self = DelaunayRefinementCellsContainer;
  /** Standard class type aliases. */
  using Superclass = typename TMesh::CellsContainer;
  /** Standard class type aliases. */
  using Pointer = SmartPointer<Self>;
  /** Standard class type aliases. */
  using ConstPointer = SmartPointer<const Self>;

  /** Standard New method. */
  itkNewMacro(Self);
  /** Standard part of all ITK objects. */
  itkTypeMacro(DelaunayRefinementCellsContainer, VectorContainer);

  /** Makes room for cells of a type, all of them null so far. Once, while the container is empty. Throws std::bad_alloc
   * if there is no room. */
  template <typename TCell>
  void
  Allocate(std::size_t numberOfCells)
  {
    m_Pieces.resize((numberOfCells + CellsPerPiece - 1) / CellsPerPiece);
    for (auto & piece : m_Pieces)
    {
      piece.reset(::operator new(CellsPerPiece * sizeof(CellInPlaceType<TCell>)));
    }
    this->CastToSTLContainer().resize(numberOfCells, nullptr);
  }

  /** Makes a cell, and returns it. Threads may make several at a time. */
  template <typename TCell>
  TCell *
  MakeCell(std::size_t number)
  {
    char * const piece = static_cast<char *>(m_Pieces[number / CellsPerPiece].get());
    auto * const cell = ::new (piece + number % CellsPerPiece * sizeof(CellInPlaceType<TCell>)) CellInPlaceType<TCell>;
    this->CastToSTLContainer()[number] = cell;
    return cell;
  }

protected:
  DelaunayRefinementCellsContainer() = default;

  ~DelaunayRefinementCellsContainer() override = default;

private:
  static constexpr std::size_t CellsPerPiece = 1024;

  // Its memory stays where it is when it is deleted.
  template <typename TCell>
  class CellInPlaceType final : public TCell
  {
  public:
    static void *
    operator new(std::size_t) = delete;

    static void
    operator delete(void *)
    {}
  };

  struct ReleaseType
  {
    void
    operator()(void * memory) const
    {
      ::operator delete(memory);
    }
  };

  std::vector<std::unique_ptr<void, ReleaseType>> m_Pieces{};
};
} // end namespace itk

#endif
