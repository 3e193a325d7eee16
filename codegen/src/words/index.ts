/// The words of blocks, types and refusals in the language that was chosen at the start.

/// A table of words in another language: the same names, other words; functions take the same pieces.
export type Translated<T> = T extends string
  ? string
  : T extends (...pieces: infer Pieces) => infer Said
    ? (...pieces: Pieces) => Translated<Said>
    : {readonly [Name in keyof T]: Translated<T[Name]>}
