/// Choice of what the projector shows, as a board knows it. The service is asked to change it, and tells every board what was chosen; its news of an
/// earlier choice may come after this teacher has chosen again.

import type {BoardRequest} from "../../wire/classroom/board_messages.generated.ts"
import type {Projecting} from "../../wire/classroom/projector_messages.generated.ts"

/// How the projector shows pupils: with their nicknames, and with their programs beside the room.
export type ProjectorSight = Omit<Projecting, "op" | "pupil" | "task">

export interface ProjectorChoice {
  /// The pupil who is shown.
  readonly projecting: number | null
  /// The task whose standings are shown.
  readonly projectingTask: number | null
  /// How pupils are shown from now on.
  readonly projectorSight: ProjectorSight
  /// Whether the service has not yet told what this teacher chose last; `unsent` while no pupil is shown.
  readonly sightAsked: "unsent" | "sent" | null
}

export interface Chosen {
  readonly choice: ProjectorChoice
  readonly request: BoardRequest | null
}

/// The teacher wants pupils to be shown in another way, also the one who is shown already.
export function lookAt(choice: ProjectorChoice, to: Partial<ProjectorSight>): Chosen {
  const projectorSight = {...choice.projectorSight, ...to}
  const {projecting, projectingTask} = choice
  return {
    choice: {projecting, projectingTask, projectorSight, sightAsked: projecting === null ? "unsent" : "sent"},
    request: projecting === null ? null : {op: "project", pupil: projecting, ...projectorSight},
  }
}

/// The service tells what was chosen.
export function choiceHeard(
  choice: ProjectorChoice,
  {pupil, named, program, task}: Omit<Projecting, "op">,
): Chosen {
  const {projectorSight, sightAsked} = choice
  if (pupil === null) return {choice: {...choice, projecting: null, projectingTask: task}, request: null}
  const isAsked = named === projectorSight.named && program === projectorSight.program
  if (sightAsked === null || isAsked)
    return {
      choice: {projecting: pupil, projectingTask: null, projectorSight: {named, program}, sightAsked: null},
      request: null,
    }
  return {
    choice: {projecting: pupil, projectingTask: null, projectorSight, sightAsked: "sent"},
    request: sightAsked === "unsent" ? {op: "project", pupil, ...projectorSight} : null,
  }
}
