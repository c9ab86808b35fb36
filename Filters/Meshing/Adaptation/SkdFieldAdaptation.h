// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFieldAdaptation.h
 * @brief A mesh that follows a field of another one, and what is to be told of it.
 */

#ifndef SkdFieldAdaptation_h
#define SkdFieldAdaptation_h

#include "Meshing/Adaptation/SkdFieldSamples.h"
#include "Meshing/Adaptation/SkdMeshAdapter.h"

class vtkAlgorithm;

namespace skdtree
{
/// What each value of a field counts in a mean.
enum class SkdFieldWeighing
{
  Automatic, ///< by the cosine of the latitude if the field is on a grid around a sphere
  Equal,
  CosineOfLatitude
};

/// How a mesh is to follow a field, as a user asks for it.
struct SkdAdaptationRequest
{
  std::string Array;              ///< the field; if empty the first of numbers
  bool IsSourceInDegrees = false; ///< its positions are longitude and latitude
  SkdFieldWeighing Weighing = SkdFieldWeighing::Automatic;
  SkdSurfaceChoice Surface = SkdSurfaceChoice::Automatic;
  skd::AdaptRules Rules;
  bool KeepsIterations = false;
};

/// Reads a field (SkdFieldSamples), finds its means in the cells of a mesh (SkdContainedMean)
/// wherever SkdMeshAdapter moves them to, until shares are equal, and puts into words what came of
/// it.
class SkdFieldAdaptation
{
public:
  struct Message
  {
    bool IsError; ///< else a warning
    std::string Text;
  };

  /// Whether there is an outcome to show. The algorithm gets the progress, and may be aborted.
  bool Run(const std::vector<SkdBlock>& inputs, vtkDataObject* source,
    const SkdAdaptationRequest& request, vtkAlgorithm* algorithm);

  /// What the last run has to tell, in order.
  const std::vector<Message>& GetMessages() const { return this->Messages; }

  SkdMeshAdapter& GetAdapter() { return this->Adapter; }
  void AddReport(vtkDataObject* output) const;

private:
  bool ReadField(vtkDataObject* source, SkdFieldSamples& samples);
  std::vector<double> SetPositions(SkdFieldSamples& samples) const;
  bool WeighsByCosine(const SkdFieldSamples& samples) const;
  double ToleranceOfCells() const;
  void Move(vtkDataObject* source, const SkdFieldSamples& samples, vtkAlgorithm* algorithm);

  void Tell(bool isError, const std::string& text) { this->Messages.push_back({ isError, text }); }
  void TellOfMesh();
  void TellOfOutcome();
  void TellOfError();
  std::string WhatHoldsBack() const;

  SkdAdaptationRequest Request;
  SkdMeshAdapter Adapter;
  std::vector<Message> Messages;
  std::size_t NumberOfSamples = 0;
  vtkIdType NumberOfTooLarge = 0;
  double Seconds = 0.0;
};
}

#endif
