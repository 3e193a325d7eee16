/// Long press by touch: the menu opens only after the movements of the finger that wait for a frame have been handled.
///
/// Blockly opens the menu 750 ms after the finger came down. Browsers deliver movements with the next frame, so on a busy
/// device, for example while the toolbox is drawn, the timer ran out before a movement that happened earlier, and a drag
/// became a menu.

import * as Blockly from "blockly/core"

/// Registers the behaviour for all workspaces, once.
export function registerLongPress(): void {
  const gesture = Blockly.Gesture.prototype
  const {handleRightClick, dispose} = gesture
  const over = new WeakSet<Blockly.Gesture>()
  gesture.dispose = function () {
    over.add(this)
    dispose.call(this)
  }
  gesture.handleRightClick = function (event) {
    if (event.pointerType === "mouse") {
      handleRightClick.call(this, event)
      return
    }
    // The first frame delivers the movements, the second one comes after they have been handled.
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        if (!over.has(this) && !this.isDragging()) handleRightClick.call(this, event)
      }),
    )
  }
}
