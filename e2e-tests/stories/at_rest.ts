/// Waits for elements and values that have come to rest: places are read from two successive frames that agree.
///
/// A pointer presses and drags at coordinates. Coordinates that are read once may belong to a layout that the page has not
/// finished: a toolbox that opens, a pane that is resized, a list that still gets its rows.

import {expect, type Locator, type Page} from "@playwright/test"

export interface Box {
  readonly x: number
  readonly y: number
  readonly width: number
  readonly height: number
}

/// Resolves after the next two animation frames: what was done before is handled and drawn. They come without the pause that `story.ts` makes
/// between frames.
export function drawn(page: Page): Promise<void> {
  return page.evaluate(
    () =>
      new Promise<void>(done => {
        window.dispatchEvent(new Event("story-looks"))
        requestAnimationFrame(() => requestAnimationFrame(() => done()))
      }),
  )
}

/// The box of an element that is visible and has the same place and size in successive frames, in CSS pixels of the page.
export async function boxAtRest(target: Locator): Promise<Box> {
  return atRest(
    target.page(),
    () => target.boundingBox(),
    box => box !== null && box.width > 0 && box.height > 0,
  ) as Promise<Box>
}

/// A value that reads alike before and after two frames, and that is acceptable.
export async function atRest<T>(
  page: Page,
  read: () => Promise<T>,
  accept: (value: T) => boolean = () => true,
): Promise<T> {
  let value = await read()
  await expect
    .poll(
      async () => {
        const before = JSON.stringify(value)
        await drawn(page)
        value = await read()
        return accept(value) && JSON.stringify(value) === before
      },
      {intervals: [0], message: "expected it to come to rest"},
    )
    .toBe(true)
  return value
}
