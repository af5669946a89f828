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
#include "MeshImageInput.h"
#include "MeshImageInterrupt.h"
#include "MeshImageMessages.h"
#include "MeshImageOptions.h"
#include "MeshImageOutputs.h"
#include "MeshImageProgressBar.h"
#include "MeshImageReport.h"
#include "MeshImageRun.h"
#include "MeshImageStandardError.h"
#include "MeshImageStopwatch.h"

#include "itkTetrahedralMeshWriter.h"

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <new>

#ifdef __GLIBC__
#  include <malloc.h>
#  include <sys/mman.h>
#  include <unistd.h>
#endif

namespace
{
using namespace meshimage;

constexpr int failure = 1;
constexpr int badUsage = 2;

/** The first touch of a page takes longer than work within it: has freed memory used again instead of given back, and
 * what is used first in huge pages, where the system has any. */
void
PrepareMemory()
{
#ifdef __GLIBC__
  constexpr std::size_t largestThatStays = 32 << 20; // bytes; the C library's own limit
  constexpr std::size_t growth = 16 << 20;
  constexpr std::size_t first = 24 << 20;
  constexpr std::size_t hugePage = 2 << 20;
  mallopt(M_MMAP_THRESHOLD, largestThatStays);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, growth);

  // Advice alone: nothing is touched, and a system without huge pages goes on with small ones. Compilers would leave
  // out memory that is never used.
  const auto begin = reinterpret_cast<std::uintptr_t>(sbrk(0));
  void * volatile const unused = std::malloc(first);
  std::free(unused);
  const auto           end = reinterpret_cast<std::uintptr_t>(sbrk(0)) / hugePage * hugePage;
  const std::uintptr_t aligned = (begin + hugePage - 1) / hugePage * hugePage;
  if (aligned < end)
  {
    madvise(reinterpret_cast<void *>(aligned), end - aligned, MADV_HUGEPAGE);
  }
#endif
}

void
WriteMesh(const std::string & target, const MeshType & mesh, Outputs & outputs, ProgressBar & bar)
{
  const auto writer = itk::TetrahedralMeshWriter<MeshType>::New();
  writer->SetInput(&mesh);
  writer->SetFileName(outputs.GetDraft(target));
  writer->AddObserver(itk::ProgressEvent(),
                      [&bar, &writer](const itk::EventObject &) { bar.Show("Writing", writer->GetProgress()); });
  writer->Update();
}

void
MeshImage(const Options & options, Outputs & outputs, ProgressBar & bar)
{
  for (const std::string & target : { options.output, options.surface, options.report })
  {
    if (!target.empty())
    {
      outputs.Add(target);
    }
  }
  const itk::ImageIOBase::Pointer io = OpenImage(options.image);
  const Run run = RunFilter(options, io, [&bar](const char * what, double share) { bar.Show(what, share); });

  bar.Show("Measuring", 0.0);
  const Stopwatch measuring;
  const Quality   quality = MeasureQuality(*run.mesh, *run.boundary);
  const double    measuringSeconds = measuring.GetSeconds();

  const Stopwatch writing;
  WriteMesh(options.output, *run.mesh, outputs, bar);
  if (!options.surface.empty())
  {
    WriteMesh(options.surface, *run.boundary, outputs, bar);
  }
  const Report report{ options, run, quality, measuringSeconds, writing.GetSeconds() };
  if (!options.report.empty())
  {
    WriteReport(outputs.GetDraft(options.report), report);
  }
  outputs.Commit();
  bar.Clear();

  for (const std::string & warning : run.warnings)
  {
    PrintMessage("mesh-image: " + warning + "\n");
  }
  if (!options.quiet)
  {
    PrintReport(std::cout, report);
  }
}

int
Fail(const std::string & message, int code, Outputs & outputs, ProgressBar & bar)
{
  WaitForInterrupt();
  outputs.Discard();
  bar.Clear();
  PrintMessage("mesh-image: " + message + "\n");
  return code;
}
} // namespace

int
main(int argc, char * argv[])
{
  PrepareMemory();
  KeepStandardError();
  // Shared with the thread that waits for interrupts, which may outlive main.
  const auto outputs = std::make_shared<Outputs>();
  const auto bar = std::make_shared<ProgressBar>();
  EndOnInterrupt([outputs, bar] {
    bar->Clear();
    return outputs->Discard();
  });
  // What readers have to say besides their exceptions is for programmers.
  itk::Object::GlobalWarningDisplayOff();
  try
  {
    const std::optional<Options> options = ParseOptions(argc, argv);
    if (options)
    {
      if (!options->quiet)
      {
        bar->EnableOnTerminal();
      }
      MeshImage(*options, *outputs, *bar);
    }
  }
  catch (const UsageError & error)
  {
    return Fail(std::string(error.what()) + " (mesh-image --help lists all options)", badUsage, *outputs, *bar);
  }
  catch (const RunError & error)
  {
    return Fail(outputs->NameTargets(error.what()), failure, *outputs, *bar);
  }
  catch (const itk::ExceptionObject & error)
  {
    return Fail(outputs->NameTargets(PlainMessage(error)), failure, *outputs, *bar);
  }
  catch (const std::bad_alloc &)
  {
    return Fail("There is not enough memory: choose a larger --delta or crop the image", failure, *outputs, *bar);
  }
  catch (const std::exception & error)
  {
    return Fail(error.what(), failure, *outputs, *bar);
  }
  WaitForInterrupt();
  return EXIT_SUCCESS;
}
