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
 * \brief The threads, and the task they are at.
 *
 * Threads take items by a ticket: the number of the task, and that of the next item. A task is over once all of its
 * items are done; threads that were asleep all the while are not waited for. */
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
    m_IsOver.store(true);
    this->WakeAll();
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
    if (m_Workers.empty() || numberOfItems < 2)
    {
      for (std::size_t item = 0; item < numberOfItems; ++item)
      {
        task(item, 0);
      }
      return;
    }
    // Tickets have room for as many.
    for (std::size_t first = 0; first < numberOfItems; first += Closed)
    {
      const std::size_t number = std::min<std::size_t>(Closed, numberOfItems - first);
      this->RunSome(number, [&](std::size_t item, unsigned int thread) { task(first + item, thread); });
    }
  }

private:
  /** The next item of a task that is over, or has not begun. */
  static constexpr std::uint64_t Closed = 0xFFFFFFFFu;

  void
  RunSome(std::size_t numberOfItems, const TaskType & task)
  {
    m_Task.store(&task, std::memory_order_relaxed);
    m_NumberOfItems.store(numberOfItems, std::memory_order_relaxed);
    m_NumberDone.store(0, std::memory_order_relaxed);
    m_Failure = nullptr;
    this->Open();
    this->TakeItems(0);
    while (m_NumberDone.load(std::memory_order_acquire) < numberOfItems)
    {
      std::this_thread::yield();
    }
    m_Ticket.fetch_or(Closed);
    if (m_Failure != nullptr)
    {
      std::rethrow_exception(m_Failure);
    }
  }

  /** Issues the ticket of the next task. */
  void
  Open()
  {
    m_Ticket.store(((m_Ticket.load() >> 32) + 1) << 32);
    if (m_NumberAsleep.load() > 0)
    {
      this->WakeAll();
    }
  }

  void
  WakeAll()
  {
    {
      // Nobody is between looking for a task and falling asleep.
      const std::lock_guard<std::mutex> lock(m_Mutex);
    }
    m_Wake.notify_all();
  }

  void
  Work(unsigned int thread)
  {
    while (!m_IsOver.load())
    {
      const std::uint64_t task = m_Ticket.load() >> 32;
      this->TakeItems(thread);
      const auto isNew = [&] { return m_Ticket.load() >> 32 != task || m_IsOver.load(); };
      const auto sleepAt = std::chrono::steady_clock::now() + TimeAwake;
      while (!isNew() && std::chrono::steady_clock::now() < sleepAt)
      {
        std::this_thread::yield();
      }
      if (!isNew())
      {
        std::unique_lock<std::mutex> lock(m_Mutex);
        m_NumberAsleep.fetch_add(1);
        m_Wake.wait(lock, isNew);
        m_NumberAsleep.fetch_sub(1);
      }
    }
  }

  void
  TakeItems(unsigned int thread)
  {
    std::uint64_t ticket = m_Ticket.load(std::memory_order_acquire);
    while ((ticket & Closed) < m_NumberOfItems.load(std::memory_order_relaxed))
    {
      if (!m_Ticket.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel, std::memory_order_acquire))
      {
        continue;
      }
      const auto item = static_cast<std::size_t>(ticket & Closed);
      try
      {
        (*m_Task.load(std::memory_order_relaxed))(item, thread);
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
      m_NumberDone.fetch_add(1, std::memory_order_acq_rel);
      ticket = m_Ticket.load(std::memory_order_acquire);
    }
  }

  std::mutex                    m_Mutex{};
  std::condition_variable       m_Wake{};
  std::atomic<bool>             m_IsOver{ false };
  std::atomic<std::size_t>      m_NumberAsleep{ 0 };
  std::atomic<std::uint64_t>    m_Ticket{ Closed };
  std::atomic<const TaskType *> m_Task{ nullptr };
  std::atomic<std::size_t>      m_NumberOfItems{ 0 };
  std::atomic<std::size_t>      m_NumberDone{ 0 };
  std::exception_ptr            m_Failure{}; // under the mutex
  std::size_t                   m_FailedItem{ 0 };
  std::vector<std::thread>      m_Workers{}; // last: they use all the rest
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
