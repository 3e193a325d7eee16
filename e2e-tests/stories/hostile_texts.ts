/// Texts that would become markup, scripts or addresses where a page takes a text for more than a text, and the watch that finds out if one did.

import type {BrowserContext} from "@playwright/test"

const script = "harmed('script')"

/// One text for each way in. Elements among them have the attribute `data-harm`, addresses the word `harm`.
export const hostileTexts = {
  image: `<img data-harm src=harm.png onerror="${script}">`,
  svg: `<svg data-harm onload="${script}"><script>${script}</script><image href="https://harm.example/a.png"/></svg>`,
  "end of a script": `</script></title></textarea><script data-harm>${script}</script>`,
  "end of a value": `"'><iframe data-harm srcdoc="<script>parent.${script}</script>"></iframe>`,
  handler: `" onmouseover="${script}" onfocus='${script}' autofocus data-harm="`,
  address: `javascript:${script}`,
  "link of Markdown": `[here](javascript:${script}) <https://harm.example/c.png>`,
  "data address": `data:text/html,<script data-harm>${script}</script>`,
  style: `</style><p data-harm style="background: url(https://harm.example/d.png)">`,
  "value of a style": "red; background: url(https://harm.example/e.png)",
  form: `<form data-harm action="https://harm.example/f"><button>Run</button></form>`,
  template: "{{constructor.constructor('harmed()')()}}",
  "bidirectional controls": "abc \u202edcba\u2069\u2066\u200f <b data-harm>",
  "control characters": "a\u0000b\u0007\u001b[31m\u2028<i data-harm>",
  "half a character": "\ud800 <u data-harm>",
}

/// The text without halves of surrogate pairs, which an address and UTF-8 cannot have.
export const wellFormed = (text: string): string => text.replace(/\p{Surrogate}/gu, "\uFFFD")

/// Begins to note what comes of hostile texts in the pages of a context. What the Content Security Policy refuses and other computers are asked for is noted in each
/// story (`own_origin.ts`).
export async function watchHarm(context: BrowserContext): Promise<readonly string[]> {
  const harm: string[] = []
  await context.exposeFunction("harmed", (how: string) => harm.push(`runs a ${how}`))
  await context.addInitScript(() => {
    const report = (how: string) => (window as never as {harmed(how: string): void}).harmed(how)
    const addresses = ["href", "src", "action", "formaction", "xlink:href"]
    const examine = (one: Element) => {
      if (one.hasAttribute("data-harm")) report(`element ${one.tagName}`)
      for (const name of addresses)
        if (/^\s*(javascript|data:text|vbscript)/i.test(one.getAttribute(name) ?? ""))
          report(`address of ${one.tagName}`)
    }
    new MutationObserver(changes => {
      for (const {target, addedNodes} of changes) {
        if (target instanceof Element) examine(target)
        for (const node of addedNodes)
          if (node instanceof Element) for (const one of [node, ...node.querySelectorAll("*")]) examine(one)
      }
    }).observe(document, {subtree: true, childList: true, attributeFilter: ["data-harm", ...addresses]})
  })
  context.on("request", request => {
    // An example's name in an address of the service may be such a text.
    const {hostname, pathname} = new URL(request.url())
    if (hostname === "harm.example" || pathname.endsWith("/harm.png")) harm.push(`asks for ${request.url()}`)
  })
  context.on("dialog", dialog => {
    harm.push(`opens a dialog: ${dialog.message()}`)
    void dialog.dismiss()
  })
  context.on("weberror", error => harm.push(`throws ${error.error().message}`))
  return harm
}
