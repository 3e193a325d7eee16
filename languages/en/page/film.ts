/// Films of the room.

import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short} = measuresOf("en")

export const film = {
  webm: "Film of the run (WebM)",
  gif: "Film of the run (GIF)",
  making: (percent: number) => `Making the film: ${percent}%`,
  faster: (pace: number) => `${short(pace, 1)} times as fast: a film is a minute long at most.`,
  cancel: "Cancel",
} as const
