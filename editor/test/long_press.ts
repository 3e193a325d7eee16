/// Fingers that move in time, however busy the machine is: a test's touch becomes no long press before its first movement has arrived.
///
/// Blockly opens a block's menu when a finger has rested for 750 ms. Between a touch and the movement that a test sends right after it, a busy
/// machine may let more time pass than any finger rests.

/// Playwright's page, or another way to call a function in one.
interface Page {
  evaluate(ask: (argument: number) => void, argument: number): Promise<void>
}

/// Blockly's `LONGPRESS`, which it does not export.
const longPress = 750

/// Does what a moving finger does. A long press that begins meanwhile becomes none, unless the finger stays for minutes.
export async function whileFingerMoves(page: Page, move: () => Promise<void>): Promise<void> {
  await page.evaluate(postponeTimers, longPress)
  await move()
  await page.evaluate(restoreTimers, longPress)
}

/// Runs in the page, where Blockly calls the global function.
function postponeTimers(delay: number): void {
  const page = window as typeof window & {postponedTimers?: typeof window.setTimeout}
  const start = window.setTimeout
  page.postponedTimers = start
  page.setTimeout = ((handler: TimerHandler, after?: number, ...more: unknown[]) =>
    start(handler, after === delay ? 600_000 : after, ...more)) as typeof window.setTimeout
}

/// Runs in the page.
function restoreTimers(): void {
  const page = window as typeof window & {postponedTimers?: typeof window.setTimeout}
  if (page.postponedTimers !== undefined) page.setTimeout = page.postponedTimers
}
