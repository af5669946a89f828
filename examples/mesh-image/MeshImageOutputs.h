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
#ifndef MeshImageOutputs_h
#define MeshImageOutputs_h

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace meshimage
{
/** \class Outputs
 * \brief The files that a run writes: all of them appear at once in the end, or none. Until then they are kept in
 * folders of their own beside their targets, until Commit or Discard is called. */
class Outputs
{
public:
  Outputs() = default;
  Outputs(const Outputs &) = delete;
  Outputs &
  operator=(const Outputs &) = delete;

  /** Registers a file. Throws a RunError if its folder is missing or cannot be written to. */
  void
  Add(const std::string & target);

  /** Where to write a registered file for now. */
  std::string
  GetDraft(const std::string & target);

  /** A message about a draft, with the name of the target. */
  std::string
  NameTargets(std::string message) const;

  /** Moves all drafts to their targets. */
  void
  Commit();

  /** Removes the drafts for good; false if they have been committed. May be called by another thread, after which
   * nothing can be written or committed any more. */
  bool
  Discard();

private:
  struct File
  {
    std::filesystem::path target;
    std::filesystem::path draft;
  };

  void
  RequireUnfinished() const;

  void
  RemoveFolders();

  std::mutex                         m_Mutex;
  std::vector<File>                  m_Files;
  std::vector<std::filesystem::path> m_Folders;
  bool                               m_Finished{ false };
};
} // namespace meshimage

#endif
