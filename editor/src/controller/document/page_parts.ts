/// Parts of the page that are not Preact components, and the connection to the service. A part is `null` until its element is mounted or it is loaded.

import type {Reader} from "@rosy/codegen/reader"
import type {ServiceConnection} from "../../browser/service_connection.ts"
import type {BlocksView} from "../../views/blocks/index.ts"
import type {WorldEditorView} from "../../views/room/editor/world_editor_view.ts"
import type {RoomView} from "../../views/room/room_view.ts"
import type {HaskellPane} from "../../views/source/haskell_pane_types.ts"

export interface PageParts {
  blocks: BlocksView | null
  blocksHost: HTMLElement | null
  source: HaskellPane | null
  room: RoomView | null
  roomCanvas: HTMLCanvasElement | null
  worldEditor: WorldEditorView | null
  /// The parser of Haskell; a program can be changed only after it is loaded.
  reader: Reader | null
  service: ServiceConnection | null
  /// The number of the latest `seen` of the service; 0 before the first (protocol §4).
  seen: number
}

export function noParts(): PageParts {
  return {
    blocks: null,
    blocksHost: null,
    source: null,
    room: null,
    roomCanvas: null,
    worldEditor: null,
    reader: null,
    service: null,
    seen: 0,
  }
}
