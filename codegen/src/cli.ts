/// The command line of codegen: `to-haskell FILE.rosy` prints the program.
///
/// The only file here that reads files and ends the process.

import {readFileSync} from "node:fs"
import {commands} from "./commands.ts"

const [command = "", ...args] = process.argv.slice(2)
const outcome = commands(command, args, path => readFileSync(path, "utf8"))
if (outcome.out !== "") process.stdout.write(outcome.out)
if (outcome.err !== "") process.stderr.write(`${outcome.err}\n`)
process.exitCode = outcome.status
