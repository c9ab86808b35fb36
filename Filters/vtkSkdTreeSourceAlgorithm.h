// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeSourceAlgorithm
 * @brief base class of filters that ask a second mesh about the first
 *
 * Two input ports, each any vtkDataSet or composite of them: the Input, which asks, and the Source,
 * which is searched. Each process gets the whole Source, whatever piece of the output is asked for:
 * the answer may be anywhere in it. Where there is no Source the Input is searched, so it is the
 * one that comes whole.
 *
 * A subclass says what its output ports are and writes RequestData.
 */

#ifndef vtkSkdTreeSourceAlgorithm_h
#define vtkSkdTreeSourceAlgorithm_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <initializer_list> // For std::initializer_list
#include <vector>           // For std::vector

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeSourceAlgorithm : public vtkPassInputTypeAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSkdTreeSourceAlgorithm, vtkPassInputTypeAlgorithm);

  ///@{
  /**
   * The mesh that is searched (port 1).
   */
  void SetSourceConnection(vtkAlgorithmOutput* algOutput);
  void SetSourceData(vtkDataObject* source);
  ///@}

  /**
   * Passes the inputs on without broken cells: see "Bad input" in vtkSkdTreeCellLocator.
   */
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  enum class SourceUse
  {
    Required,
    Optional
  };

  /// As an output port's type: that of the Input.
  static constexpr int LIKE_INPUT = -1;

  /// A vtkUnstructuredGrid; where the Input is composite a vtkMultiBlockDataSet, to hold several.
  static constexpr int GRID_OR_BLOCKS = -2;

  /// One type an output port: VTK_POLY_DATA and the like, or one of the above.
  vtkSkdTreeSourceAlgorithm(SourceUse use, std::initializer_list<int> outputTypes);
  ~vtkSkdTreeSourceAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// For subclasses whose every process needs the whole Input, too.
  bool WholeInput = false;

private:
  static int TypeFor(int outputType, vtkDataObject* input);

  vtkSkdTreeSourceAlgorithm(const vtkSkdTreeSourceAlgorithm&) = delete;
  void operator=(const vtkSkdTreeSourceAlgorithm&) = delete;

  SourceUse Use;
  std::vector<int> OutputTypes;
};

VTK_ABI_NAMESPACE_END
#endif
