-- |
-- Module      : Main
-- Description : rosy-build: the compiler behind ./rosy build.
--
-- @rosy-build LIBDIR PACKAGE-DB UNITS SCRATCH PROGRAM HOME BINARY static|dynamic@; the units are separated by commas.
-- ./rosy build calls it, after the worker has checked the program.
module Main (main) where

import Rosy.Worker.Ghc.NativeBuild
import System.Environment (getArgs)
import System.Exit (ExitCode (..), die, exitWith)
import System.IO (hPutStrLn, stderr)

main :: IO ()
main = do
  given <- getArgs
  case given of
    [libdir, database, units', scratch', source', home', binary', linking] | linking `elem` ["static", "dynamic"] -> do
      outcome <- compile (BuildRequest libdir database (commas units') scratch' source' home' binary' (linking == "static"))
      case outcome of
        Built -> pure ()
        NotMain name -> die ("This program is called " ++ name ++ ", and only Main can be built. Write in its first line: module Main where")
        NotBuilt -> hPutStrLn stderr "GHC could not build this program." >> exitWith (ExitFailure 2)
    _ -> die "rosy-build LIBDIR PACKAGE-DB UNITS SCRATCH PROGRAM HOME BINARY static|dynamic"

commas :: String -> [String]
commas s = case break (== ',') s of
  (u, _ : rest) -> u : commas rest
  (u, []) -> [u]
