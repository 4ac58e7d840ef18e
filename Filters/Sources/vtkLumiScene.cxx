// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiScene.h"

#include "Data/Scenes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkLumiScene);

namespace
{

lumitree::data::Mesh Generate(int scene, int resolution, int seedProperty)
{
  namespace data = lumitree::data;
  const auto seed = static_cast<std::uint64_t>(seedProperty);
  switch (scene)
  {
    case vtkLumiScene::Teapot:
      return data::teapot(std::max(2, resolution));
    case vtkLumiScene::City:
      return data::city(std::min(200, resolution), seed);
    case vtkLumiScene::TeapotInStadium:
      return data::teapotInStadium(std::max(2, resolution));
    case vtkLumiScene::RandomCloud:
      return data::randomCloud(std::int64_t(10) * resolution * resolution, seed);
    case vtkLumiScene::Sphere:
      return data::sphere(resolution);
    case vtkLumiScene::Torus:
      return data::torus(4 * resolution, std::max(3, 2 * resolution));
    case vtkLumiScene::Terrain:
      return data::terrain(resolution, seed);
    default:
      return data::cornellBox(resolution);
  }
}

template <class Array, class Values>
void Fill(Array* array, const Values& values)
{
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
}

void Convert(const lumitree::data::Mesh& mesh, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  Fill(coordinates.Get(), mesh.points);
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);

  vtkNew<vtkTypeInt64Array> offsets;
  Fill(offsets.Get(), mesh.offsets);
  vtkNew<vtkTypeInt64Array> connectivity;
  Fill(connectivity.Get(), mesh.connectivity);
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  output->SetPolys(polygons);

  vtkNew<vtkIntArray> part;
  part->SetName("Part");
  Fill(part.Get(), mesh.part);
  output->GetCellData()->SetScalars(part);

  vtkNew<vtkDoubleArray> reflectance;
  reflectance->SetName("Reflectance");
  Fill(reflectance.Get(), mesh.reflectance);
  output->GetCellData()->AddArray(reflectance);

  vtkNew<vtkStringArray> names;
  names->SetName("PartNames");
  for (const std::string& name : mesh.partNames)
  {
    names->InsertNextValue(name);
  }
  output->GetFieldData()->AddArray(names);
}

}

vtkLumiScene::vtkLumiScene()
{
  this->SetNumberOfInputPorts(0);
}

int vtkLumiScene::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkLumiScene::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(information);
  const auto pieceKey = vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER();
  if (information->Has(pieceKey) && information->Get(pieceKey) > 0)
  {
    return 1;
  }
  try
  {
    Convert(Generate(this->Scene, this->Resolution, this->Seed), output);
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro("The scene could not be made: " << error.what());
    return 0;
  }
  return 1;
}

void vtkLumiScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scene: " << this->Scene << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
