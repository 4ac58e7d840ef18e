// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiPhotometricWriter
 * @brief Writes a light, or a table of intensities, as a photometric file.
 *
 * Input: a light of Docs/lights.md that has an intensity, or a photometric solid of
 * vtkLumiRadiantIntensity (of any surface or light). The name of the file says what is written:
 * `.ldt` EULUMDAT, any other IES LM-63-2002.
 *
 * A photometric light is written by the angles of its own file, with its scale; other lights by
 * Planes and Steps, about Axis and Reference. Intensities of radiometric lights are written as they
 * are, in W/sr, though the formats call them candela. Numbers are the shortest that read back as
 * the same.
 *
 * What cannot be written (no light, one without intensity, such as a sky, a file that cannot be
 * opened) is one error.
 */
#ifndef vtkLumiPhotometricWriter_h
#define vtkLumiPhotometricWriter_h

#include "LumitreeFiltersLightModule.h" // for export macro
#include "vtkWriter.h"

#ifndef VTK_ABI_NAMESPACE_BEGIN // before VTK 9.3
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSLIGHT_EXPORT vtkLumiPhotometricWriter : public vtkWriter
{
public:
  static vtkLumiPhotometricWriter* New();
  vtkTypeMacro(vtkLumiPhotometricWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Of lights that have no table of their own: number of C planes in 360 degrees (range 1 to 720,
   * default 24) and of steps of gamma in 180 degrees (range 2 to 720, default 36).
   */
  vtkSetClampMacro(Planes, int, 1, 720);
  vtkGetMacro(Planes, int);
  vtkSetClampMacro(Steps, int, 2, 720);
  vtkGetMacro(Steps, int);
  ///@}

  ///@{
  /**
   * Of the same: directions of gamma = 0 and of C = 0, any length but 0, not parallel. Default (0,
   * 0, -1) and (1, 0, 0).
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  vtkSetVector3Macro(Reference, double);
  vtkGetVector3Macro(Reference, double);
  ///@}

protected:
  vtkLumiPhotometricWriter();
  ~vtkLumiPhotometricWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkLumiPhotometricWriter(const vtkLumiPhotometricWriter&) = delete;
  void operator=(const vtkLumiPhotometricWriter&) = delete;

  char* FileName = nullptr;
  int Planes = 24;
  int Steps = 36;
  double Axis[3] = { 0.0, 0.0, -1.0 };
  double Reference[3] = { 1.0, 0.0, 0.0 };
};
VTK_ABI_NAMESPACE_END

#endif
