/// Order of the pupils in the overview of the teacher's board. Pure.

import {needs, type PupilShown} from "../../wire/classroom/board_messages.generated.ts"

/// Sorted by the most urgent need for help, then by being connected; otherwise in the order of joining.
export const byNeed = (pupils: readonly PupilShown[]): readonly PupilShown[] =>
  pupils.toSorted((one, other) => rank(one) - rank(other))

function rank(pupil: PupilShown): number {
  const [first] = pupil.needs
  if (first !== undefined) return needs.indexOf(first)
  return needs.length + (pupil.online ? 0 : 1)
}
