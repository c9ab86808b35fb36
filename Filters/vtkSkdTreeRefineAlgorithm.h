// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeRefineAlgorithm
 * @brief   what the filters share that refine cells where something asks for it
 *
 * What asks for a cell, each up to a level of its own: parts of a geometry that meet it or come
 * near, the inside of the geometry, and a field (port 2, optional).
 */

#ifndef vtkSkdTreeRefineAlgorithm_h
#define vtkSkdTreeRefineAlgorithm_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeVersion.h"       // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

class SkdRefineState;

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeRefineAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSkdTreeRefineAlgorithm, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OverlapTests
  {
    EXACT = 0,
    BLIND = 1
  };
  enum FieldTests
  {
    DIFFERENCE = 0,
    GRADIENT = 1,
    VALUE = 2
  };
  enum Balances
  {
    NONE = 0,
    FACE = 1,
    EDGE = 2,
    CORNER = 3
  };

  ///@{
  /**
   * The solution (port 2, optional): any data set, or composite data, whose arrays ask for cells,
   * too. See AddFieldArray.
   */
  void SetFieldConnection(vtkAlgorithmOutput* algOutput);
  void SetFieldData(vtkDataObject* field);
  ///@}

  ///@{
  /**
   * How often a cell is refined at most: each level halves its size (or divides it by the branch
   * factor). From 0 to 30.
   */
  vtkSetClampMacro(MaximumLevel, int, 0, 30);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  ///@{
  /**
   * What decides that a part meets a cell: EXACT (default), or BLIND, the safety boxes of the
   * part's cells, which makes more cells: about as many where those are small beside the leaves,
   * several times as many where they are large and oblique.
   */
  vtkSetClampMacro(OverlapTest, int, EXACT, BLIND);
  vtkGetMacro(OverlapTest, int);
  ///@}

  ///@{
  /**
   * Over what contacts neighbouring leaves differ by one level at most: NONE (default), FACE, EDGE
   * (faces and edges) or CORNER (all).
   */
  vtkSetClampMacro(Balance, int, NONE, CORNER);
  vtkGetMacro(Balance, int);
  ///@}

  ///@{
  /**
   * A maximum level for a part of composite data, by its flat block index; others have the
   * MaximumLevel, which none exceeds.
   */
  void AddPartLevel(int blockIndex, int level);
  void RemoveAllPartLevels();
  ///@}

  ///@{
  /**
   * Refine all cells that come as near to a part as a distance, to a level of their own, at most
   * MaximumLevel: by the exact distance between a cell and the parts' cells, of curved ones that of
   * 8 straight pieces along each of their parameters. The level is a whole number; both are doubles
   * for ParaView, whose lists have one type.
   */
  void AddDistanceBand(double distance, double level);
  void RemoveAllDistanceBands();
  ///@}

  ///@{
  /**
   * Refine cells whose middle is inside of the closed surface that the parts are or that bounds
   * them to this level, at most MaximumLevel: exactly, bodies that overlap included, or, of a
   * surface with open edges, which a warning counts, by its winding number. Default 0: the inside
   * does not matter.
   */
  vtkSetClampMacro(InsideLevel, int, 0, 30);
  vtkGetMacro(InsideLevel, int);
  ///@}

  ///@{
  /**
   * So many layers of cells around those that are refined, of the same level, are refined, too.
   * Default 0.
   */
  vtkSetClampMacro(GrowingLayers, int, 0, 100);
  vtkGetMacro(GrowingLayers, int);
  ///@}

  ///@{
  /**
   * Where the surface is nearly flat, stop at MinimumSurfaceLevel: from there on refine only cells
   * in which the normal of a part's cell is more than NormalDeviation (degrees, 0 to 180) off the
   * mean of that part's normals in the cell. So edges, strong curvature and narrow gaps within a
   * part get the maximum level, flat stretches do not. Normals are as the order of the cells'
   * points has them; where a part has cells that are not flat surfaces it counts as bent. Default
   * off, 15 degrees, level 3.
   */
  vtkSetMacro(RefineByNormalDeviation, bool);
  vtkGetMacro(RefineByNormalDeviation, bool);
  vtkBooleanMacro(RefineByNormalDeviation, bool);
  vtkSkdTreeSetWithinMacro(NormalDeviation, double, 0.0, 180.0);
  vtkGetMacro(NormalDeviation, double);
  vtkSetClampMacro(MinimumSurfaceLevel, int, 0, 30);
  vtkGetMacro(MinimumSurfaceLevel, int);
  ///@}

  ///@{
  /**
   * Arrays of the field, point or cell data, that ask for cells: of several components the
   * magnitude. In a cell those values count that are at points in it, those interpolated at its
   * corners and its middle, and of cell data those of the field's cells that meet it; what is not
   * finite does not. A warning tells the names that the field does not have.
   */
  void AddFieldArray(const char* name);
  void RemoveAllFieldArrays();
  ///@}

  ///@{
  /**
   * When a cell is refined for such an array: DIFFERENCE (default), where two values in it differ
   * by more than FieldThreshold; GRADIENT, where a cell of the field that meets it has two points
   * whose values differ by more than FieldThreshold times their distance (of point data only); or
   * VALUE, where one is in FieldRange.
   */
  vtkSetClampMacro(FieldTest, int, DIFFERENCE, VALUE);
  vtkGetMacro(FieldTest, int);
  ///@}

  ///@{
  /**
   * See FieldTest. Default 0: any difference.
   */
  vtkSkdTreeSetWithinMacro(FieldThreshold, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FieldThreshold, double);
  ///@}

  ///@{
  /**
   * See FieldTest; bounds included. Default (0, 1).
   */
  vtkSkdTreeSetFinite2Macro(FieldRange);
  vtkGetVector2Macro(FieldRange, double);
  ///@}

  ///@{
  /**
   * The level that cells are refined to for the field, at most MaximumLevel. Default 30.
   */
  vtkSetClampMacro(FieldLevel, int, 0, 30);
  vtkGetMacro(FieldLevel, int);
  ///@}

  ///@{
  /**
   * The number of cells that there may be. Where refining on would exceed it a warning tells the
   * level, and the output is what there is so far. Default 20 million.
   */
  vtkSetClampMacro(CellLimit, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(CellLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * How far facets may be from a curved face of the parts, where inside is told from outside,
   * relative to the diagonal of the bounds: see vtkSkdTreePointInOut::SetChordalDeviation. Default
   * 1e-4.
   */
  vtkSkdTreeSetWithinMacro(ChordalDeviation, double, 1e-7, 1.0);
  vtkGetMacro(ChordalDeviation, double);
  ///@}

  ///@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSkdTreeSetWithinMacro(Epsilon, double, 0.0, 1.0);
  vtkGetMacro(Epsilon, double);
  ///@}

  /**
   * Hands the inputs on without broken cells: see "Bad input" in vtkSkdTreeCellLocator.
   */
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkSkdTreeRefineAlgorithm();
  ~vtkSkdTreeRefineAlgorithm() override;

  /// All ports take meshes, and are optional but for the first one.
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  int MaximumLevel = 5;
  int OverlapTest = EXACT;
  int Balance = NONE;
  int InsideLevel = 0;
  int GrowingLayers = 0;
  bool RefineByNormalDeviation = false;
  double NormalDeviation = 15.0;
  int MinimumSurfaceLevel = 3;
  int FieldTest = DIFFERENCE;
  double FieldThreshold = 0.0;
  double FieldRange[2] = { 0.0, 1.0 };
  int FieldLevel = 30;
  vtkIdType CellLimit = 20000000;
  double ChordalDeviation = 1e-4;
  double Epsilon = 1e-9;

  /// Copies the settings into the State, which is to be updated with them.
  void PassOptions();

  std::unique_ptr<SkdRefineState> State; // trees of parts and field, kept while they are the same

private:
  vtkSkdTreeRefineAlgorithm(const vtkSkdTreeRefineAlgorithm&) = delete;
  void operator=(const vtkSkdTreeRefineAlgorithm&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
