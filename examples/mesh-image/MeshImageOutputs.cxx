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
#include "MeshImageOutputs.h"

#include "MeshImageTypes.h"

#include <algorithm>
#include <fstream>

#ifndef _WIN32
#  include <unistd.h>
#endif

namespace meshimage
{
namespace
{
namespace fs = std::filesystem;

bool
MayWriteTo(const fs::path & folder)
{
#ifdef _WIN32
  return fs::is_directory(folder);
#else
  return access(folder.c_str(), W_OK | X_OK) == 0;
#endif
}

/** Makes a folder of an unused name. */
fs::path
MakeHiddenFolder(const fs::path & parent, const std::string & purpose)
{
  constexpr int mostAttempts = 10000;
  for (int number = 0; number < mostAttempts; ++number)
  {
    const fs::path  folder = parent / (".mesh-image-" + std::to_string(number));
    std::error_code error;
    if (fs::create_directory(folder, error))
    {
      return folder;
    }
    if (error)
    {
      throw RunError(purpose + " cannot be written (" + error.message() + "): choose another folder or make room");
    }
  }
  throw RunError(purpose + " cannot be written: remove the folders .mesh-image-* from " + parent.string());
}
} // namespace

void
Outputs::Add(const std::string & target)
{
  std::error_code ignored;
  File            file;
  // What a link points to is replaced, not the link.
  file.target = fs::weakly_canonical(fs::absolute(target), ignored);
  if (file.target.empty())
  {
    file.target = fs::absolute(target);
  }
  const fs::path folder = file.target.parent_path();
  if (!fs::is_directory(folder, ignored))
  {
    throw RunError("There is no folder " + folder.string() + " for " + target + ": make it first");
  }
  if (!MayWriteTo(folder))
  {
    throw RunError("The folder " + folder.string() + " of " + target + " may not be written to: choose another");
  }
  if (fs::exists(file.target, ignored) && !fs::is_regular_file(file.target, ignored))
  {
    throw RunError(target + " is there and is no file: choose another name");
  }
  m_Files.push_back(file);
}

std::string
Outputs::GetDraft(const std::string & target)
{
  std::error_code                   ignored;
  const fs::path                    wanted = fs::weakly_canonical(fs::absolute(target), ignored);
  const std::lock_guard<std::mutex> lock(m_Mutex);
  this->RequireUnfinished();
  for (File & file : m_Files)
  {
    if (file.target == wanted)
    {
      const fs::path parent = file.target.parent_path();
      auto           folder = std::find_if(m_Folders.begin(), m_Folders.end(), [&parent](const fs::path & known) {
        return known.parent_path() == parent;
      });
      if (folder == m_Folders.end())
      {
        folder = m_Folders.insert(folder, MakeHiddenFolder(parent, target));
      }
      file.draft = *folder / file.target.filename();
      return file.draft.string();
    }
  }
  throw RunError(target + " is not among the outputs");
}

std::string
Outputs::NameTargets(std::string message) const
{
  for (const File & file : m_Files)
  {
    const std::string draft = file.draft.string();
    for (std::size_t at = draft.empty() ? std::string::npos : message.find(draft); at != std::string::npos;
         at = message.find(draft, at))
    {
      message.replace(at, draft.size(), file.target.string());
    }
  }
  return message;
}

void
Outputs::Commit()
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  this->RequireUnfinished();
  for (auto file = m_Files.begin(); file != m_Files.end(); ++file)
  {
    std::error_code error;
    fs::rename(file->draft, file->target, error);
    if (error)
    {
      std::error_code ignored;
      for (auto done = m_Files.begin(); done != file; ++done)
      {
        fs::remove(done->target, ignored);
      }
      throw RunError(file->target.string() + " cannot be written: " + error.message());
    }
  }
  m_Finished = true;
  this->RemoveFolders();
}

bool
Outputs::Discard()
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  if (m_Finished)
  {
    return false;
  }
  m_Finished = true;
  this->RemoveFolders();
  return true;
}

void
Outputs::RequireUnfinished() const
{
  if (m_Finished)
  {
    throw RunError("The outputs have been given up");
  }
}

void
Outputs::RemoveFolders()
{
  // Another thread may still be writing: once the folder itself is gone, nothing can be added.
  constexpr int mostAttempts = 1000;
  for (const fs::path & folder : m_Folders)
  {
    std::error_code error;
    for (int attempt = 0; attempt < mostAttempts; ++attempt)
    {
      fs::remove_all(folder, error);
      if (!fs::exists(folder, error))
      {
        break;
      }
    }
  }
}
} // namespace meshimage
