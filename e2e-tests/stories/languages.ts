/// Tags of the languages that the page offers.

import {readFileSync} from "node:fs"
import {join} from "node:path"
import {root} from "./service.ts"

const registered = JSON.parse(readFileSync(join(root, "languages/languages.json"), "utf8")) as Record<
  string,
  string
>

export const languages: readonly string[] = Object.keys(registered)
