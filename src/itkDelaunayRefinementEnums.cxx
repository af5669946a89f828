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
#include "itkDelaunayRefinementEnums.h"

namespace itk
{
std::ostream &
operator<<(std::ostream & out, const DelaunayRefinementEnums::VertexKind value)
{
  return out << [value] {
    switch (value)
    {
      case DelaunayRefinementEnums::VertexKind::BOX_EDGE:
        return "itk::DelaunayRefinementEnums::VertexKind::BOX_EDGE";
      case DelaunayRefinementEnums::VertexKind::BOX:
        return "itk::DelaunayRefinementEnums::VertexKind::BOX";
      case DelaunayRefinementEnums::VertexKind::FREE:
        return "itk::DelaunayRefinementEnums::VertexKind::FREE";
      case DelaunayRefinementEnums::VertexKind::FEATURE:
        return "itk::DelaunayRefinementEnums::VertexKind::FEATURE";
      default:
        return "INVALID VALUE FOR itk::DelaunayRefinementEnums::VertexKind";
    }
  }();
}

std::ostream &
operator<<(std::ostream & out, const DelaunayRefinementEnums::RefinementRule value)
{
  return out << [value] {
    switch (value)
    {
      case DelaunayRefinementEnums::RefinementRule::R1:
        return "itk::DelaunayRefinementEnums::RefinementRule::R1";
      case DelaunayRefinementEnums::RefinementRule::R2:
        return "itk::DelaunayRefinementEnums::RefinementRule::R2";
      case DelaunayRefinementEnums::RefinementRule::R3:
        return "itk::DelaunayRefinementEnums::RefinementRule::R3";
      case DelaunayRefinementEnums::RefinementRule::R4:
        return "itk::DelaunayRefinementEnums::RefinementRule::R4";
      case DelaunayRefinementEnums::RefinementRule::R4_PRIME:
        return "itk::DelaunayRefinementEnums::RefinementRule::R4_PRIME";
      case DelaunayRefinementEnums::RefinementRule::CELL_SIZE:
        return "itk::DelaunayRefinementEnums::RefinementRule::CELL_SIZE";
      case DelaunayRefinementEnums::RefinementRule::SHAPE:
        return "itk::DelaunayRefinementEnums::RefinementRule::SHAPE";
      case DelaunayRefinementEnums::RefinementRule::JUNCTION:
        return "itk::DelaunayRefinementEnums::RefinementRule::JUNCTION";
      case DelaunayRefinementEnums::RefinementRule::MANIFOLD:
        return "itk::DelaunayRefinementEnums::RefinementRule::MANIFOLD";
      case DelaunayRefinementEnums::RefinementRule::SLIVER:
        return "itk::DelaunayRefinementEnums::RefinementRule::SLIVER";
      default:
        return "INVALID VALUE FOR itk::DelaunayRefinementEnums::RefinementRule";
    }
  }();
}

std::ostream &
operator<<(std::ostream & out, const DelaunayRefinementEnums::EncroachmentCase value)
{
  return out << [value] {
    switch (value)
    {
      case DelaunayRefinementEnums::EncroachmentCase::NONE:
        return "itk::DelaunayRefinementEnums::EncroachmentCase::NONE";
      case DelaunayRefinementEnums::EncroachmentCase::E1:
        return "itk::DelaunayRefinementEnums::EncroachmentCase::E1";
      case DelaunayRefinementEnums::EncroachmentCase::E2:
        return "itk::DelaunayRefinementEnums::EncroachmentCase::E2";
      case DelaunayRefinementEnums::EncroachmentCase::E3:
        return "itk::DelaunayRefinementEnums::EncroachmentCase::E3";
      default:
        return "INVALID VALUE FOR itk::DelaunayRefinementEnums::EncroachmentCase";
    }
  }();
}

std::ostream &
operator<<(std::ostream & out, const DelaunayRefinementEnums::TerminationReason value)
{
  return out << [value] {
    switch (value)
    {
      case DelaunayRefinementEnums::TerminationReason::COMPLETED:
        return "itk::DelaunayRefinementEnums::TerminationReason::COMPLETED";
      case DelaunayRefinementEnums::TerminationReason::STOPPED_BY_CALLER:
        return "itk::DelaunayRefinementEnums::TerminationReason::STOPPED_BY_CALLER";
      case DelaunayRefinementEnums::TerminationReason::VERTEX_LIMIT:
        return "itk::DelaunayRefinementEnums::TerminationReason::VERTEX_LIMIT";
      case DelaunayRefinementEnums::TerminationReason::NO_SURFACE_FOUND:
        return "itk::DelaunayRefinementEnums::TerminationReason::NO_SURFACE_FOUND";
      default:
        return "INVALID VALUE FOR itk::DelaunayRefinementEnums::TerminationReason";
    }
  }();
}
} // end namespace itk
