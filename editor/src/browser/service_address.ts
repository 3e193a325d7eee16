/// Addresses of the service: its sockets, its files, and its other pages. The address of a page of a cluster names a class
/// (`?class=7b`): such a page asks where its class is before each attempt to connect, and sockets and files are those of
/// that node. Other pages have one service.

/// Answers a request for JSON; fails without a service.
export type Ask = (address: string) => Promise<{ok: boolean; json(): Promise<unknown>}>

type Place = {readonly href: string}

/// The address of a socket as seen from a page at `location`; `null` while no node has the class.
export async function socketAddress(
  path: string,
  location: Place,
  ask: Ask = fetchFresh,
): Promise<string | null> {
  const found = await serviceAddress(path, location, ask)
  return found === null ? null : webSocket(new URL(found))
}

/// The address of another page of the same class.
export function pageOfClass(page: string, location: Place): URL {
  const name = classOf(location)
  const address = new URL(page, location.href)
  if (name !== null) address.searchParams.set("class", name)
  return address
}

const classOf = (location: Place) => new URL(location.href).searchParams.get("class")

const fetchFresh: Ask = address => fetch(address, {cache: "no-store"})

/// The address of a request over HTTP as seen from a page at `location`; `null` while no node has the class.
export async function serviceAddress(
  path: string,
  location: Place,
  ask: Ask = fetchFresh,
): Promise<string | null> {
  const name = classOf(location)
  if (name === null) return new URL(path, location.href).href
  const place = new URL(`api/place?class=${encodeURIComponent(name)}`, location.href)
  place.hash = ""
  try {
    const answer = await ask(place.href)
    const found: unknown = answer.ok ? await answer.json() : null
    const node = typeof found === "object" && found !== null && "address" in found ? found.address : null
    if (typeof node !== "string") return null
    // Behind TLS the proxy leads to the nodes, which have no certificates (docs/district.md).
    const isBehindProxy = place.protocol === "https:"
    return (isBehindProxy ? new URL(`node/${node}/${path}`, location.href) : new URL(path, `http://${node}/`))
      .href
  } catch {
    return null
  }
}

function webSocket(url: URL): string {
  url.protocol = url.protocol === "https:" ? "wss:" : "ws:"
  url.search = ""
  url.hash = ""
  return url.href
}
