// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiCameraRays.h"

#include "LumiCamera.h"
#include "LumiJob.h"

#include "Accel/Parallel.h"

#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkExtentTranslator.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkLumiCameraRays);

namespace
{

using namespace lumitree;
using filters::Camera;
using filters::CameraRays;

void Extend(Box& box, vtkDataObject* object)
{
  auto* dataset = vtkDataSet::SafeDownCast(object);
  if (dataset && dataset->GetNumberOfPoints() > 0)
  {
    double b[6];
    dataset->GetBounds(b);
    box.extend(Vec3{ b[0], b[2], b[4] });
    box.extend(Vec3{ b[1], b[3], b[5] });
  }
}

/// The bounds of all leaves of all ranks' scenes. Collective.
Box BoundsOf(vtkDataObject* scene, vtkMultiProcessController* controller)
{
  Box box;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(scene))
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaves;
    leaves.TakeReference(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      Extend(box, leaves->GetCurrentDataObject());
    }
  }
  else
  {
    Extend(box, scene);
  }
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    const Box mine = box;
    controller->AllReduce(mine.lower.data(), box.lower.data(), 3, vtkCommunicator::MIN_OP);
    controller->AllReduce(mine.upper.data(), box.upper.data(), 3, vtkCommunicator::MAX_OP);
  }
  return box;
}

vtkSmartPointer<vtkDoubleArray> MakeTriples(const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(count);
  return array;
}

/// Pixels are numbered within the image's extent, x fastest. Returns false when it was aborted.
bool Fill(vtkImageData* image, const CameraRays& rays, vtkAlgorithm* algorithm)
{
  const vtkIdType count = image->GetNumberOfPoints();
  const auto origins = MakeTriples("RayOrigin", count);
  const auto directions = MakeTriples("RayDirection", count);
  const int* extent = image->GetExtent();
  const auto width = static_cast<std::size_t>(std::max(1, extent[1] - extent[0] + 1));

  double* const origin = origins->GetPointer(0);
  double* const direction = directions->GetPointer(0);
  lumitree::filters::Job job(algorithm);
  const bool completed = lumitree::parallelFor(static_cast<std::size_t>(count), 16384,
    lumitree::filters::threadsFor(0), job.control(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t p = begin; p < end; ++p)
      {
        const lumitree::filters::RayLine ray =
          rays(extent[0] + static_cast<int>(p % width), extent[2] + static_cast<int>(p / width));
        std::copy(ray.origin.begin(), ray.origin.end(), origin + 3 * p);
        std::copy(ray.direction.begin(), ray.direction.end(), direction + 3 * p);
      }
    });
  image->GetPointData()->AddArray(origins);
  image->GetPointData()->AddArray(directions);
  image->GetPointData()->SetActiveScalars("RayDirection");
  return completed;
}

}

vtkLumiCameraRays::vtkLumiCameraRays()
{
  this->Controller = vtkMultiProcessController::GetGlobalController();
}

vtkLumiCameraRays::~vtkLumiCameraRays() = default;

void vtkLumiCameraRays::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkLumiCameraRays::GetController()
{
  return this->Controller;
}

void vtkLumiCameraRays::SetSceneConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(0, output);
}

void vtkLumiCameraRays::SetSceneData(vtkDataObject* scene)
{
  this->SetInputDataInternal(0, scene);
}

int vtkLumiCameraRays::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkLumiCameraRays::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // A resolution below 1 is an empty extent here, and an error in RequestData.
  const int extent[6] = { 0, std::max(0, this->Resolution[0]) - 1, 0,
    std::max(0, this->Resolution[1]) - 1, 0, 0 };
  const double zero[3] = { 0.0, 0.0, 0.0 };
  const double one[3] = { 1.0, 1.0, 1.0 };
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  information->Set(vtkDataObject::ORIGIN(), zero, 3);
  information->Set(vtkDataObject::SPACING(), one, 3);
  information->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_DOUBLE, 3);
  return 1;
}

int vtkLumiCameraRays::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // By default an image asks its input for the image's own extent. Of a scene with an extent each
  // rank asks for its part; pieces of other scenes are right by default.
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* output = outputVector->GetInformationObject(0);
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  if (!input || !input->Has(Pipeline::WHOLE_EXTENT()))
  {
    return 1;
  }
  const bool pieces = output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) != 0;
  vtkNew<vtkExtentTranslator> translator;
  int extent[6];
  translator->PieceToExtentThreadSafe(pieces ? output->Get(Pipeline::UPDATE_PIECE_NUMBER()) : 0,
    pieces ? output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) : 1, 0,
    input->Get(Pipeline::WHOLE_EXTENT()), extent, vtkExtentTranslator::BLOCK_MODE, 0);
  input->Set(Pipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
}

int vtkLumiCameraRays::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(information);
  image->Initialize();

  Camera camera;
  std::copy_n(this->Position, 3, camera.position.begin());
  std::copy_n(this->FocalPoint, 3, camera.focalPoint.begin());
  std::copy_n(this->ViewUp, 3, camera.viewUp.begin());
  std::copy_n(this->Resolution, 2, camera.resolution.begin());
  camera.viewAngle = this->ViewAngle;
  camera.parallel = this->ParallelProjection;
  camera.parallelScale = this->ParallelScale;
  std::string problem = camera.problem();

  if (problem.empty() && this->AutomaticCamera)
  {
    const Box bounds = BoundsOf(vtkDataObject::GetData(inputVector[0]), this->Controller);
    if (!bounds.empty() && !(isFinite(bounds.lower) && isFinite(bounds.upper)))
    {
      problem = "The bounds of the scene are not finite.";
    }
    else if (!bounds.empty())
    {
      camera.lookAt(bounds);
      problem = camera.problem();
    }
  }
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }

  image->SetExtent(information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
  image->SetOrigin(0.0, 0.0, 0.0);
  image->SetSpacing(1.0, 1.0, 1.0);
  if (!Fill(image, CameraRays(camera), this))
  {
    image->Initialize();
  }
  return 1;
}

void vtkLumiCameraRays::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print3 = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  print3("Position", this->Position);
  print3("FocalPoint", this->FocalPoint);
  print3("ViewUp", this->ViewUp);
  os << indent << "ViewAngle: " << this->ViewAngle << "\n";
  os << indent << "ParallelProjection: " << this->ParallelProjection << "\n";
  os << indent << "ParallelScale: " << this->ParallelScale << "\n";
  os << indent << "Resolution: " << this->Resolution[0] << " x " << this->Resolution[1] << "\n";
  os << indent << "AutomaticCamera: " << this->AutomaticCamera << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
