/// Addresses of the service's sockets. The address of a page of a cluster names a class (`?class=7b`): such a page asks
/// where its class is before each attempt to connect, and its sockets lead to that node. Other pages have one service.

/// Answers a request for JSON; fails without a service.
export type Ask = (address: string) => Promise<{ok: boolean; json(): Promise<unknown>}>

/// The address of a socket as seen from a page at `location`; `null` while no node has the class.
export async function socketAddress(
  path: string,
  location: {href: string},
  ask: Ask = address => fetch(address, {cache: "no-store"}),
): Promise<string | null> {
  const name = new URL(location.href).searchParams.get("class")
  if (name === null) return webSocket(new URL(path, location.href))
  const place = new URL(`api/place?class=${encodeURIComponent(name)}`, location.href)
  place.hash = ""
  try {
    const answer = await ask(place.href)
    const found: unknown = answer.ok ? await answer.json() : null
    const node = typeof found === "object" && found !== null && "address" in found ? found.address : null
    if (typeof node !== "string") return null
    // Behind TLS the proxy leads to the nodes, which have no certificates (docs/district.md).
    return place.protocol === "https:"
      ? webSocket(new URL(`node/${node}/${path}`, location.href))
      : webSocket(new URL(path, `http://${node}/`))
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
