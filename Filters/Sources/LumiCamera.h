// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiCamera_h
#define LumiCamera_h

#include "LumiRayOutput.h"

#include "Accel/Box.h"
#include "Accel/Vec3.h"

#include <array>
#include <string>

namespace lumitree::filters
{

/// A camera as vtkLumiCameraRays describes it, and the rays of its pixels.
struct Camera
{
  Vec3 position;
  Vec3 focalPoint;
  Vec3 viewUp;
  double viewAngle = 30.0; ///< degrees, vertical
  bool parallel = false;
  double parallelScale = 1.0; ///< half the height of the image
  std::array<int, 2> resolution = { 1, 1 };

  /// What is wrong with it; empty when nothing is.
  [[nodiscard]] std::string problem() const;

  /// Keeps the view direction and shows all of the sphere around the box, which is finite and not
  /// empty.
  void lookAt(const Box& box);
};

/// The camera ready to give rays; the camera has no problem.
class CameraRays
{
public:
  explicit CameraRays(const Camera& camera);

  /// The ray through the middle of pixel (i, j), unit direction.
  [[nodiscard]] RayLine operator()(int i, int j) const;

private:
  bool parallel_;
  Vec3 position_;
  Vec3 forward_;
  Vec3 right_; ///< from the middle of the image to its right edge, at distance 1 when perspective
  Vec3 up_;    ///< to its upper edge
  double width_;
  double height_;
};

}

#endif
