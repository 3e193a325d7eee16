/// Where a block's help link goes: to the name in Rosy's Haddock, which the service serves, or in the Prelude's.

import {homeOf} from "@rosy/codegen"

/// The pages (protocol §4), from the page's own address; the Prelude's is the one that GHC's users know.
export const apiPage = "api-docs/Rosy.html"
const preludePage = "https://hackage.haskell.org/package/base/docs/Prelude.html"

/// The address for a name as Haddock's anchors write it (`v:wait`); without one, the beginning of Rosy's page.
export function helpAddress(help: string | undefined): string {
  if (help === undefined) return apiPage
  switch (homeOf(help)) {
    case "rosy":
      return `${apiPage}#${anchor(help)}`
    case "prelude":
      return `${preludePage}#${anchor(help)}`
    case "nowhere":
      return apiPage
  }
}

/// Haddock writes every other character of a name as its number between dashes.
function anchor(help: string): string {
  const name = help.slice(2).replace(/[^\w']/gu, sign => `-${sign.codePointAt(0)}-`)
  return help.slice(0, 2) + name.replaceAll("'", "-39-")
}
