/// The address in a link to the page.

import {expect, test} from "vitest"
import {linkAddress} from "../../src/browser/link_address.ts"

const here = "http://192.168.1.5:8080/"
const answering = (told: unknown, ok = true) => ({ask: async () => ({ok, json: async () => told})})

test.each([
  ["http://localhost:8080/", [here], here, "network"],
  ["http://127.0.0.1:8080/", [here, "http://10.0.0.2:8080/"], here, "network"],
  ["http://[::1]:8080/rosy/", [here], `${here}rosy/`, "network"],
  ["http://localhost:8080/", [], "http://localhost:8080/", "computer"],
  ["http://localhost:8080/", ["not an address"], "http://localhost:8080/", "computer"],
  ["http://192.168.1.7:8080/", [here], "http://192.168.1.7:8080/", "page"],
  ["https://rosy.example.org/", [here], "https://rosy.example.org/", "page"],
  ["http://localhost.example.org/", [here], "http://localhost.example.org/", "page"],
] as const)("of %s, with %j on the network, is %s", async (page, addresses, expected, reach) => {
  const {ask} = answering({addresses})
  expect(await linkAddress(page, ask)).toEqual({page: expected, reach})
})

test.each([
  ["no answer", async () => Promise.reject(new TypeError("no network"))],
  ["a refusal", answering({}, false).ask],
  ["another answer", answering(null).ask],
  ["addresses that are no list", answering({addresses: here}).ask],
])("%s leaves the address of the page, which leads to this computer alone", async (_, ask) => {
  const page = "http://localhost:8080/"
  expect(await linkAddress(page, ask)).toEqual({page, reach: "computer"})
})
