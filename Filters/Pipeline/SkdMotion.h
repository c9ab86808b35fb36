// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMotion_h
#define SkdMotion_h

#include "Core/Geometry/RigidMotion.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"

namespace skdtree
{
/// Where a filter looks at its Source, by its properties Translation, Rotation and RotationCenter,
/// after its Transform.
template <class Filter>
vtkSmartPointer<vtkMatrix4x4> SkdMotionOf(Filter* self)
{
  const double* shift = self->GetTranslation();
  const double* rotation = self->GetRotation();
  const double* centre = self->GetRotationCenter();
  vtkNew<vtkTransform> transform;
  transform->Translate(shift);
  if (rotation[0] != 0.0 || rotation[1] != 0.0 || rotation[2] != 0.0)
  {
    transform->Translate(centre);
    transform->RotateZ(rotation[2]);
    transform->RotateX(rotation[0]);
    transform->RotateY(rotation[1]);
    transform->Translate(-centre[0], -centre[1], -centre[2]);
  }
  if (self->GetTransform())
  {
    transform->Concatenate(self->GetTransform());
  }
  return transform->GetMatrix();
}

/// Makes a copy of a matrix (nullptr: none) the Transform of a filter, which is then modified. An
/// error, and no change, if it is not rigid.
inline void SkdSetTransform(
  vtkObject* self, vtkMatrix4x4* motion, vtkSmartPointer<vtkMatrix4x4>& transform)
{
  if (motion && !skd::RigidMotion::FromMatrix(&motion->Element[0][0]))
  {
    vtkErrorWithObjectMacro(self,
      "The transform is not rigid and is ignored. "
      "Use rotations, reflections and translations only.");
    return;
  }
  transform = motion ? vtkSmartPointer<vtkMatrix4x4>::New() : nullptr;
  if (motion)
  {
    transform->DeepCopy(motion);
  }
  self->Modified();
}
}

#endif
