/// Documentation that explains a name: Rosy's Haddock, the Prelude's, or none for the program's own names.

import {library} from "./standard_library.ts"

export type Home = "rosy" | "prelude" | "nowhere"

/// `help` as Haddock's anchors write it: `v:wait`, `t:Velocity`.
export function homeOf(help: string): Home {
  const name = help.slice(2)
  const known = help.startsWith("t:")
    ? library.types.has(name)
    : library.values.has(name) || library.constructors.has(name)
  if (!known) return "nowhere"
  return library.prelude.has(name) ? "prelude" : "rosy"
}
