/// Ends a `switch` over a union: the compiler proves that no case was forgotten.
export function unreachable(value: never): never {
  throw new Error(`expected every case to be handled, found ${JSON.stringify(value)}`)
}
