/// Address in links to the page: that of the page, or of this computer on the network where the page's leads to this computer alone.

import type {Reach} from "../state/page_state.ts"
import type {Ask} from "./service_address.ts"

export interface LinkAddress {
  /// Without query and fragment.
  readonly page: string
  readonly reach: Reach
}

/// Host names that lead to the computer itself (RFC 6761, section 6.3; RFC 5735 and 4291 for the addresses).
const isLoopback = (host: string) => /^(localhost|.+\.localhost|127(\.\d+){3}|\[::1\])$/.test(host)

const fetchFresh: Ask = address => fetch(address, {cache: "no-store"})

/// The address for a link to a page at `page`. An unanswered question is as one without an address on the network.
export async function linkAddress(page: string, ask: Ask = fetchFresh): Promise<LinkAddress> {
  const own = new URL(page)
  if (!isLoopback(own.hostname)) return {page, reach: "page"}
  const [first] = await networkAddresses(new URL("api/addresses", page).href, ask)
  if (first === undefined) return {page, reach: "computer"}
  return {page: new URL(own.pathname, first).href, reach: "network"}
}

async function networkAddresses(address: string, ask: Ask): Promise<readonly string[]> {
  try {
    const answer = await ask(address)
    const told: unknown = answer.ok ? await answer.json() : null
    const found = typeof told === "object" && told !== null && "addresses" in told ? told.addresses : null
    return Array.isArray(found) ? found.filter(one => typeof one === "string" && URL.canParse(one)) : []
  } catch {
    return []
  }
}
