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
#ifndef itkDelaunayRefinementPythonRun_h
#define itkDelaunayRefinementPythonRun_h

// Python.h comes first, from SWIG.
#include "itkCellInterface.h"
#include "itkCommand.h"
#include "itkProcessObject.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <new>
#include <string>

namespace itk
{
/** \class DelaunayRefinementPythonSignalWatch
 * \brief Lets Python's signal handlers run while a filter does, and stops the filter if one of them raises.
 *
 * Python's handlers only run between two instructions of Python, of which there is none during a run: without this
 * Ctrl-C waits for its end.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementPythonSignalWatch : public Command
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DelaunayRefinementPythonSignalWatch);

  using Self = DelaunayRefinementPythonSignalWatch;
  using Superclass = Command;
  using Pointer = SmartPointer<Self>;

  itkNewMacro(Self);

  static void
  Attach(ProcessObject * process)
  {
    process->AddObserver(ProgressEvent(), Self::New());
  }

  /** Raises again what a handler raised; false if none did. The caller has Python's lock. */
  static bool
  Raise()
  {
    if (s_Type == nullptr)
    {
      return false;
    }
    PyErr_Restore(s_Type, s_Value, s_Traceback);
    s_Type = s_Value = s_Traceback = nullptr;
    return true;
  }

  static void
  Forget()
  {
    if (Self::Raise())
    {
      PyErr_Clear();
    }
  }

  void
  Execute(Object * caller, const EventObject &) override
  {
    // Python's lock is not worth asking for at every event.
    constexpr std::chrono::milliseconds pause(50);
    const auto                          now = std::chrono::steady_clock::now();
    if (now - m_LastLook < pause)
    {
      return;
    }
    m_LastLook = now;
    const PyGILState_STATE lock = PyGILState_Ensure();
    if (PyErr_CheckSignals() != 0)
    {
      PyObject * type;
      PyObject * value;
      PyObject * traceback;
      PyErr_Fetch(&type, &value, &traceback);
      Self::Forget();
      s_Type = type;
      s_Value = value;
      s_Traceback = traceback;
      static_cast<ProcessObject *>(caller)->AbortGenerateDataOn();
    }
    PyGILState_Release(lock);
  }

  void
  Execute(const Object *, const EventObject &) override
  {
    // Progress comes from objects that can be stopped.
  }

protected:
  DelaunayRefinementPythonSignalWatch() = default;
  ~DelaunayRefinementPythonSignalWatch() override = default;

private:
  std::chrono::steady_clock::time_point m_LastLook{};

  // One for the process: only its main thread runs handlers.
  static inline PyObject * s_Type{ nullptr };
  static inline PyObject * s_Value{ nullptr };
  static inline PyObject * s_Traceback{ nullptr };
};

/** \class DelaunayRefinementPythonUnlock
 * \brief Lets other Python threads run from the start of the filter's own work; what is upstream keeps Python's lock.
 *
 * \ingroup DelaunayRefinement
 */
class DelaunayRefinementPythonUnlock : public Command
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DelaunayRefinementPythonUnlock);

  using Self = DelaunayRefinementPythonUnlock;
  using Superclass = Command;
  using Pointer = SmartPointer<Self>;

  itkNewMacro(Self);

  void
  Execute(Object *, const EventObject &) override
  {
    if (m_State == nullptr)
    {
      m_State = PyEval_SaveThread();
    }
  }

  void
  Execute(const Object *, const EventObject &) override
  {}

  void
  LockAgain()
  {
    if (m_State != nullptr)
    {
      PyEval_RestoreThread(m_State);
      m_State = nullptr;
    }
  }

protected:
  DelaunayRefinementPythonUnlock() = default;
  ~DelaunayRefinementPythonUnlock() override = default;

private:
  PyThreadState * m_State{ nullptr };
};

/** Runs \c update, which brings \c process up to date, with Python's lock released. Returns None, or nullptr with
 * Python's error set: what a signal's handler raised, or the sentence of the filter that failed. */
template <typename TUpdate>
PyObject *
RunForPython(ProcessObject * process, const TUpdate & update)
{
  DelaunayRefinementPythonSignalWatch::Forget();
  const auto          unlock = DelaunayRefinementPythonUnlock::New();
  const unsigned long tag = process->AddObserver(StartEvent(), unlock);
  PyObject *          type = nullptr;
  std::string         message;
  try
  {
    update();
  }
  catch (const ExceptionObject & error)
  {
    // "ITK ERROR: Class(0x55d0c0ffee): Sentence" becomes "Class: Sentence".
    type = PyExc_RuntimeError;
    message = error.GetDescription();
    const std::string start = "ITK ERROR: ";
    const std::size_t address = message.find("(0x");
    const std::size_t sentence = message.find("): ");
    if (message.compare(0, start.size(), start) == 0 && address < sentence && sentence != std::string::npos)
    {
      message = message.substr(start.size(), address - start.size()) + message.substr(sentence + 1);
    }
  }
  catch (const std::bad_alloc &)
  {
    type = PyExc_MemoryError;
    message = "The memory does not suffice";
  }
  catch (const std::exception & error)
  {
    type = PyExc_RuntimeError;
    message = error.what();
  }
  unlock->LockAgain();
  process->RemoveObserver(tag);
  if (type == nullptr)
  {
    Py_INCREF(Py_None);
    return Py_None;
  }
  if (!DelaunayRefinementPythonSignalWatch::Raise())
  {
    PyErr_SetString(type, message.c_str());
  }
  return nullptr;
}

/** The point indices of all cells, which must be tetrahedra, or must be triangles, as 64-bit integers in a bytearray;
 * nullptr with Python's error set if they are neither. ITK's own way by GetCellsArray() takes twenty times as long. */
template <typename TMesh>
PyObject *
CopyCellsForPython(const TMesh * mesh)
{
  const auto * cells = mesh->GetCells();
  if (cells == nullptr || cells->Size() == 0)
  {
    PyErr_SetString(PyExc_ValueError, "The mesh has no cells");
    return nullptr;
  }
  const auto        kind = cells->Begin().Value()->GetType();
  bool              isKnown = kind == CellGeometryEnum::TETRAHEDRON_CELL || kind == CellGeometryEnum::TRIANGLE_CELL;
  const std::size_t step = kind == CellGeometryEnum::TETRAHEDRON_CELL ? 4 : 3;
  PyObject *        bytes =
    PyByteArray_FromStringAndSize(nullptr, static_cast<Py_ssize_t>(cells->Size() * step * sizeof(std::int64_t)));
  if (bytes == nullptr)
  {
    return nullptr;
  }
  auto * to = reinterpret_cast<std::int64_t *>(PyByteArray_AsString(bytes));
  for (auto cell = cells->Begin(); isKnown && cell != cells->End(); ++cell)
  {
    isKnown = cell.Value()->GetType() == kind;
    if (isKnown)
    {
      to = std::copy_n(cell.Value()->PointIdsBegin(), step, to);
    }
  }
  if (!isKnown)
  {
    Py_DECREF(bytes);
    PyErr_SetString(PyExc_ValueError, "The mesh has cells that are neither all tetrahedra nor all triangles");
    return nullptr;
  }
  return bytes;
}
} // end namespace itk

#endif
