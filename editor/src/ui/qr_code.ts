/// QR codes as the path of an SVG drawing. Loaded when the share dialog is first opened.

import qrcode from "qrcode-generator"

export interface QrCode {
  /// Modules on a side, without the quiet zone around the code.
  readonly size: number
  /// An SVG path in units of one module: the dark modules.
  readonly path: string
}

/// Letters that a QR code of the largest version holds with the least error correction (ISO/IEC 18004, table 7).
const mostLetters = 2953

/// `null` for a text that is too long. The text is ASCII, as every address is.
export function qrCodeOf(text: string): QrCode | null {
  if (text.length > mostLetters) return null
  // 0: the smallest version that holds the text. A screen has no scratches: the least error correction gives the largest modules.
  const code = qrcode(0, "L")
  code.addData(text, "Byte")
  code.make()
  const size = code.getModuleCount()
  let path = ""
  for (let row = 0; row < size; row++)
    for (let column = 0; column < size; column++)
      if (code.isDark(row, column)) path += `M${column} ${row}h1v1h-1z`
  return {size, path}
}
