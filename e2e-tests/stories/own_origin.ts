/// What a page asks of computers other than this one, and what the Content Security Policy refused it: in each story there is nothing of either.

import type {BrowserContext, Page} from "@playwright/test"

const isOwn = (address: string): boolean => {
  const {protocol, hostname} = new URL(address)
  return (
    !["http:", "https:", "ws:", "wss:"].includes(protocol) ||
    ["localhost", "[::1]"].includes(hostname) ||
    hostname.startsWith("127.")
  )
}

let found: string[] = []

/// Begins to note what the pages of a context do.
export function watchOrigins(context: BrowserContext): void {
  const note = (address: string) => {
    if (!isOwn(address)) found.push(`opens ${address}`)
  }
  context.on("request", request => note(request.url()))
  context.on("page", (page: Page) => page.on("websocket", socket => note(socket.url())))
  context.on("console", message => {
    if (message.text().includes("Content Security Policy")) found.push(message.text())
  })
}

/// What was noted since the last call.
export function takeViolations(): readonly string[] {
  const violations = found
  found = []
  return violations
}
