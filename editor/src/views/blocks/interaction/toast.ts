/// Toast that says why an action did nothing, shown in the blocks and read by screen readers.

import * as Blockly from "blockly/core"

export function say(workspace: Blockly.WorkspaceSvg, message: string): void {
  Blockly.Toast.show(workspace, {message, id: "rosy"})
}
