/// Messages of the service to the projector (protocol §11.2), with rooms and frames as the page keeps them.

import {pageFrame} from "../../state/messages/message_decoder.ts"
import type {Frame} from "../../state/messages/messages.ts"
import type {Refused} from "../../wire/classroom/message_fields.generated.ts"
import {
  type Invitation,
  type Projected,
  projectorAnswer,
} from "../../wire/classroom/projector_messages.generated.ts"
import {mapped, readerOf} from "../../wire/decode.ts"
import type {World} from "../../worlds/world.ts"
import {worldAt} from "../../worlds/world_decoder.ts"

export type ProjectorMessage =
  | Projected
  | Invitation
  | {readonly op: "room"; readonly world: World}
  | {readonly op: "frame"; readonly frame: Frame}
  | Refused

export const readProjectorMessage = readerOf(
  mapped(projectorAnswer, (message): ProjectorMessage => {
    if (message.op === "room") return {op: "room", world: worldAt("world", message.world)}
    return message.op === "frame" ? {op: "frame", frame: pageFrame(message)} : message
  }),
)
