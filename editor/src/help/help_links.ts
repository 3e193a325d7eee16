/// Addresses of help pages: an anchor in Rosy's Haddock, which the service serves, or in the page of Prelude names (`prelude_page.ts`). Both are part of Rosy, for
/// classrooms without internet, and so is the guide.

import {homeOf} from "@rosy/codegen"

/// The pages (protocol §4), from the page's own address.
export const apiPage = "api-docs/Rosy.html"
export const preludePage = "prelude.html"
export const guidePage = "guide/"
export const teachersPage = "guide/class.html"
export const studyPage = "guide/study.html"
export const privacyPage = "guide/privacy.html"

/// The address for a name as Haddock's anchors write it (`v:wait`); without one, the beginning of Rosy's page.
export function helpAddress(help: string | undefined): string {
  if (help === undefined) return apiPage
  switch (homeOf(help)) {
    case "rosy":
      return `${apiPage}#${placeOf(help)}`
    case "prelude":
      return `${preludePage}#${placeOf(help)}`
    case "nowhere":
      return apiPage
  }
}

/// Haddock writes every other character of a name as its number between dashes.
export function placeOf(help: string): string {
  const name = help.slice(2).replace(/[^\w']/gu, sign => `-${sign.codePointAt(0)}-`)
  return help.slice(0, 2) + name.replaceAll("'", "-39-")
}
