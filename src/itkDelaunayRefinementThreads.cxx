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
#include "itkDelaunayRefinementThreads.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace itk
{
namespace
{
/** For so long threads that have nothing to do look for more before they sleep. */
constexpr std::chrono::microseconds TimeAwake{ 200 };
} // namespace

/** \class DelaunayRefinementThreads::Impl
 * \brief The threads, and the task they are at. */
class DelaunayRefinementThreads::Impl
{
public:
  explicit Impl(unsigned int numberOfThreads)
  {
    try
    {
      while (m_Workers.size() + 1 < numberOfThreads)
      {
        m_Workers.emplace_back(&Impl::Work, this, static_cast<unsigned int>(m_Workers.size() + 1));
      }
    }
    catch (const std::system_error &)
    {
      // Those there are will do.
    }
  }

  ~Impl()
  {
    this->StartRound(true);
    for (std::thread & worker : m_Workers)
    {
      worker.join();
    }
  }

  unsigned int
  GetNumberOfThreads() const
  {
    return static_cast<unsigned int>(m_Workers.size() + 1);
  }

  void
  Run(std::size_t numberOfItems, const TaskType & task)
  {
    m_Task = &task;
    m_NumberOfItems = numberOfItems;
    m_NextItem.store(0, std::memory_order_relaxed);
    m_Failure = nullptr;
    const bool isShared = !m_Workers.empty() && numberOfItems > 1;
    if (isShared)
    {
      m_NumberAtWork.store(m_Workers.size(), std::memory_order_relaxed);
      this->StartRound(false);
    }
    this->TakeItems(0);
    while (isShared && m_NumberAtWork.load(std::memory_order_acquire) > 0)
    {
      std::this_thread::yield();
    }
    if (m_Failure != nullptr)
    {
      std::rethrow_exception(m_Failure);
    }
  }

private:
  void
  StartRound(bool isLast)
  {
    {
      const std::lock_guard<std::mutex> lock(m_Mutex);
      m_IsOver = isLast;
      m_Round.fetch_add(1, std::memory_order_release);
    }
    m_Wake.notify_all();
  }

  void
  Work(unsigned int thread)
  {
    std::uint64_t round = 0;
    while (true)
    {
      const auto sleepAt = std::chrono::steady_clock::now() + TimeAwake;
      while (m_Round.load(std::memory_order_acquire) == round && std::chrono::steady_clock::now() < sleepAt)
      {
        std::this_thread::yield();
      }
      if (m_Round.load(std::memory_order_acquire) == round)
      {
        std::unique_lock<std::mutex> lock(m_Mutex);
        m_Wake.wait(lock, [&] { return m_Round.load(std::memory_order_acquire) != round; });
      }
      ++round;
      if (m_IsOver)
      {
        return;
      }
      this->TakeItems(thread);
      m_NumberAtWork.fetch_sub(1, std::memory_order_release);
    }
  }

  void
  TakeItems(unsigned int thread)
  {
    while (true)
    {
      const std::size_t item = m_NextItem.fetch_add(1, std::memory_order_relaxed);
      if (item >= m_NumberOfItems)
      {
        return;
      }
      try
      {
        (*m_Task)(item, thread);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(m_Mutex);
        if (m_Failure == nullptr || item < m_FailedItem)
        {
          m_Failure = std::current_exception();
          m_FailedItem = item;
        }
      }
    }
  }

  std::vector<std::thread>   m_Workers{};
  std::mutex                 m_Mutex{};
  std::condition_variable    m_Wake{};
  std::atomic<std::uint64_t> m_Round{ 0 };
  std::atomic<std::size_t>   m_NumberAtWork{ 0 };
  std::atomic<std::size_t>   m_NextItem{ 0 };

  // Of the round; written between rounds only, and under the mutex.
  bool               m_IsOver{ false };
  const TaskType *   m_Task{ nullptr };
  std::size_t        m_NumberOfItems{ 0 };
  std::exception_ptr m_Failure{};
  std::size_t        m_FailedItem{ 0 };
};

DelaunayRefinementThreads::DelaunayRefinementThreads(unsigned int numberOfThreads)
  : m_Impl(std::make_unique<Impl>(numberOfThreads))
{}

DelaunayRefinementThreads::~DelaunayRefinementThreads() = default;

unsigned int
DelaunayRefinementThreads::GetNumberOfThreads() const
{
  return m_Impl->GetNumberOfThreads();
}

void
DelaunayRefinementThreads::Run(std::size_t numberOfItems, const TaskType & task)
{
  m_Impl->Run(numberOfItems, task);
}

void
DelaunayRefinementThreads::RunPieces(DelaunayRefinementThreads * threads,
                                     std::size_t                 size,
                                     std::size_t                 length,
                                     const PieceTaskType &       task)
{
  const std::size_t numberOfPieces = CountPieces(size, length);
  const auto        runPiece = [&](std::size_t piece, unsigned int) {
    task(piece, piece * length, std::min(size, (piece + 1) * length));
  };
  if (threads != nullptr)
  {
    threads->Run(numberOfPieces, runPiece);
    return;
  }
  for (std::size_t piece = 0; piece < numberOfPieces; ++piece)
  {
    runPiece(piece, 0);
  }
}

std::size_t
DelaunayRefinementThreads::ChoosePieceLength(const DelaunayRefinementThreads * threads,
                                             std::size_t                       size,
                                             std::size_t                       least)
{
  // Some more than threads, as some threads are slower than others.
  constexpr std::size_t piecesPerThread = 4;
  const std::size_t     numberOfThreads = threads == nullptr ? 1 : threads->GetNumberOfThreads();
  const std::size_t     numberOfPieces = numberOfThreads == 1 ? 1 : piecesPerThread * numberOfThreads;
  return std::max({ CountPieces(size, numberOfPieces), least, std::size_t{ 1 } });
}
} // end namespace itk
