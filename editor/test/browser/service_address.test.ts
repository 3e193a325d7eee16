/// Addresses of sockets and files: at the page's own service, or at the node where its class is now; and of other pages.

import {expect, test} from "vitest"
import {pageOfClass, serviceAddress, socketAddress} from "../../src/browser/service_address.ts"

const at = (href: string) => ({href})
const answering = (ok: boolean, value: unknown) => {
  const asked: string[] = []
  const ask = async (address: string) => {
    asked.push(address)
    return {ok, json: async () => value}
  }
  return {asked, ask}
}

test("a page without a class of a cluster asks nothing", async () => {
  const {asked, ask} = answering(false, null)
  expect(await socketAddress("api/class", at("http://10.0.0.1:8080/?lang=de#class=bcd"), ask)).toBe(
    "ws://10.0.0.1:8080/api/class",
  )
  expect(await socketAddress("api/session", at("https://rosy.example/"), ask)).toBe(
    "wss://rosy.example/api/session",
  )
  expect(asked).toEqual([])
})

test("a page of a cluster connects to the node of its class", async () => {
  const {asked, ask} = answering(true, {address: "10.0.0.5:8101"})
  const page = at("http://10.0.0.1:8080/?class=7b#class=bcd")
  expect(await socketAddress("api/class", page, ask)).toBe("ws://10.0.0.5:8101/api/class")
  expect(asked).toEqual(["http://10.0.0.1:8080/api/place?class=7b"])
})

test("behind TLS it is the proxy that leads to the node", async () => {
  const {ask} = answering(true, {address: "10.0.0.5:8101"})
  expect(await socketAddress("api/session", at("https://rosy.example/?class=7b"), ask)).toBe(
    "wss://rosy.example/node/10.0.0.5:8101/api/session",
  )
})

test("there is no address while no node has the class, or nothing answers", async () => {
  const page = at("http://10.0.0.1:8080/?class=7b")
  expect(await socketAddress("api/class", page, answering(false, {}).ask)).toBeNull()
  expect(await socketAddress("api/class", page, answering(true, {address: 1}).ask)).toBeNull()
  expect(await socketAddress("api/class", page, () => Promise.reject(new TypeError("no network")))).toBeNull()
})

test("files of a class come from its node, through the proxy behind TLS", async () => {
  const {ask} = answering(true, {address: "10.0.0.5:8101"})
  const file = (page: string) => serviceAddress("api/hand-ins/3", at(page), ask)
  expect(await file("http://10.0.0.1:8080/board.html#key=x")).toBe("http://10.0.0.1:8080/api/hand-ins/3")
  expect(await file("http://10.0.0.1:8080/board.html?class=7b#key=x")).toBe(
    "http://10.0.0.5:8101/api/hand-ins/3",
  )
  expect(await file("https://rosy.example/board.html?class=7b")).toBe(
    "https://rosy.example/node/10.0.0.5:8101/api/hand-ins/3",
  )
})

test("another page of a class names it, too", () => {
  const projector = (page: string) => pageOfClass("./projector.html", at(page)).href
  expect(projector("http://10.0.0.1:8080/board.html?class=7b&lang=de#key=x")).toBe(
    "http://10.0.0.1:8080/projector.html?class=7b",
  )
  expect(projector("http://10.0.0.1:8080/board#key=x")).toBe("http://10.0.0.1:8080/projector.html")
})
