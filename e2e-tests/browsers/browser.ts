/// A browser as a story uses it: pointer and key actions of the system kind, what the page shows, and a picture.
///
/// WebDriver and WebDriver BiDi describe actions by the same values (https://www.w3.org/TR/webdriver2/#actions), so that a
/// story is written once; `firefox.ts` and `webkit.ts` carry them to their browsers.

export interface PointerMove {
  readonly type: "pointerMove"
  readonly x: number
  readonly y: number
  /// ms.
  readonly duration: number
}

export type PointerAction =
  | PointerMove
  | {readonly type: "pointerDown" | "pointerUp"; readonly button: number}

export interface KeyAction {
  readonly type: "keyDown" | "keyUp"
  readonly value: string
}

/// The action sequence of one input device.
export type InputSource =
  | {
      readonly type: "pointer"
      readonly id: string
      readonly parameters: {readonly pointerType: "mouse" | "touch"}
      readonly actions: readonly PointerAction[]
    }
  | {readonly type: "key"; readonly id: string; readonly actions: readonly KeyAction[]}

export interface Browser {
  opens(address: string): Promise<void>
  acts(sources: readonly InputSource[]): Promise<void>
  /// Calls a function without free variables in the page. Arguments and result are JSON values.
  asks<A extends readonly unknown[], R>(ask: (...args: A) => R | Promise<R>, ...args: A): Promise<R>
  /// A PNG of the window.
  picture(): Promise<Buffer>
  closes(): Promise<void>
}

/// CSS pixels of the window.
export const windowSize = {width: 1440, height: 900}
