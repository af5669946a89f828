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
// Reads a mesh with VTK and draws it, cut open, into an image file without a window:
//
//   DrawMesh MESH.vtu PICTURE.png
//
// Where there is no display, xvfb-run gives VTK one: xvfb-run DrawMesh MESH.vtu PICTURE.png

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataSetMapper.h>
#include <vtkExtractGeometry.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlane.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cstdlib>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " MESH.vtu PICTURE.png\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  if (reader->GetOutput()->GetNumberOfCells() == 0)
  {
    std::cerr << "There are no tetrahedra in " << argv[1] << '\n';
    return EXIT_FAILURE;
  }
  double center[3];
  reader->GetOutput()->GetCenter(center);

  // Whole tetrahedra, those on one side of the middle and across it.
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(center);
  plane->SetNormal(1.0, 0.0, 0.0);
  vtkNew<vtkExtractGeometry> half;
  half->SetInputConnection(reader->GetOutputPort());
  half->SetImplicitFunction(plane);
  half->ExtractBoundaryCellsOn();

  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(half->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.75, 0.6);
  actor->GetProperty()->EdgeVisibilityOn();

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->SetPosition(1.0, 0.5, 0.4);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
