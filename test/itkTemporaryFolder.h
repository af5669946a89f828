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
#ifndef itkTemporaryFolder_h
#define itkTemporaryFolder_h

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace itk::DelaunayRefinementTest
{
/** \class TemporaryFolder
 * \brief A folder that is gone at the end of a test. */
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    static std::atomic<unsigned int> counter{ 0 };
    const auto                       ticks = std::chrono::steady_clock::now().time_since_epoch().count();
    m_Path =
      std::filesystem::temp_directory_path() / ("mesh-test-" + std::to_string(ticks) + "-" + std::to_string(counter++));
    std::filesystem::create_directories(m_Path);
  }

  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &
  operator=(const TemporaryFolder &) = delete;

  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_Path, ignored);
  }

  std::string
  operator/(const std::string & name) const
  {
    return (m_Path / name).string();
  }

  /** Names of all that lies in it. */
  std::set<std::string>
  List() const
  {
    std::set<std::string> names;
    for (const auto & entry : std::filesystem::directory_iterator(m_Path))
    {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

private:
  std::filesystem::path m_Path;
};

inline std::string
ReadBytes(const std::string & fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

inline void
WriteBytes(const std::string & fileName, const std::string & bytes)
{
  std::ofstream(fileName, std::ios::binary) << bytes;
}
} // end namespace itk::DelaunayRefinementTest

#endif
