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
#include "itkWriteFileBeside.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#ifdef _WIN32
#  include <io.h>
#  include <process.h>
#else
#  include <unistd.h>
#endif

namespace itk
{
namespace
{
int
ProcessId()
{
#ifdef _WIN32
  return _getpid();
#else
  return static_cast<int>(getpid());
#endif
}

bool
FlushToDisk(std::FILE * stream)
{
  if (std::fflush(stream) != 0)
  {
    return false;
  }
#ifdef _WIN32
  return _commit(_fileno(stream)) == 0;
#else
  // Some file systems cannot, and say EINVAL.
  return fsync(fileno(stream)) == 0 || errno == EINVAL;
#endif
}

[[noreturn]] void
Fail(const std::string & fileName, int error)
{
  std::string advice;
  bool        full = error == ENOSPC;
#ifdef EDQUOT
  full = full || error == EDQUOT;
#endif
  if (full)
  {
    advice = ": make room or choose another folder";
  }
  else if (error == EACCES || error == EPERM || error == EROFS)
  {
    advice = ": choose a folder that you may write to";
  }
  throw std::runtime_error("The file " + fileName + " cannot be written (" + std::generic_category().message(error) +
                           ")" + advice);
}

/** \class TemporaryFile
 * \brief A file that is gone at the end unless it was renamed. */
class TemporaryFile
{
public:
  /** In the folder of the target: renaming works within one file system only. */
  explicit TemporaryFile(const std::filesystem::path & target)
  {
    for (int number = 0; m_Stream == nullptr; ++number)
    {
      const auto name = ".itk-mesh-" + std::to_string(ProcessId()) + "-" + std::to_string(number) + ".tmp";
      m_Path = target.parent_path() / name;
      m_Stream = std::fopen(m_Path.string().c_str(), "wbx");
      if (m_Stream == nullptr && errno != EEXIST)
      {
        Fail(target.string(), errno);
      }
    }
  }

  TemporaryFile(const TemporaryFile &) = delete;
  TemporaryFile &
  operator=(const TemporaryFile &) = delete;

  ~TemporaryFile()
  {
    this->Close();
    if (!m_Renamed)
    {
      std::error_code ignored;
      std::filesystem::remove(m_Path, ignored);
    }
  }

  bool
  Write(const char * bytes, std::size_t count)
  {
    return std::fwrite(bytes, 1, count, m_Stream) == count && FlushToDisk(m_Stream);
  }

  bool
  Close()
  {
    std::FILE * stream = m_Stream;
    m_Stream = nullptr;
    return stream == nullptr || std::fclose(stream) == 0;
  }

  void
  RenameTo(const std::filesystem::path & target)
  {
    std::error_code error;
    std::filesystem::rename(m_Path, target, error);
    if (error)
    {
      Fail(target.string(), error.value());
    }
    m_Renamed = true;
  }

private:
  std::filesystem::path m_Path;
  std::FILE *           m_Stream{ nullptr };
  bool                  m_Renamed{ false };
};
} // namespace

bool
WriteFileBeside(const std::string & fileName, const std::string & bytes, const std::function<bool(double)> & progress)
{
  // Small enough for a stop between two chunks to feel immediate, also when each goes to a slow disk.
  constexpr std::size_t chunkSize = std::size_t{ 16 } << 20;

  // What a link points to is replaced, not the link.
  std::error_code             ignored;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(fileName, ignored);
  const std::filesystem::path target = canonical.empty() ? std::filesystem::path(fileName) : canonical;
  const std::filesystem::path folder = target.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
  {
    throw std::runtime_error("The file " + fileName + " cannot be written: there is no folder " + folder.string());
  }
  // A device or a folder of that name would be replaced.
  if (std::filesystem::exists(target, ignored) && !std::filesystem::is_regular_file(target, ignored))
  {
    throw std::runtime_error("The file " + fileName + " cannot be written: there is something else of that name");
  }

  TemporaryFile file(target);
  for (std::size_t done = 0; done < bytes.size();)
  {
    if (progress && !progress(static_cast<double>(done) / static_cast<double>(bytes.size())))
    {
      return false;
    }
    const std::size_t count = std::min(chunkSize, bytes.size() - done);
    if (!file.Write(bytes.data() + done, count))
    {
      Fail(fileName, errno);
    }
    done += count;
  }
  if (!file.Close())
  {
    Fail(fileName, errno);
  }
  file.RenameTo(target);
  return true;
}
} // end namespace itk
