/// Programs of the other robots in the room, as they are stored now.

import type {Store} from "../../browser/store.ts"

/// Gives the robots their programs again whenever one was stored. `haskell` is that of a stored program; `null` if there is none.
export function followStoredPrograms(
  store: Pick<Store, "now" | "onEvent" | "dispatch">,
  haskell: (id: string) => string | null,
): void {
  let before = store.now.saved
  store.onEvent(({saved, companions}) => {
    const wasStored = saved === "saved" && before !== "saved"
    before = saved
    if (!wasStored || companions.length === 0) return
    const stored = companions.map(companion => {
      const {program} = companion
      const text = program === null ? null : haskell(program.id)
      return program === null || text === null ? companion : {...companion, program: {...program, text}}
    })
    if (stored.some((one, i) => one.program?.text !== companions[i]?.program?.text))
      store.dispatch({kind: "companions-stored", companions: stored})
  })
}
